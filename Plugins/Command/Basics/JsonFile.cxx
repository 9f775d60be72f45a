// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonFile.h"

#include "Failure.h"

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

Json Parse(const std::string& file, const std::string& what)
{
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
  {
    throw Failure(file + ": can't be read, expected " + what);
  }
  try
  {
    return Json::parse(in);
  }
  catch (const Json::parse_error& error)
  {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    static const std::regex decoration("^\\[[^\\]]*\\] ");
    throw Failure(file + ": is not JSON: " + Quotable(std::regex_replace(error.what(), decoration, "")));
  }
}

// A step of a place: [actors], or with newer versions of valijson ["actors"].
std::string KeyOf(const std::string& step)
{
  const std::size_t decoration = step[1] == '"' ? 2 : 1;
  return step.substr(decoration, step.size() - 2 * decoration);
}

// The place "<root>[actors][0]" as a JSON pointer.
Json::json_pointer PointerTo(const std::vector<std::string>& place)
{
  Json::json_pointer pointer;
  for (std::size_t i = 1; i < place.size(); ++i)
  {
    pointer /= KeyOf(place[i]);
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
    rule = rule->contains("items") ? &rule->at("items") : &rule->at("properties").at(KeyOf(place[i]));
    if (rule->contains("$ref"))
    {
      rule = &schema.at(Json::json_pointer(rule->at("$ref").get<std::string>().substr(1)));
    }
  }
  return *rule;
}

void Validate(const std::string& file, const Json& document, const char* schemaText)
{
  const Json schemaDocument = Json::parse(schemaText);
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
  throw Failure(file + ": at '" + pointer.to_string() + "': " + (key.empty() ? "is " : "") + what + ", expected " +
    rule.value("description", deepest.description));
}
}

//------------------------------------------------------------------------------
Json ReadJson(const std::string& file, const char* schema, const std::string& what)
{
  const Json document = Parse(file, what);
  Validate(file, document, schema);
  return document;
}
