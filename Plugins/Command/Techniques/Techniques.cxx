// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

#include "Basics/Failure.h"
#include "Basics/Specification.h"

#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyPass.h"

#include <algorithm>

namespace
{
std::vector<vtkTranslucencyOption> OptionsOf(vtkRenderPass* pass)
{
  auto* own = vtkTranslucencyPass::SafeDownCast(pass);
  return own ? own->GetOptions() : std::vector<vtkTranslucencyOption>();
}

vtkSmartPointer<vtkRenderPass> NewPass(const std::string& name)
{
  return vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(name));
}

void CheckName(const std::string& name)
{
  std::vector<std::string> known;
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string technique = vtkTranslucencyFactory::GetTechniqueName(i);
    if (technique == name)
    {
      return;
    }
    known.push_back(technique);
  }
  throw Failure("there is no technique '" + name + "', expected one of: " + Listed(known));
}

// The option of that keyword with the value that the text stands for; throws Failure.
std::pair<vtkTranslucencyOption, double> ReadSetting(
  vtkRenderPass* pass, const std::string& technique, const std::string& keyword, const std::string& text)
{
  std::vector<std::string> known;
  for (const vtkTranslucencyOption& option : OptionsOf(pass))
  {
    if (option.Keyword == keyword)
    {
      double value = 0;
      std::string error;
      if (!option.Parse(text, value, error))
      {
        throw Failure("technique '" + technique + "': " + error);
      }
      return { option, value };
    }
    known.push_back(option.Keyword);
  }
  throw Failure("technique '" + technique + "' has no option '" + keyword + "', expected " +
    (known.empty() ? "none: it has no options" : "one of: " + Listed(known)));
}
}

//------------------------------------------------------------------------------
std::vector<TechniqueInfo> ListTechniques()
{
  std::vector<TechniqueInfo> techniques;
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    TechniqueInfo technique;
    technique.Name = vtkTranslucencyFactory::GetTechniqueName(i);
    technique.Help = vtkTranslucencyFactory::GetTechniqueHelp(i);
    const auto pass = NewPass(technique.Name);
    technique.Transmittances = CountTransmittances(pass);
    technique.Options = OptionsOf(pass);
    techniques.push_back(technique);
  }
  return techniques;
}

//------------------------------------------------------------------------------
int CountTransmittances(vtkRenderPass* pass)
{
  auto* technique = vtkTranslucencyPass::SafeDownCast(pass);
  return !technique ? 0 : technique->KeepsTransmissionColors() ? 3 : 1;
}

//------------------------------------------------------------------------------
TechniqueChoice ChooseTechnique(const std::string& text)
{
  const Specification wanted(text);
  CheckName(wanted.Name);
  TechniqueChoice choice;
  choice.Label = wanted.Name;
  choice.Name = wanted.Name;
  for (const auto& setting : wanted.Settings)
  {
    std::string keyword = setting.first;
    std::replace(keyword.begin(), keyword.end(), '-', '_'); // as flags write it
    AddSetting(choice, keyword, setting.second);
  }
  return choice;
}

//------------------------------------------------------------------------------
void AddSetting(TechniqueChoice& choice, const std::string& keyword, const std::string& value)
{
  for (const auto& setting : choice.Settings)
  {
    if (setting.first == keyword)
    {
      throw Failure("'" + keyword + "' is set twice for '" + choice.Label + "', expected once");
    }
  }
  ReadSetting(NewPass(choice.Name), choice.Name, keyword, value);
  choice.Settings.emplace_back(keyword, value);
  choice.Label += ":" + keyword + "=" + value;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> MakePass(const TechniqueChoice& choice)
{
  auto pass = NewPass(choice.Name);
  for (const auto& setting : choice.Settings)
  {
    const auto [option, value] = ReadSetting(pass, choice.Name, setting.first, setting.second);
    option.Set(value);
  }
  return pass;
}

//------------------------------------------------------------------------------
std::string FlagOf(const vtkTranslucencyOption& option)
{
  std::string flag = "--" + option.Keyword;
  std::replace(flag.begin() + 2, flag.end(), '_', '-');
  return flag;
}
