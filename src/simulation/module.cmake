starling_module(simulation
  SOURCES cycles.cpp estimate.cpp forewarnings.cpp inspect.cpp resume.cpp run.cpp run_files.cpp run_warnings.cpp
          simulation.cpp soundness.cpp steady.cpp stop.cpp time_step.cpp
  DEPENDS starling_config starling_solver starling_output starling_theory fmt::fmt)
