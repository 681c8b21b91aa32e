starling_test(flow_verification verification
  SOURCES verification/flow_order_test.cpp
  DEPENDS starling_flow)
target_include_directories(flow_verification PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
starling_test(wall_verification verification
  SOURCES verification/wall_stiffness_test.cpp
  DEPENDS starling_theory starling_wall)
starling_test(coupling_verification verification
  SOURCES verification/closed_volume_test.cpp
  DEPENDS starling_immersed_boundary)
starling_test(buckling_verification verification
  SOURCES verification/buckling_onset_test.cpp
  DEPENDS starling_simulation starling_theory)
starling_test(wall_shear_verification verification
  SOURCES verification/wall_shear_test.cpp
  DEPENDS starling_simulation)
starling_test(along_x_verification verification
  SOURCES verification/along_x_test.cpp
  DEPENDS starling_simulation starling_theory)

# The independent reference of the clamped tube, one test per class of the script.
foreach(subject Poiseuille StokesFlowInACone Inertia Wall Coupled Tool)
  add_test(NAME AxisymmetricTube.${subject}
    COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/axisymmetric_tube_test.py
            $<TARGET_FILE:starling> ${subject})
  set_tests_properties(AxisymmetricTube.${subject} PROPERTIES LABELS verification TIMEOUT 300)
endforeach()
