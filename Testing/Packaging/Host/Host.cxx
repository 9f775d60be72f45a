// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkTranslucencyFactory.h>

#include <iostream>

int main()
{
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    std::cout << vtkTranslucencyFactory::GetTechniqueName(i) << ": " << vtkTranslucencyFactory::GetTechniqueHelp(i)
              << '\n';
  }
  return 0;
}
