starling_test(simulation_unit unit
  SOURCES unit/simulation/cycles_test.cpp unit/simulation/steady_test.cpp unit/simulation/stop_test.cpp
          unit/simulation/estimate_test.cpp unit/simulation/time_step_test.cpp
          unit/simulation/collapse_test.cpp unit/simulation/inertia_test.cpp
          unit/simulation/resume_test.cpp unit/simulation/soundness_test.cpp
          unit/simulation/run_warnings_test.cpp unit/simulation/wall_frame_test.cpp
  DEPENDS starling_simulation)
target_include_directories(simulation_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
