// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkAdaptiveTransparencyPass.h>
#include <vtkNew.h>

#include <iostream>

int main()
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  pass->SetNodeCount(8);
  std::cout << pass->GetClassName() << " with " << pass->GetNodeCount() << " nodes\n";
  return 0;
}
