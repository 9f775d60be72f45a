# Finds Python's interpreter and headers, VTK's wrapping tools, and what VTK's own Python package is called:
#   VTK_PYTHON_PACKAGE  vtkmodules, or the name that another distribution of VTK has given it (cvista)
#
# VTK's Python modules are made for one interpreter, the one installed beside VTK; the first python3 on PATH may well be
# another. So the former is taken, unless Python3_EXECUTABLE was given, before VTK looks for Python's headers. A wheel is
# built by the interpreter that was asked to, against VTK's development files without an installed VTK (cmake/Wheel.cmake).

find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore)

if (NOT Python3_EXECUTABLE)
  find_program(python_of_vtk python3 PATHS "${VTK_PREFIX_PATH}/bin" NO_DEFAULT_PATH NO_CACHE)
  if (python_of_vtk)
    set(Python3_EXECUTABLE "${python_of_vtk}" CACHE FILEPATH "The interpreter that VTK's Python modules are made for")
  endif ()
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)

find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore Python WrappingPythonCore)
get_property(VTK_PYTHON_PACKAGE TARGET VTK::CommonCore PROPERTY INTERFACE_vtk_module_python_package)

if (NOT SKBUILD)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -c
      "from ${VTK_PYTHON_PACKAGE}.vtkCommonCore import vtkVersion; print(vtkVersion.GetVTKVersion())"
    OUTPUT_VARIABLE version_in_python
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_VARIABLE error)
  if (NOT version_in_python STREQUAL VTK_VERSION)
    message(FATAL_ERROR "${Python3_EXECUTABLE} has no modules of VTK ${VTK_VERSION} (Debian's package python3-vtk9). Set "
      "Python3_EXECUTABLE to an interpreter that has, or TRANSLUCENCY_WRAP_PYTHON to OFF.\n${error}")
  endif ()
endif ()
