starling_module(theory
  SOURCES block_tridiagonal.cpp boundary_layer.cpp buckling.cpp buckling_report.cpp clamped_membrane.cpp
          elastic_ring.cpp laws_of_laplace.cpp mode_stiffness.cpp one_dimensional.cpp
          report_text.cpp theory_report.cpp tube_problem.cpp tube_waves.cpp
          wave_speed.cpp
  DEPENDS starling_core starling_wall starling_config fmt::fmt)
