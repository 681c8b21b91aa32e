starling_module(simulation
  SOURCES estimate.cpp run.cpp simulation.cpp steady.cpp stop.cpp time_step.cpp
  DEPENDS starling_config starling_solver starling_output starling_theory fmt::fmt)
