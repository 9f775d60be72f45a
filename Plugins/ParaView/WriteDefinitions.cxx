// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// WriteDefinitions FILE: what ParaView's server manager has to know of the plugin, as XML. Techniques come from
// vtkTranslucencyFactory, and options from the passes, so that one that is added there is here, too.
//
// The properties are those of a proxy of its own, which RenderView has as a sub-proxy and exposes: views that follow
// RenderView (eye-dome lighting, slices) have them as well, and no class of ParaView is replaced.

#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyOption.h"
#include "vtkTranslucencyPass.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"

#include <cctype>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Element = vtkSmartPointer<vtkXMLDataElement>;
using Attributes = std::vector<std::pair<const char*, std::string>>;

const std::string Group = "translucency";
const std::string Prefix = "Translucency";

Element Add(vtkXMLDataElement* parent, const std::string& name, const Attributes& attributes = {})
{
  auto element = Element::New();
  element->SetName(name.c_str());
  for (const auto& attribute : attributes)
  {
    element->SetAttribute(attribute.first, attribute.second.c_str());
  }
  if (parent)
  {
    parent->AddNestedElement(element);
  }
  return element;
}

void AddDocumentation(vtkXMLDataElement* property, const std::string& text)
{
  const std::string data = text + ".";
  Add(property, "Documentation")->SetCharacterData(data.c_str(), static_cast<int>(data.size()));
}

// "memory_limit", "vtk-oit": "MemoryLimit", "VtkOit".
std::string ToCamelCase(const std::string& keyword)
{
  std::string result;
  bool begins = true;
  for (const char c : keyword)
  {
    const bool separates = c == '_' || c == '-';
    if (!separates)
    {
      result += begins ? static_cast<char>(std::toupper(c)) : c;
    }
    begins = separates;
  }
  return result;
}

// "memory_limit", "GatherTime": "Memory limit", "Gather time".
std::string ToLabel(const std::string& name)
{
  std::string label;
  for (const char c : name)
  {
    label += label.empty() || !std::isupper(c) ? "" : " ";
    label += static_cast<char>(c == '_' ? ' ' : label.empty() ? std::toupper(c) : std::tolower(c));
  }
  return label;
}

std::string ToText(const vtkTranslucencyOption& option, double value)
{
  return option.Type == vtkTranslucencyOption::Kind::Integer ? std::to_string(static_cast<long long>(value))
                                                             : option.Format(value);
}

// The document. Properties are shown in the order in which they are added.
class Definitions
{
public:
  Definitions()
    : Root(Add(nullptr, "ServerManagerConfiguration"))
    , Proxies(Add(this->Root, "ProxyGroup", { { "name", Group } }))
    , Proxy(Add(this->Proxies, "Proxy",
        { { "name", Prefix }, { "class", "vtkPVTranslucency" }, { "si_class", "vtkSITranslucency" },
          { "processes", "client|renderserver|dataserver" } }))
    , View(Add(Add(this->Root, "ProxyGroup", { { "name", "views" } }), "Extension", { { "name", "RenderView" } }))
    , SubProxy(Add(this->View, "SubProxy", { { "command", "AddRepresentation" } }))
  {
    Add(this->SubProxy, "Proxy", { { "name", Prefix }, { "proxygroup", Group }, { "proxyname", Prefix } });
    this->Exposed = Add(this->SubProxy, "ExposedProperties");
    this->Panel = Add(this->View, "PropertyGroup", { { "label", "Translucent Rendering Options" } });
  }

  Element AddProperty(
    const std::string& type, const std::string& name, const std::string& help, const Attributes& attributes)
  {
    const std::string whole = Prefix + name;
    const Element property = Add(this->Proxy, type, attributes);
    property->SetAttribute("name", whole.c_str());
    property->SetAttribute("number_of_elements", "1");
    AddDocumentation(property, help);
    Add(this->Exposed, "Property", { { "name", whole } });
    Add(this->Panel, "Property", { { "name", whole } });
    return property;
  }

  // One that states neither hold nor panels show.
  void AddRelease()
  {
    this->AddProperty("StringVectorProperty", "Release", "The release of the plugin that defines these properties",
      { { "command", "SetRelease" }, { "default_values", TRANSLUCENCY_RELEASE }, { "panel_visibility", "never" },
        { "state_ignored", "1" } });
  }

  void AddTechniques()
  {
    std::string help = "What draws translucent surfaces. None: ParaView itself, by depth peeling";
    std::vector<std::string> names{ "None" };
    for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
    {
      names.push_back(vtkTranslucencyFactory::GetTechniqueName(i));
      help += ". " + names.back() + ": " + vtkTranslucencyFactory::GetTechniqueHelp(i);
    }
    const Element property = this->AddProperty("StringVectorProperty", "Technique", help,
      { { "label", "Technique" }, { "command", "SetTechnique" }, { "default_values", "exact" } });
    AddStrings(property, names);
  }

