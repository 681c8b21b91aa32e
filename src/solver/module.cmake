starling_module(solver
  SOURCES advance.cpp cycle.cpp monitor.cpp power_balance.cpp snapshot.cpp
  DEPENDS starling_immersed_boundary)
