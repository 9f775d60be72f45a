// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkABufferPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkABufferPass);

//------------------------------------------------------------------------------
void vtkABufferPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolve: " << (this->Resolve == Iterative ? "Iterative" : "Recursive") << "\n";
}

//------------------------------------------------------------------------------
void vtkABufferPass::SetResolve(int resolve)
{
  vtkTranslucencyOption::SetProperty(this, vtkABufferPass::GetOptions(), "Resolve", this->Resolve, resolve);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkABufferPass::GetOptions()
{
  std::vector<vtkTranslucencyOption> options{ { "Resolve", "resolve", vtkTranslucencyOption::Kind::Choice, Recursive, 0,
    1, { "recursive", "iterative" },
    "recursive sorts a pixel's fragments and blends them; iterative weights each with all in front of it, without "
    "sorting, and is slower for deep pixels",
    [this] { return this->GetResolve(); }, [this](double value) { this->SetResolve(static_cast<int>(value)); } } };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
bool vtkABufferPass::ResolveLists(vtkTranslucencyFrame& frame)
{
  if (this->Resolve == Iterative)
  {
    return frame.Resolve("ABuffer/Iterative.glsl", { { "UNFINISHED_LEVEL", LevelText(Long) } }, {}) &&
      this->ResolveLeftLists(frame);
  }
  vtkTranslucencyFrame::Squares rest;
  if (!this->ResolveShortLists(frame, VTK_INT_MAX, Runs, rest))
  {
    return false;
  }
  return (!frame.IsLeftTo(rest) ||
           (frame.PrepareSorting() &&
             frame.Resolve("ABuffer/ResolveRuns.glsl", { { "LONGER_LEVEL", LevelText(Long) } }, rest))) &&
    this->ResolveLeftLists(frame);
}
VTK_ABI_NAMESPACE_END
