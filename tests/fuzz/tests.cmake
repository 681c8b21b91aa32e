# Replays what the fuzzer has found worth keeping; tools/fuzz runs the fuzzer itself.
foreach(target case frame)
  add_executable(replay_${target} fuzz/replay.cpp fuzz/fuzz_${target}.cpp)
  target_link_libraries(replay_${target} PRIVATE starling_output)
  add_test(NAME Fuzz.replays_${target}
    COMMAND replay_${target} ${CMAKE_CURRENT_LIST_DIR}/corpus/${target})
  set_tests_properties(Fuzz.replays_${target} PROPERTIES LABELS unit TIMEOUT 120)
endforeach()
