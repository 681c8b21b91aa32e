starling_test(flow_verification verification
  SOURCES verification/flow_order_test.cpp
  DEPENDS starling_flow)
target_include_directories(flow_verification PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
