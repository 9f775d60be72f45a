# Shader files carried inside a library.
#
#   translucency_shader_table(FOLDER <folder> SOURCE_OUTPUT <variable> HEADER_OUTPUT <variable>)
#
# Makes a source and a header of the function that gives the text of a .glsl file by its path below the folder, and makes them
# anew when a file changes, comes or goes: a new technique's folder is found.

function (translucency_shader_table)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "FOLDER;SOURCE_OUTPUT;HEADER_OUTPUT" "")

  file(GLOB_RECURSE shaders RELATIVE "${arg_FOLDER}" CONFIGURE_DEPENDS "${arg_FOLDER}/*.glsl")

  set(script "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/WriteShaderTable.cmake")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/vtkTranslucencyShaderTable.cxx")
  set(header "${CMAKE_CURRENT_BINARY_DIR}/vtkTranslucencyShaderTable.h")
  set(files ${shaders})
  list(TRANSFORM files PREPEND "${arg_FOLDER}/")
  add_custom_command(
    OUTPUT "${source}" "${header}"
    DEPENDS "${script}" ${files}
    COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${arg_FOLDER}" "-DSHADERS=${shaders}" "-DSOURCE=${source}"
      "-DHEADER=${header}" -P "${script}"
    COMMENT "Writing the shader table"
    VERBATIM)

  set("${arg_SOURCE_OUTPUT}" "${source}" PARENT_SCOPE)
  set("${arg_HEADER_OUTPUT}" "${header}" PARENT_SCOPE)
endfunction ()
