# Run by the build (see ShaderTable.cmake): writes HEADER and SOURCE from the files SHADERS of FOLDER.

file(WRITE "${HEADER}" [=[
// Written by WriteShaderTable.cmake.
#ifndef vtkTranslucencyShaderTable_h
#define vtkTranslucencyShaderTable_h

#include <string>

/// The file's text by its path under Shaders, "Common/Frame.glsl"; null if there is none.
const char* vtkTranslucencyShaderTable(const std::string& name);

#endif
]=])

set(rows "")
foreach (shader IN LISTS SHADERS)
  file(READ "${FOLDER}/${shader}" text)
  string(APPEND rows "  { \"${shader}\", R\"GLSL(${text})GLSL\" },\n")
endforeach ()

file(WRITE "${SOURCE}" "// Written by WriteShaderTable.cmake.
#include \"vtkTranslucencyShaderTable.h\"

namespace
{
struct Shader
{
  const char* Name;
  const char* Text;
};

const Shader Shaders[] = {
${rows}};
}

const char* vtkTranslucencyShaderTable(const std::string& name)
{
  for (const Shader& shader : Shaders)
  {
    if (name == shader.Name)
    {
      return shader.Text;
    }
  }
  return nullptr;
}
")
