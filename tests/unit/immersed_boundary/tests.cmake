starling_test(immersed_boundary_unit unit
  SOURCES unit/immersed_boundary/delta_test.cpp unit/immersed_boundary/transfer_test.cpp
          unit/immersed_boundary/axial_guide_test.cpp
          unit/immersed_boundary/intercept_search_test.cpp
          unit/immersed_boundary/ghost_nodes_test.cpp unit/immersed_boundary/section_flow_test.cpp
          unit/immersed_boundary/coupling_test.cpp
  DEPENDS starling_immersed_boundary)
target_include_directories(immersed_boundary_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
