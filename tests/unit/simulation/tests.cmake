starling_test(simulation_unit unit
  SOURCES unit/simulation/steady_test.cpp unit/simulation/stop_test.cpp
          unit/simulation/estimate_test.cpp unit/simulation/time_step_test.cpp
          unit/simulation/collapse_test.cpp
  DEPENDS starling_simulation)
