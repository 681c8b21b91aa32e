starling_test(theory_unit unit
  SOURCES unit/theory/block_tridiagonal_test.cpp unit/theory/boundary_layer_test.cpp
          unit/theory/buckling_test.cpp
          unit/theory/buckling_report_test.cpp
          unit/theory/elastic_ring_test.cpp unit/theory/laws_of_laplace_test.cpp
          unit/theory/mode_stiffness_test.cpp unit/theory/one_dimensional_test.cpp
          unit/theory/theory_report_test.cpp unit/theory/tube_waves_test.cpp
          unit/theory/wave_speed_test.cpp
  DEPENDS starling_theory)
