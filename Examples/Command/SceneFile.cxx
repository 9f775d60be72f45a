#include "SceneFile.h"

#include "Embedded.h"
#include "Failure.h"

#include <nlohmann/json.hpp>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <filesystem>
#include <fstream>
#include <regex>

namespace
{
using Json = nlohmann::json;

Json Parse(const std::string& file)
{
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
  {
    throw Failure(file + ": can't be read, expected a scene file");
  }
  try
  {
    return Json::parse(in);
  }
  catch (const Json::parse_error& error)
  {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    static const std::regex decoration("^\\[[^\\]]*\\] ");
    throw Failure(
      file + ": is not JSON: " + Quotable(std::regex_replace(error.what(), decoration, "")));
  }
}

// The place "<root>[actors][0]" as a JSON pointer.
Json::json_pointer PointerTo(const std::vector<std::string>& place)
{
  Json::json_pointer pointer;
  for (std::size_t i = 1; i < place.size(); ++i)
  {
    pointer /= place[i].substr(1, place[i].size() - 2);
  }
  return pointer;
}

std::string Shortened(const std::string& text)
{
  const std::size_t most = 60;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

// What is wrong with an object's keys; empty if nothing is.
std::string WrongKey(const Json& rule, const Json& object)
{
  if (!object.is_object() || !rule.contains("properties"))
  {
    return "";
  }
  for (const auto& item : object.items())
  {
    if (!rule.at("properties").contains(item.key()))
    {
      return "unknown key '" + item.key() + "'";
    }
  }
  for (const auto& key : rule.value("required", Json::array()))
  {
    if (!object.contains(key.get<std::string>()))
    {
      return "key '" + key.get<std::string>() + "' is missing";
    }
  }
  return "";
}

// The part of the schema that a place in a document has to follow.
const Json& RuleOf(const Json& schema, const std::vector<std::string>& place)
{
  const Json* rule = &schema;
  for (std::size_t i = 1; i < place.size(); ++i)
  {
    const std::string key = place[i].substr(1, place[i].size() - 2);
    rule = rule->contains("items") ? &rule->at("items") : &rule->at("properties").at(key);
    if (rule->contains("$ref"))
    {
      rule = &schema.at(Json::json_pointer(rule->at("$ref").get<std::string>().substr(1)));
    }
  }
  return *rule;
}

void Validate(const std::string& file, const Json& document)
{
  const Json schemaDocument = Json::parse(Embedded::SceneSchema);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schemaDocument), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results))
  {
    return;
  }
  // The deepest place is the one that is wrong; those above it are wrong because of it.
  valijson::ValidationResults::Error error;
  valijson::ValidationResults::Error deepest;
  while (results.popError(error))
  {
    if (error.context.size() > deepest.context.size())
    {
      deepest = error;
    }
  }
  const auto pointer = PointerTo(deepest.context);
  const Json& value = document.at(pointer);
  const Json& rule = RuleOf(schemaDocument, deepest.context);
  const std::string key = WrongKey(rule, value);
  const std::string what = key.empty() ? Shortened(value.dump()) : key;
  throw Failure(file + ": at '" + pointer.to_string() + "': " + (key.empty() ? "is " : "") + what +
    ", expected " + rule.value("description", deepest.description));
}

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
  static void Set(const Json& json, const std::string& key, std::optional<Value>& value,
    Value (*read)(const Json&))
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
  const Json json = Parse(file);
  Validate(file, json);
  const SceneReader reader(file);
  SceneFile scene;
  scene.Title = json.value("title", "");
  scene.Setting.Size = json.value("size", scene.Setting.Size);
  scene.Setting.Background =
    reader.ReadColor(json, "background").value_or(scene.Setting.Background);
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