  void AddOption(const std::string& technique, const vtkTranslucencyOption& option)
  {
    using Kind = vtkTranslucencyOption::Kind;
    const char* type = option.Type == Kind::Integer ? "IntVectorProperty"
      : option.Type == Kind::Real                   ? "DoubleVectorProperty"
                                                    : "StringVectorProperty";
    const char* command = option.Type == Kind::Integer ? "SetIntegerOption"
      : option.Type == Kind::Real                      ? "SetRealOption"
                                                       : "SetChoiceOption";
    const Element property = this->AddProperty(type, ToCamelCase(technique) + ToCamelCase(option.Keyword), option.Help,
      { { "label", ToLabel(option.Keyword) }, { "command", command },
        { "initial_string", technique + " " + option.Keyword }, { "default_values", ToText(option, option.Default) } });
    if (option.Type == Kind::Choice)
    {
      AddStrings(property, option.Choices);
    }
    else
    {
      const Element range = Add(property, option.Type == Kind::Integer ? "IntRangeDomain" : "DoubleRangeDomain",
        { { "name", "range" }, { "min", ToText(option, option.Minimum) } });
      if (!option.IsOpen())
      {
        range->SetAttribute("max", ToText(option, option.Maximum).c_str());
      }
    }
    Add(Add(property, "Hints"), "PropertyWidgetDecorator",
      { { "type", "GenericDecorator" }, { "mode", "visibility" }, { "property", Prefix + "Technique" },
        { "value", technique } });
  }

  void AddSamples()
  {
    const Element property = this->AddProperty("IntVectorProperty", "Samples",
      "Samples per pixel, for smooth edges; more than one takes the place of FXAA",
      { { "label", "Samples" }, { "command", "SetSamples" }, { "default_values", "1" } });
    Add(property, "IntRangeDomain", { { "name", "range" }, { "min", "1" }, { "max", "8" } });
  }

  void AddMeasureTimes()
  {
    const Element property = this->AddProperty("IntVectorProperty", "MeasureTimes",
      "Whether the stages of a frame are timed, which waits for the GPU",
      { { "label", "Measure times" }, { "command", "SetMeasureTimes" }, { "default_values", "0" },
        { "panel_visibility", "advanced" } });
    Add(property, "BooleanDomain", { { "name", "bool" } });
  }

  void AddStatistic(const std::string& type, const char* before, const std::string& name, const std::string& help)
  {
    const Element property = this->AddProperty(type + "VectorProperty", name, help,
      { { "label", ToLabel(name) }, { "command", "Get" + name }, { "default_values", before },
        { "information_only", "1" }, { "panel_visibility", "advanced" } });
    Add(property, "Simple" + type + "InformationHelper");
  }

  // A state names it as its view's, and ParaView says that it misses it where the plugin is not loaded: properties that
  // it does not know it leaves out in silence.
  void AddMark()
  {
    const std::string name = "PluginTranslucency";
    Add(this->Proxies, "Proxy", { { "name", name }, { "processes", "client" } });
    // vtkSIProperty, since that of proxies wants an object to call.
    const Element property = Add(this->View, "ProxyProperty",
      { { "name", Prefix + "Plugin" }, { "si_class", "vtkSIProperty" }, { "panel_visibility", "never" } });
    const Element domain = Add(property, "ProxyListDomain", { { "name", "proxies" } });
    Add(domain, "Proxy", { { "group", Group }, { "name", name } });
  }

  vtkXMLDataElement* GetRoot() const { return this->Root; }

private:
  static void AddStrings(vtkXMLDataElement* property, const std::vector<std::string>& strings)
  {
    const Element domain = Add(property, "StringListDomain", { { "name", "list" } });
    for (const std::string& string : strings)
    {
      Add(domain, "String", { { "value", string } });
    }
  }

  Element Root;
  Element Proxies;
  Element Proxy;
  Element View;
  Element SubProxy;
  Element Exposed;
  Element Panel;
};
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FILE\n";
    return 1;
  }
  Definitions definitions;
  definitions.AddRelease();
  definitions.AddTechniques();
  definitions.AddSamples();
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string technique = vtkTranslucencyFactory::GetTechniqueName(i);
    const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(technique));
    if (auto* own = vtkTranslucencyPass::SafeDownCast(pass))
    {
      for (const vtkTranslucencyOption& option : own->GetOptions())
      {
        definitions.AddOption(technique, option);
      }
    }
  }
  definitions.AddMeasureTimes();
  definitions.AddStatistic("Double", "0", "Fragments", "Translucent fragments of the last frame");
  definitions.AddStatistic("Double", "0", "DeepestPixel", "The most fragments that one pixel holds");
  definitions.AddStatistic("Double", "0", "Bytes", "Bytes of graphics memory that the technique takes");
  definitions.AddStatistic("Int", "0", "Tiles", "Parts into which the picture was cut, as memory is limited");
  definitions.AddStatistic("Int", "0", "GeometryPasses", "How often translucent geometry was drawn");
  definitions.AddStatistic("Int", "0", "ScreenPasses", "How often all pixels were gone over");
  definitions.AddStatistic("Int", "0", "ShaderBuilds", "Shaders that were built anew");
  definitions.AddStatistic(
    "Double", "-1", "GatherTime", "Milliseconds for drawing the geometry; negative if not timed");
  definitions.AddStatistic(
    "Double", "-1", "ResolveTime", "Milliseconds for putting pixels together; negative likewise");
  definitions.AddStatistic("String", "", "Fallback", "Empty, or what was drawn instead: peeling or blending");
  definitions.AddMark();

  std::ofstream file(argv[1]);
  definitions.GetRoot()->PrintXML(file, vtkIndent());
  file.close();
  if (!file)
  {
    std::cerr << argv[0] << ": can't write " << argv[1] << '\n';
    return 1;
  }
  return 0;
}
