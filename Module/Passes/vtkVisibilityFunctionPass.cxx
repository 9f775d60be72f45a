#include "vtkVisibilityFunctionPass.h"

#include "vtkTranslucencyOption.h"

namespace
{
const char* const Memories[] = { "Variable", "Fixed" };
}

//------------------------------------------------------------------------------
void vtkVisibilityFunctionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Memory: " << Memories[this->Memory] << "\n";
}

//------------------------------------------------------------------------------
void vtkVisibilityFunctionPass::SetMemory(int memory)
{
  if (memory != Variable && memory != Fixed)
  {
    vtkErrorMacro(<< "Memory is " << memory << ", expected Variable (0) or Fixed (1)");
    return;
  }
  if (this->Memory != memory)
  {
    this->ReleaseGraphicsResources(nullptr); // what the other one holds
    this->Memory = memory;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyOption vtkVisibilityFunctionPass::GetMemoryOption()
{
  return { "Memory", "memory", vtkTranslucencyOption::Kind::Choice, Variable, 0, 1, { "variable", "fixed" },
    "variable draws the geometry once and keeps all fragments; fixed takes the same memory for any number of them, and draws the geometry again",
    [this] { return this->GetMemory(); }, [this](double value) { this->SetMemory(static_cast<int>(value)); } };
}

//------------------------------------------------------------------------------
bool vtkVisibilityFunctionPass::RenderStages(vtkTranslucencyFrame& frame)
{
  return this->Memory == Fixed ? this->RenderFixed(frame) : this->Superclass::RenderStages(frame);
}
