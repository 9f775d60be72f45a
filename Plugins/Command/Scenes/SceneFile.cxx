// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFile.h"

#include "Basics/Embedded.h"
#include "Basics/JsonFile.h"

#include <filesystem>

namespace
{
using Json = nlohmann::json;

Vector3 ToVector(const Json& value)
{
  return { { value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>() } };
}

// The readers of the parts of a scene, for a document that has been validated.
class SceneReader
{
public:
  explicit SceneReader(const std::string& file)
    : File(file)
  {
  }

  View ReadCamera(const Json& json) const
  {
    View view;
    Set(json, "position", view.Position, ToVector);
    Set(json, "direction", view.Direction, ToVector);
    Set(json, "target", view.Target, ToVector);
    Set(json, "up", view.Up, ToVector);
    Set(json, "angle", view.Angle, ToNumber);
    Set(json, "height", view.Height, ToNumber);
    view.Azimuth = json.value("azimuth", view.Azimuth);
    view.Elevation = json.value("elevation", view.Elevation);
    view.Zoom = json.value("zoom", view.Zoom);
    return view;
  }

  Light ReadLight(const Json& json) const
  {
    Light light;
    const std::string type = json.at("type");
    light.Type = type == "headlight" ? Light::Kind::Headlight
      : type == "camera"             ? Light::Kind::Camera
                                     : Light::Kind::Scene;
    light.Position = json.contains("position") ? ToVector(json.at("position")) : light.Position;
    light.Target = json.contains("target") ? ToVector(json.at("target")) : light.Target;
    light.Tint = this->ReadColor(json, "color").value_or(light.Tint);
    light.Intensity = json.value("intensity", light.Intensity);
    return light;
  }

  Input ReadActor(const Json& json) const
  {
    Input input;
    const std::string source = json.at("file");
    const bool builtIn = source.compare(0, 6, "scene:") == 0;
    const auto folder = std::filesystem::path(this->File).parent_path();
    input.Source = builtIn ? source : (folder / source).string();
    input.Tint = this->ReadColor(json, "color");
    Set(json, "opacity", input.Opacity, ToNumber);
    input.Transmission = this->ReadColor(json, "transmission");
    if (json.contains("material"))
    {
      input.Material = ReadMaterial(json.at("material"));
    }
    const std::string volume = json.value("volume", "automatic");
    input.Volume = volume == "labels" ? Input::Meaning::Labels
      : volume == "isosurfaces"       ? Input::Meaning::Isosurfaces
                                      : Input::Meaning::Automatic;
    input.Isovalues = json.value("isovalues", input.Isovalues);
    input.Levels = json.value("levels", input.Levels);
    input.Smoothing = json.value("smooth", input.Smoothing);
    for (const Json& label : json.value("labels", Json::array()))
    {
      LabelStyle& style = input.Labels[label.at("value").get<long long>()];
      style.Name = label.value("name", "");
      style.Tint = this->ReadColor(label, "color");
      Set(label, "opacity", style.Opacity, ToNumber);
      style.Transmission = this->ReadColor(label, "transmission");
    }
    Set(json, "streamtubes", input.Tubes, ReadStreamtubes);
    return input;
  }

  std::optional<Color> ReadColor(const Json& json, const std::string& key) const
  {
    if (!json.contains(key))
    {
      return {};
    }
    return ParseColor(this->File + ": " + key, json.at(key).get<std::string>());
  }

private:
  static double ToNumber(const Json& value) { return value.get<double>(); }

  static vtkSmartPointer<vtkTranslucencyMaterial> ReadMaterial(const Json& json)
  {
    const auto material = vtkSmartPointer<vtkTranslucencyMaterial>::New();
    const auto color = [&](const char* key, const double* byDefault) {
      return json.contains(key) ? ToVector(json.at(key)) : Vector3{ { byDefault[0], byDefault[1], byDefault[2] } };
    };
    material->SetAttenuationColor(color("attenuation_color", material->GetAttenuationColor()).data());
    material->SetAttenuationDistance(json.value("attenuation_distance", material->GetAttenuationDistance()));
    material->SetEmissionColor(color("emission_color", material->GetEmissionColor()).data());
    material->SetGrazingOpacity(json.value("grazing_opacity", material->GetGrazingOpacity()));
    material->SetGrazingExponent(json.value("grazing_exponent", material->GetGrazingExponent()));
    material->SetReflectance(json.value("reflectance", material->GetReflectance()));
    material->SetIndexOfRefraction(json.value("index_of_refraction", material->GetIndexOfRefraction()));
    material->SetThickness(json.value("thickness", material->GetThickness()));
    material->SetDiffusion(json.value("diffusion", material->GetDiffusion()));
    material->SetDispersion(json.value("dispersion", material->GetDispersion()));
    return material;
  }

  static Streamtubes ReadStreamtubes(const Json& json)
  {
    Streamtubes tubes;
    tubes.Seeds = json.value("seeds", tubes.Seeds);
    tubes.Speed = json.value("speed", tubes.Speed);
    Set(json, "length", tubes.Length, ToNumber);
    Set(json, "radius", tubes.Radius, ToNumber);
    tubes.Sides = json.value("sides", tubes.Sides);
    return tubes;
  }

  template <typename Value>
  static void Set(const Json& json, const std::string& key, std::optional<Value>& value, Value (*read)(const Json&))
  {
    if (json.contains(key))
    {
      value = read(json.at(key));
    }
  }

  std::string File;
};
}

//------------------------------------------------------------------------------
SceneFile ReadSceneFile(const std::string& file)
{
  const Json json = ReadJson(file, Embedded::SceneSchema, "a scene file");
  const SceneReader reader(file);
  SceneFile scene;
  scene.Title = json.value("title", "");
  scene.Setting.Size = json.value("size", scene.Setting.Size);
  if (json.contains("background"))
  {
    scene.Setting.Behind = ParseBackground(file + ": background", json.at("background").get<std::string>());
  }
  if (json.contains("camera"))
  {
    scene.Setting.Eye = reader.ReadCamera(json.at("camera"));
  }
  for (const Json& light : json.value("lights", Json::array()))
  {
    scene.Setting.Lights.push_back(reader.ReadLight(light));
  }
  for (const Json& actor : json.at("actors"))
  {
    scene.Inputs.push_back(reader.ReadActor(actor));
  }
  return scene;
}
