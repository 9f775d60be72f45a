# Run by the build of tests: writes the files SHADERS of FOLDER to DESTINATION as C++ with GLM, for Testing/Cxx/ShaderAsCxx.h.
#
# What is rewritten is what C++ spells differently, and nothing else: storage and uniform blocks become variables, a block's
# array of no length Words; out parameters references; constructors of structures construct<>; swizzles calls; numbers with a
# point floats. Lines stay where they are: what a sanitizer reports has the shader's own file and line.

set(structures "")
foreach (shader IN LISTS SHADERS)
  file(READ "${FOLDER}/${shader}" text)
  string(REGEX MATCHALL "\nstruct [A-Za-z]+" found "${text}")
  list(APPEND structures ${found})
endforeach ()
list(REMOVE_DUPLICATES structures)
string(REGEX REPLACE "\nstruct " "" structures "${structures}")
string(REPLACE ";" "|" structures "${structures}")

foreach (shader IN LISTS SHADERS)
  file(READ "${FOLDER}/${shader}" text)
  string(REGEX REPLACE "layout\\([^)]*\\) in;" "" text "${text}")
  string(REGEX REPLACE "layout\\([^)]*\\)[A-Za-z_ ]*\n{([^}]*)};" "\n\\1" text "${text}")
  string(REGEX REPLACE "(uint|uvec2|uvec4) ([A-Za-z]+)\\[\\];" "Words<\\1> \\2;" text "${text}")
  string(REGEX REPLACE "\nuniform " "\n" text "${text}")
  string(REGEX REPLACE "(inout|out) ([A-Za-z0-9]+) ([A-Za-z]+)([,)])" "\\2& \\3\\4" text "${text}")
  string(REGEX REPLACE "([^A-Za-z0-9_])(${structures})\\(" "\\1construct<\\2>(" text "${text}")
  string(REGEX REPLACE "\\.([xyzw][xyzw]+|[rgba][rgba]+)([^A-Za-z0-9_(])" ".\\1()\\2" text "${text}")
  string(REGEX REPLACE "([0-9]\\.[0-9]+)([^0-9ef])" "\\1f\\2" text "${text}")
  string(REGEX REPLACE "([^A-Za-z0-9_.])([0-9]+e-?[0-9]+)([^0-9f])" "\\1\\2f\\3" text "${text}")
  file(WRITE "${DESTINATION}/${shader}" "#line 1 \"${FOLDER}/${shader}\"\n${text}")
endforeach ()
