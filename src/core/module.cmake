starling_module(core SOURCES error.cpp DEPENDS OpenMP::OpenMP_CXX)
