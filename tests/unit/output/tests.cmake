starling_test(output_unit unit
  SOURCES unit/output/table_test.cpp unit/output/field_file_test.cpp
          unit/output/run_directory_test.cpp unit/output/checkpoint_test.cpp unit/output/damage_test.cpp
          unit/output/frame_file_test.cpp unit/output/summary_test.cpp
          unit/output/read_table_test.cpp
  DEPENDS starling_output)

# What ParaView's own readers make of the files; skipped where python3-paraview is not installed.
add_executable(write_example_fields unit/output/write_example_fields.cpp)
target_link_libraries(write_example_fields PRIVATE starling_output)
add_test(NAME FieldFile.OpensInParaView
  COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/read_in_paraview.py
          $<TARGET_FILE:write_example_fields>)
set_tests_properties(FieldFile.OpensInParaView PROPERTIES
  LABELS viewer SKIP_RETURN_CODE 77 TIMEOUT 120)
