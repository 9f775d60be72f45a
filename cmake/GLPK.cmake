# GLPK, which has no CMake package: GLPK::GLPK.
find_path(GLPK_INCLUDE_DIR glpk.h)
find_library(GLPK_LIBRARY glpk)
if (NOT GLPK_INCLUDE_DIR OR NOT GLPK_LIBRARY)
  message(FATAL_ERROR "The tests need GLPK (Debian's package libglpk-dev), and there is no glpk.h, or no library glpk. Set "
    "GLPK_INCLUDE_DIR and GLPK_LIBRARY to where they are, or BUILD_TESTING to OFF.")
endif ()
mark_as_advanced(GLPK_INCLUDE_DIR GLPK_LIBRARY)
add_library(GLPK::GLPK UNKNOWN IMPORTED)
set_target_properties(GLPK::GLPK PROPERTIES
  IMPORTED_LOCATION "${GLPK_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${GLPK_INCLUDE_DIR}")
