# Writes OUTPUT, a header that defines STARLING_RELEASE and STARLING_GIT_REVISION; touches it only
# when it changes, so that a build after a commit recompiles one file.
# cmake -DSOURCE=<checkout> -DRELEASE=<version> -DOUTPUT=<file> -P git_revision.cmake
execute_process(
  COMMAND git -C ${SOURCE} describe --always --abbrev=12 --exclude=* --dirty=+
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
  "#define STARLING_RELEASE std::string(\"${RELEASE}\")\n#define STARLING_GIT_REVISION \"${revision}\"\n")
