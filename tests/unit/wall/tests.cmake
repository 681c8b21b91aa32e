starling_test(wall_unit unit
  SOURCES unit/wall/along_x_test.cpp unit/wall/materials_test.cpp unit/wall/wall_mesh_test.cpp unit/wall/tube_test.cpp
          unit/wall/geometry_test.cpp unit/wall/cross_section_test.cpp
          unit/wall/elastic_force_test.cpp unit/wall/mesh_filter_test.cpp unit/wall/high_pass_test.cpp
          unit/wall/rigid_support_test.cpp
          unit/wall/curvature_test.cpp unit/wall/bending_force_test.cpp
          unit/wall/perturbation_test.cpp unit/wall/smoothing_test.cpp
          unit/wall/lumen_test.cpp unit/wall/contact_test.cpp unit/wall/tissue_test.cpp
          unit/wall/membrane_viscosity_test.cpp
  DEPENDS starling_wall)
target_include_directories(wall_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
