# Replays what the fuzzer has found worth keeping; tools/fuzz runs the fuzzer itself.
foreach(target case frame checkpoint)
  add_executable(replay_${target} fuzz/replay.cpp fuzz/fuzz_${target}.cpp)
  target_link_libraries(replay_${target} PRIVATE starling_output)
  add_test(NAME Fuzz.replays_${target}
    COMMAND replay_${target} ${CMAKE_CURRENT_LIST_DIR}/corpus/${target})
  set_tests_properties(Fuzz.replays_${target} PROPERTIES LABELS unit TIMEOUT 120)
  if(STARLING_SANITIZE MATCHES fuzzer)
    add_executable(fuzz_${target} EXCLUDE_FROM_ALL fuzz/fuzz_${target}.cpp)
    target_link_libraries(fuzz_${target} PRIVATE starling_output)
    target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer)
  endif()
endforeach()
