starling_test(flow_verification verification
  SOURCES verification/flow_order_test.cpp
  DEPENDS starling_flow)
target_include_directories(flow_verification PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
starling_test(wall_verification verification
  SOURCES verification/wall_stiffness_test.cpp
  DEPENDS starling_theory starling_wall)
