// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfImporter.h"

#include "Basics/Failure.h"

#include "vtkActor.h"
#include "vtkByteSwap.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyPass.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

vtkStandardNewMacro(GltfImporter);

namespace
{
using Json = nlohmann::json;

// The first chunk of a binary file, behind its header of three words and its own of two (glTF 2.0, section 4.4). VTK's
// loader has read the file before.
Json ReadDocument(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::array<std::uint32_t, 5> words{};
  in.read(reinterpret_cast<char*>(words.data()), sizeof(words));
  vtkByteSwap::Swap4LE(&words[3]);
  std::string text(words[3], ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return Json::parse(text);
}

// A number of an extension, which has to be at least that much.
double ReadNumber(const Json& json, const std::string& what, const char* key, double byDefault, double least)
{
  const Json value = json.value(key, Json(byDefault));
  if (!value.is_number() || !(value.get<double>() >= least))
  {
    throw Failure(what + ": " + key + " is " + value.dump() + ", expected a number of at least " + Json(least).dump());
  }
  return value.get<double>();
}

class GltfMaterial
{
public:
  GltfMaterial(const Json& json, const std::string& file, std::size_t index)
    : Extensions(json.value("extensions", Json::object()))
    , What(file + ": material " + std::to_string(index) + (json.contains("name") ? " " + json.at("name").dump() : ""))
  {
  }

  void Apply(vtkActor* actor) const
  {
    if (!this->Extensions.contains("KHR_materials_transmission"))
    {
      return;
    }
    const Json transmission = this->Get("KHR_materials_transmission", "transmissionTexture");
    const double factor = std::min(ReadNumber(transmission, this->What, "transmissionFactor", 0, 0), 1.0);
    if (factor == 0)
    {
      return;
    }
    double color[3];
    actor->GetProperty()->GetColor(color);
    vtkTranslucencyPass::SetTransmissionColor(actor, factor * color[0], factor * color[1], factor * color[2]);
    actor->GetProperty()->SetColor((1 - factor) * color[0], (1 - factor) * color[1], (1 - factor) * color[2]);
    actor->ForceTranslucentOn();
    const auto material = this->MakeMaterial();
    vtkTranslucencyMaterial::SetMaterial(actor, material);
    if (material->Absorbs())
    {
      actor->GetProperty()->BackfaceCullingOff();
    }
  }

private:
  vtkSmartPointer<vtkTranslucencyMaterial> MakeMaterial() const
  {
    const auto material = vtkSmartPointer<vtkTranslucencyMaterial>::New();
    const double index = ReadNumber(this->Get("KHR_materials_ior", ""), this->What, "ior", 1.5, 1);
    const double ratio = (index - 1) / (index + 1);
    material->SetReflectance(ratio * ratio);
    const Json volume = this->Get("KHR_materials_volume", "thicknessTexture");
    if (ReadNumber(volume, this->What, "thicknessFactor", 0, 0) > 0)
    {
      material->SetIndexOfRefraction(index);
      const Json color = volume.value("attenuationColor", Json({ 1, 1, 1 }));
      if (!color.is_array() || color.size() != 3 ||
        !std::all_of(color.begin(), color.end(), [](const Json& value) { return value.is_number(); }))
      {
        throw Failure(this->What + ": attenuationColor is " + color.dump() + ", expected three numbers from 0 to 1");
      }
      // Nothing absorbs all of a colour on the way: the least is 1/1024, less than a picture can show.
      const auto channel = [&](int i) { return std::clamp(color.at(i).get<double>(), 1.0 / 1024, 1.0); };
      material->SetAttenuationColor(channel(0), channel(1), channel(2));
      const double distance = ReadNumber(volume, this->What, "attenuationDistance", VTK_DOUBLE_MAX, VTK_DBL_MIN);
      material->SetAttenuationDistance(distance);
    }
    return material;
  }

  Json Get(const char* extension, const char* texture) const
  {
    const Json json = this->Extensions.value(extension, Json::object());
    if (json.contains(texture))
    {
      vtkGenericWarningMacro(<< this->What << ": " << texture << " of " << extension
                             << " is not read, only its factor; expected materials without it");
    }
    return json;
  }

  Json Extensions;
  std::string What;
};
}

//------------------------------------------------------------------------------
void GltfImporter::ImportActors(vtkRenderer* renderer)
{
  this->Superclass::ImportActors(renderer);
  const auto model = this->Loader ? this->Loader->GetInternalModel() : nullptr;
  if (!model)
  {
    return; // the superclass has said why
  }
  const Json materials = ReadDocument(this->GetFileName()).value("materials", Json::array());
  for (const auto& [node, actors] : this->Actors)
  {
    const auto& primitives = model->Meshes[model->Nodes[node].Mesh].Primitives;
    for (std::size_t i = 0; i < actors.size() && i < primitives.size(); ++i)
    {
      const auto index = static_cast<std::size_t>(primitives[i].Material); // negative, and so too large, for none
      if (index < materials.size() && index < model->Materials.size())
      {
        const auto& known = model->Materials[index];
        const std::vector<double>& color = known.PbrMetallicRoughness.BaseColorFactor;
        if (known.AlphaMode == vtkGLTFDocumentLoader::Material::AlphaModeType::BLEND && color.size() == 4)
        {
          actors[i]->GetProperty()->SetOpacity(color[3]);
        }
        GltfMaterial(materials[index], this->GetFileName(), index).Apply(actors[i]);
      }
    }
  }
}
