starling_module(solver
  SOURCES advance.cpp monitor.cpp
  DEPENDS starling_immersed_boundary)
