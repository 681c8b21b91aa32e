starling_module(wall
  SOURCES materials.cpp wall_mesh.cpp tube.cpp geometry.cpp cross_section.cpp elastic_force.cpp mesh_filter.cpp
  DEPENDS starling_core)
