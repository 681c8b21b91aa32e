starling_module(config
  SOURCES
    case_keys.cpp
    case_values.cpp
    document.cpp
    input_file.cpp
    nearest_name.cpp
    quantities.cpp
    read_along_x.cpp
    read_case.cpp
    read_columns.cpp
    read_drive.cpp
    read_scaling.cpp
    read_wall.cpp
    read_waveform.cpp
    scaling.cpp
    shipped_cases.cpp
    units.cpp
    validate.cpp
    value_check.cpp
    write_case.cpp
  DEPENDS starling_core)
target_link_libraries(starling_config PRIVATE fmt::fmt tomlplusplus::tomlplusplus)

# The shipped cases travel inside the program, so that `starling cases NAME` works anywhere.
set(shipped_case_entries "")
foreach(name inflation inflation_neo_hookean rigid_tube stenosis womersley carotid microchannel_si
        pressure_wave oscillation_damped oscillation_sustained
        collapse_mode2 collapse_mode3 collapse_mode4 collapse_mode5 collapse_mode6 collapse_mode8
        tube_law starling_resistor)
  set(file ${PROJECT_SOURCE_DIR}/cases/${name}.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(APPEND shipped_case_entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
configure_file(config/shipped_case_texts.hpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/include/config/shipped_case_texts.hpp @ONLY)
target_include_directories(starling_config PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/include)
