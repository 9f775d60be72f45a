# Shader files carried inside a library.
#
#   translucency_shader_table(FOLDER <folder> SHADERS <path>... SOURCE_OUTPUT <variable> HEADER_OUTPUT <variable>)
#
# Makes a source and a header of the function that gives a file's text by its path below the folder, and makes them anew when
# a file changes. A .glsl file of the folder that is not listed is an error: it would be missed only when a program runs.

function (translucency_shader_table)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "FOLDER;SOURCE_OUTPUT;HEADER_OUTPUT" "SHADERS")

  file(GLOB_RECURSE present RELATIVE "${arg_FOLDER}" CONFIGURE_DEPENDS "${arg_FOLDER}/*.glsl")
  set(unlisted ${present})
  list(REMOVE_ITEM unlisted ${arg_SHADERS})
  set(missing ${arg_SHADERS})
  list(REMOVE_ITEM missing ${present})
  if (unlisted OR missing)
    message(FATAL_ERROR "The shader table in ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt does not list what is in "
      "${arg_FOLDER}; not listed: [${unlisted}], listed but not there: [${missing}]")
  endif ()

  set(script "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/WriteShaderTable.cmake")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/vtkTranslucencyShaderTable.cxx")
  set(header "${CMAKE_CURRENT_BINARY_DIR}/vtkTranslucencyShaderTable.h")
  set(files ${arg_SHADERS})
  list(TRANSFORM files PREPEND "${arg_FOLDER}/")
  add_custom_command(
    OUTPUT "${source}" "${header}"
    DEPENDS "${script}" ${files}
    COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${arg_FOLDER}" "-DSHADERS=${arg_SHADERS}" "-DSOURCE=${source}"
      "-DHEADER=${header}" -P "${script}"
    COMMENT "Writing the shader table"
    VERBATIM)

  set("${arg_SOURCE_OUTPUT}" "${source}" PARENT_SCOPE)
  set("${arg_HEADER_OUTPUT}" "${header}" PARENT_SCOPE)
endfunction ()
