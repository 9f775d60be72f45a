# The layout of a wheel: one folder, vtktranslucency, which lies beside that of VTK's own wheel and finds VTK's libraries there.
# Included where scikit-build-core configures (pyproject.toml), after VTK_PYTHON_PACKAGE is known.

set(TRANSLUCENCY_PYTHON_DESTINATION ".")
set(CMAKE_INSTALL_LIBDIR vtktranslucency)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# Nothing of the machine that builds is looked for on the machine that runs.
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${VTK_PYTHON_PACKAGE}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH OFF)
