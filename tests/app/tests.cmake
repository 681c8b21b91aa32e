# The program as a user meets it; one test per scenario of the script.
foreach(scenario help version usage bad_case cases check_and_theory run refusal interrupt
        numerical_error numerical_error_in_si breakdown_keeps_checkpoints end_time warnings too_large out_of_memory resume resume_ended resume_after_wall_clock files_of_the_user resume_anywhere resume_damaged resume_beside_damage kill kill_at_the_end flushed set_scale
        full_disk full_disk_at_the_end directory_lost read_only fluid_region info info_damaged info_while_running export threads plot si_units
        bench bench_refusal compare_bench)
  add_test(NAME App.${scenario}
    COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/test_app.py
            $<TARGET_FILE:starling> ${PROJECT_SOURCE_DIR} ${scenario})
  set_tests_properties(App.${scenario} PROPERTIES LABELS app TIMEOUT 300 SKIP_RETURN_CODE 77)
endforeach()

# The page of `starling report`, opened in headless Chromium; skipped where that is not installed.
foreach(scenario page flow collapse si breakdown unfinished no_webgl)
  add_test(NAME Report.${scenario}
    COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/test_report.py
            $<TARGET_FILE:starling> ${PROJECT_SOURCE_DIR} ${scenario})
  set_tests_properties(Report.${scenario} PROPERTIES LABELS app TIMEOUT 300 SKIP_RETURN_CODE 77)
endforeach()
