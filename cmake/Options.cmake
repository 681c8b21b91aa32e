# Compiler flags shared by every target: link to starling_options.
add_library(starling_options INTERFACE)
target_compile_options(starling_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  $<$<BOOL:${STARLING_WARNINGS_AS_ERRORS}>:-Werror>
  # g++ 12 reports overlapping copies in std::string operators that do not exist (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Contraction into fused multiply-adds is kept the same everywhere; nothing that reorders sums.
  -fno-math-errno -fno-trapping-math
  $<$<BOOL:${STARLING_NATIVE}>:-march=native>)
if(STARLING_SANITIZE)
  target_compile_options(starling_options INTERFACE
    -fsanitize=${STARLING_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(starling_options INTERFACE -fsanitize=${STARLING_SANITIZE})
endif()
target_include_directories(starling_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
