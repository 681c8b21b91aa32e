starling_module(output
  SOURCES table.cpp series.cpp profile.cpp sections.cpp hdf5_file.cpp xdmf.cpp replace_file.cpp
          field_file.cpp frame_file.cpp sealed_file.cpp export.cpp read_table.cpp run_directory.cpp summary.cpp version.cpp crc64.cpp checkpoint.cpp
  DEPENDS starling_core starling_config starling_solver fmt::fmt nlohmann_json::nlohmann_json
          starling_hdf5)

# Only what the C interface needs; the imported target drags in flags for other languages.
add_library(starling_hdf5 INTERFACE)
target_include_directories(starling_hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
target_link_libraries(starling_hdf5 INTERFACE ${HDF5_C_LIBRARIES})

# The revision may change without any source file changing, so it is looked up at every build.
set(revision_header ${CMAKE_CURRENT_BINARY_DIR}/generated/starling_git_revision.hpp)
add_custom_target(starling_git_revision
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DRELEASE=${PROJECT_VERSION}
          -DOUTPUT=${revision_header} -P ${PROJECT_SOURCE_DIR}/tools/git_revision.cmake
  BYPRODUCTS ${revision_header} VERBATIM)
add_dependencies(starling_output starling_git_revision)
target_include_directories(starling_output PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
