starling_test(bench_unit unit SOURCES unit/bench/bench_test.cpp DEPENDS starling_bench)
if(NOT STARLING_SANITIZE)
  starling_test(bench_footprint_unit unit SOURCES unit/bench/footprint_test.cpp
    DEPENDS starling_bench)
endif()
