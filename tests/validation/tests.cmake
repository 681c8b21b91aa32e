# Coarse runs against theory; tools/validate makes the fine ones.
foreach(scenario rigid inflation start womersley pressure_wave oscillation laws ring tool)
  add_test(NAME Validation.${scenario}
    COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/test_validation.py
            $<TARGET_FILE:starling> ${scenario})
  set_tests_properties(Validation.${scenario} PROPERTIES LABELS validation TIMEOUT 300)
endforeach()
