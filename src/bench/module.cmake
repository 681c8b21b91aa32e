starling_module(bench
  SOURCES bandwidth.cpp bench.cpp bench_json.cpp bench_text.cpp stepped_problem.cpp traffic.cpp
  DEPENDS starling_simulation fmt::fmt nlohmann_json::nlohmann_json)
