starling_module(immersed_boundary
  SOURCES transfer.cpp axial_guide.cpp wall_pressure_force.cpp intercept_search.cpp ghost_nodes.cpp coupling.cpp section_flow.cpp
  DEPENDS starling_flow starling_wall)
