// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityFunctionPass.h"

#include "vtkTranslucencyOption.h"

VTK_ABI_NAMESPACE_BEGIN
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
  if (vtkTranslucencyOption::Check(this, { this->GetMemoryOption() }, "Memory", memory) && this->Memory != memory)
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
    "variable draws the geometry once and keeps all fragments; fixed takes the same memory for any number of them, and "
    "draws the geometry again",
    [this] { return this->GetMemory(); }, [this](double value) { this->SetMemory(static_cast<int>(value)); } };
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkVisibilityFunctionPass::GetOptions()
{
  std::vector<vtkTranslucencyOption> options = this->Superclass::GetOptions();
  for (vtkTranslucencyOption& option : options)
  {
    option.Help += this->UsesInFixedMemory(option.Name) ? "" : "; used by memory variable only";
  }
  return options;
}

//------------------------------------------------------------------------------
bool vtkVisibilityFunctionPass::UsesInFixedMemory(const std::string&) const
{
  return false;
}

//------------------------------------------------------------------------------
void vtkVisibilityFunctionPass::WarnOfUnusedOptions()
{
  std::string unused;
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    const double value = option.Get();
    if (value != option.Default && !this->UsesInFixedMemory(option.Name))
    {
      unused += (unused.empty() ? "" : ", ") + option.Name + " is " + option.Format(value);
    }
  }
  if (!unused.empty() && unused != this->UnusedOptions)
  {
    const bool chosen = this->Memory == Fixed;
    vtkWarningMacro(<< unused << ", but "
                    << (chosen ? "Memory is Fixed (1), which keeps no fragments: expected Variable (0), or the default"
                               : "the driver has no storage buffers to keep fragments in: expected the default"));
  }
  this->UnusedOptions = unused;
}

//------------------------------------------------------------------------------
bool vtkVisibilityFunctionPass::RenderStages(vtkTranslucencyFrame& frame)
{
  if (this->KeepsFragments())
  {
    return this->Superclass::RenderStages(frame);
  }
  this->WarnOfUnusedOptions();
  return this->RenderFixed(frame);
}
VTK_ABI_NAMESPACE_END
