starling_test(grid_unit unit
  SOURCES unit/grid/array_test.cpp unit/grid/grid_test.cpp unit/grid/boundary_test.cpp
          unit/grid/stencils_test.cpp
  DEPENDS starling_grid)
target_include_directories(grid_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
