starling_test(flow_unit unit
  SOURCES unit/flow/tridiagonal_test.cpp unit/flow/periodic_lines_test.cpp
          unit/flow/cosine_transform_test.cpp
          unit/flow/diffusion_line_test.cpp unit/flow/poisson_test.cpp unit/flow/momentum_test.cpp
          unit/flow/projection_test.cpp unit/flow/fluid_step_test.cpp
          unit/flow/ends_test.cpp unit/flow/waveform_test.cpp
  DEPENDS starling_flow)
target_include_directories(flow_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
