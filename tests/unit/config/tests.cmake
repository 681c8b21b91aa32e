starling_test(test_config unit
  SOURCES
    unit/config/along_x_test.cpp
    unit/config/bad_cases_test.cpp
    unit/config/case_keys_test.cpp
    unit/config/fuzz_test.cpp
    unit/config/nearest_name_test.cpp
    unit/config/read_case_test.cpp
    unit/config/scaling_test.cpp
    unit/config/shipped_cases_test.cpp
    unit/config/units_test.cpp
    unit/config/write_case_test.cpp
  DEPENDS starling_config starling_flow)
target_link_libraries(test_config PRIVATE fmt::fmt)
target_compile_definitions(test_config PRIVATE STARLING_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
