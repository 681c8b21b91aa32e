starling_module(solver
  SOURCES advance.cpp monitor.cpp snapshot.cpp
  DEPENDS starling_immersed_boundary)
