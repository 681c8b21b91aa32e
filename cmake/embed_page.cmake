# cmake -DINPUT=... -DOUTPUT=... -P embed_page.cmake: the page as a C++ source.
file(READ ${INPUT} page)
string(FIND "${page}" ")starling-page\"" end)
if(NOT end EQUAL -1)
  message(FATAL_ERROR "${INPUT} holds the end of the literal that it would be embedded in")
endif()
file(WRITE ${OUTPUT} "#include \"report/page_template.hpp\"

namespace starling::report {

const std::string_view page_template = R\"starling-page(${page})starling-page\";

} // namespace starling::report
")
