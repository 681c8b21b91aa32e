starling_test(report_unit unit
  SOURCES unit/report/packed_test.cpp unit/report/flow_plane_test.cpp
          unit/report/page_data_test.cpp
  DEPENDS starling_report)
target_include_directories(report_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/unit/output)
