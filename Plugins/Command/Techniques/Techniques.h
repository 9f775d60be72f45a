// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Techniques as the command line names them: "adaptive", "adaptive:nodes=8:removal=mixed".
 */
#ifndef Techniques_h
#define Techniques_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucencyOption.h"

#include <string>
#include <utility>
#include <vector>

struct TechniqueInfo
{
  std::string Name;
  std::string Help;
  int Transmittances = 0;                     ///< with its defaults, see CountTransmittances
  std::vector<vtkTranslucencyOption> Options; ///< the declarations; Get and Set may not be called
};

/// A technique with the options that were asked for.
struct TechniqueChoice
{
  std::string Label; ///< as it was written, to tell variants of one technique apart
  std::string Name;
  std::vector<std::pair<std::string, std::string>> Settings; ///< keyword and value
};

/// All techniques that the library has.
std::vector<TechniqueInfo> ListTechniques();

/// Reads a technique as the command line names it; throws Failure if there is none of that name, it has no such
/// option, or a value is out of range.
TechniqueChoice ChooseTechnique(const std::string& text);

/// Adds an option, with the same checks.
void AddSetting(TechniqueChoice& choice, const std::string& keyword, const std::string& value);

/// A new pass of the technique with its options set.
vtkSmartPointer<vtkRenderPass> MakePass(const TechniqueChoice& choice);

/// How many transmittances a technique keeps where there are transmission colours: 3, 1 for their mean, 0 if it ignores
/// them.
int CountTransmittances(vtkRenderPass* pass);

/// "memory_limit" as a flag: "--memory-limit".
std::string FlagOf(const vtkTranslucencyOption& option);

#endif
