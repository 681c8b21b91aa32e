starling_module(flow
  SOURCES periodic_lines.cpp cosine_transform.cpp momentum.cpp poisson.cpp projection.cpp
          drive.cpp ends.cpp waveform.cpp
  DEPENDS starling_grid starling_parallel PkgConfig::FFTW3)
