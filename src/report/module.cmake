starling_module(report
  SOURCES case_data.cpp flow_data.cpp flow_plane.cpp packed.cpp result_data.cpp rings.cpp
          table_data.cpp wall_data.cpp write_report.cpp
  DEPENDS starling_config starling_output starling_theory starling_simulation fmt::fmt
          nlohmann_json::nlohmann_json)

# The page is bundled from web/ and carried inside the program. Where that fails the program is
# built without it and says so when it is asked for a report; configuring again tries again.
find_program(STARLING_NPM npm)
find_program(STARLING_NODE node)
set(web ${PROJECT_SOURCE_DIR}/web)
set(page ${PROJECT_BINARY_DIR}/web/page.html)
if(EXISTS ${page})
  file(SIZE ${page} page_size)
  if(page_size EQUAL 0)
    file(REMOVE ${page})
  endif()
endif()
include(${web}/sources.cmake)
list(TRANSFORM web_sources PREPEND ${web}/)
add_custom_command(OUTPUT ${page}
  COMMAND ${CMAKE_COMMAND} -DNPM=${STARLING_NPM} -DNODE=${STARLING_NODE} -DWEB=${web}
          -DOUTPUT=${page} -P ${PROJECT_SOURCE_DIR}/cmake/bundle_page.cmake
  DEPENDS ${web_sources} ${PROJECT_SOURCE_DIR}/cmake/bundle_page.cmake
  COMMENT "Bundling the page of reports" VERBATIM)
set(page_source ${CMAKE_CURRENT_BINARY_DIR}/generated/page_template.cpp)
add_custom_command(OUTPUT ${page_source}
  COMMAND ${CMAKE_COMMAND} -DINPUT=${page} -DOUTPUT=${page_source}
          -P ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake
  DEPENDS ${page} ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake VERBATIM)
target_sources(starling_report PRIVATE ${page_source})
