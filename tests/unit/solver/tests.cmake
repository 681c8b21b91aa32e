starling_test(solver_unit unit
  SOURCES unit/solver/advance_test.cpp unit/solver/monitor_test.cpp
    unit/solver/power_balance_test.cpp unit/solver/snapshot_test.cpp
  DEPENDS starling_solver)
target_include_directories(solver_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
if(NOT STARLING_SANITIZE)
  starling_test(solver_allocation_unit unit SOURCES unit/solver/allocation_test.cpp
    DEPENDS starling_solver)
  target_include_directories(solver_allocation_unit PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
endif()
