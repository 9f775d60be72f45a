// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Basics/Failure.h"
#include "Basics/Specification.h"
#include "Completion.h"
#include "Manual.h"
#include "Scenes/BuiltInScenes.h"
#include "Study/Trace.h"
#include "Techniques/Picture.h"
#include "Techniques/Techniques.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <regex>

namespace
{
const double Infinity = std::numeric_limits<double>::infinity();

// Options as they are written, before they are put together.
struct Written
{
  std::vector<std::string> Sources;
  std::string SizeText;
  std::string Background;
  std::string Color;
  double Opacity = -1;
  std::string Transmission;
  std::string Volume = "automatic";
  std::vector<double> Isovalues;
  int Levels = Input().Levels;
  int Smoothing = Input().Smoothing;
  std::string SceneFile;
  std::string Title;
  double Azimuth = 0;
  double Elevation = 0;
  double Zoom = 1;
  ValuesOfOptions Values; // for completion
};

// CLI11's own Range lets "nan" through.
CLI::Validator NumberIn(double least, double most, const std::string& range)
{
  const auto check = [least, most, range](const std::string& text)
  {
    double value = 0;
    const bool valid = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
    return valid ? std::string() : "is '" + text + "', expected a number in " + range;
  };
  return CLI::Validator(check, range);
}

CLI::Validator SizeText()
{
  const auto check = [](const std::string& text)
  {
    static const std::regex form("0*[1-9][0-9]{0,8}x0*[1-9][0-9]{0,8}");
    return std::regex_match(text, form) ? std::string()
                                        : "is '" + text + "', expected WIDTHxHEIGHT in pixels, both 1 or more";
  };
  return CLI::Validator(check, "WIDTHxHEIGHT");
}

std::array<int, 2> ToSize(const std::string& text)
{
  const std::size_t cross = text.find('x');
  return { { std::stoi(text.substr(0, cross)), std::stoi(text.substr(cross + 1)) } };
}

// What takes one of a few words.
CLI::Option* AddChoice(CLI::App* command, const std::string& name, std::string& value, const std::string& help,
  const std::vector<std::string>& words, Written& written)
{
  CLI::Option* option = command->add_option(name, value, help)->check(CLI::IsMember(words));
  written.Values[option] = { words };
  return option;
}

CLI::Option* AddOutput(CLI::App* command, const std::string& help, Written& written, Arguments& arguments)
{
  CLI::Option* option = command->add_option("-o,--output", arguments.Output, help);
  written.Values[option] = { {}, true };
  return option;
}

std::vector<std::string> TechniqueNames()
{
  std::vector<std::string> names;
  for (const TechniqueInfo& technique : ListTechniques())
  {
    names.push_back(technique.Name);
  }
  return names;
}

const std::string Look = "Look of the INPUTs";
const std::string Looking = "View";

void AddSceneOptions(CLI::App* command, Written& written, Arguments& arguments, const std::string& alone = "")
{
  const std::vector<std::string> builtIn = BuiltInSceneNames();
  written.Values[command->add_option("INPUT", written.Sources,
    alone + "files (" + InputSuffixes() + ") or built-in scenes (" + Listed(builtIn) + ")")] = { builtIn, true };
  written.Values[command->add_option(
    "--scene", written.SceneFile, "a scene file; 'translucency schema' says what it holds")] = { {}, true };
  command->add_option("--title", written.Title, "what reports call the scene");

  command->add_option("--color", written.Color, "colour of all: #rrggbb or a name")->group(Look);
  command->add_option("--opacity", written.Opacity, "opacity of all, 0 to 1")
    ->check(NumberIn(0, 1, "0..1"))
    ->group(Look);
  command
    ->add_option("--transmission", written.Transmission,
      "what surfaces let through of what lies behind them, besides what their opacity leaves free: a colour; red is a "
      "red filter, black "
      "(the default) none")
    ->group(Look);
  AddChoice(command, "--volume", written.Volume,
    "what volumes are: labels (one surface for each integer value), isosurfaces, or automatic",
    { "automatic", "labels", "isosurfaces" }, written)
    ->group(Look);
  command->add_option("--isovalues", written.Isovalues, "values of the isosurfaces: A,B,...")
    ->delimiter(',')
    ->group(Look);
  command->add_option("--levels", written.Levels, "how many isosurfaces, where --isovalues does not say")
    ->check(NumberIn(1, 32, "1..32"))
    ->capture_default_str()
    ->group(Look);
  command->add_option("--smooth", written.Smoothing, "iterations that smooth the surfaces of labels")
    ->check(NumberIn(0, 200, "0..200"))
    ->capture_default_str()
    ->group(Look);

  command->add_option("--size", written.SizeText, "size of the picture, 1280x720 by default")
    ->check(SizeText())
    ->group(Looking);
  command
    ->add_option("--samples", arguments.Samples,
      "samples a pixel, at least (multi-sampling): 1, 2, 4 or 8, as the driver has them")
    ->check(CLI::IsMember({ 1, 2, 4, 8 }))
    ->capture_default_str()
    ->group(Looking);
  command
    ->add_option("--background", written.Background,
      "background: #rrggbb or a name, or transparent: .png, .tif and .exr then hold the opacity")
    ->group(Looking);
  command->add_option("--azimuth", written.Azimuth, "degrees to go round the scene")
    ->check(NumberIn(-Infinity, Infinity, "degrees"))
    ->group(Looking);
  command->add_option("--elevation", written.Elevation, "degrees to go up")
    ->check(NumberIn(-89, 89, "-89..89"))
    ->group(Looking);
  command->add_option("--zoom", written.Zoom, "2 is twice as large")
    ->check(NumberIn(0.001, 1000, "0.001..1000"))
    ->group(Looking);
}

// A flag for each option of each technique.
void AddTechniqueOptions(CLI::App* command, Written& written, Arguments& arguments)
{
  struct Flag
  {
    std::string Techniques;
    vtkTranslucencyOption Option;
    std::vector<std::string> Choices; // of all these techniques
  };
  std::vector<Flag> flags;
  for (const TechniqueInfo& technique : ListTechniques())
  {
    for (const vtkTranslucencyOption& option : technique.Options)
    {
      const auto known = std::find_if(
        flags.begin(), flags.end(), [&option](const Flag& flag) { return flag.Option.Keyword == option.Keyword; });
      if (known == flags.end())
      {
        flags.push_back({ technique.Name, option, option.Choices });
      }
      else
      {
        known->Techniques += ", " + technique.Name;
        std::copy_if(option.Choices.begin(), option.Choices.end(), std::back_inserter(known->Choices),
          [&known](const std::string& choice)
          { return std::find(known->Choices.begin(), known->Choices.end(), choice) == known->Choices.end(); });
      }
    }
  }
  for (const Flag& flag : flags)
  {
    const std::string keyword = flag.Option.Keyword;
    CLI::Option* option = command->add_option_function<std::string>(
      FlagOf(flag.Option), [&arguments, keyword](const std::string& value) { arguments.Settings[keyword] = value; },
      flag.Option.Help + " [" + flag.Techniques + "]");
    option->type_name(flag.Option.Range())
      ->default_str(flag.Option.Format(flag.Option.Default))
      ->group("Options of techniques");
    written.Values[option] = { flag.Choices };
  }
}

void AddTechnique(CLI::App* command, Written& written, Arguments& arguments)
{
  CLI::Option* option = command->add_option("-t,--technique", arguments.Techniques, "a name from 'translucency list'");
  option->expected(1)
    ->allow_extra_args(false) // else it would take a -- that stands behind it
    ->default_str("adaptive");
  written.Values[option] = { TechniqueNames() };
  AddTechniqueOptions(command, written, arguments);
}

void AddFrameOptions(CLI::App* command, BenchmarkSettings& frames)
{
  command->add_option("--frames", frames.Frames, "frames that are timed")
    ->check(NumberIn(1, 100000, "1..100000"))
    ->capture_default_str();
  command->add_option("--warmup", frames.Warmup, "frames before that")
    ->check(NumberIn(0, 100000, "0..100000"))
    ->capture_default_str();
}

void AddTechniques(CLI::App* command, Written& written, Arguments& arguments)
{
  CLI::Option* option = command->add_option("--techniques", arguments.Techniques,
    "names, with options after colons: adaptive,adaptive:nodes=8:removal=mixed; all techniques by default");
  option->delimiter(',');
  written.Values[option] = { TechniqueNames() };
}

void AddStorage(CLI::App& app, Written& written, Arguments& arguments)
{
  auto* storage = app.add_subcommand("storage", "what designs of fragment storage take for frames: bytes and accesses");
  AddSceneOptions(storage, written, arguments, "a histogram (.json), a trace (.csv .trace), or a scene: ");
  const std::string designs = "Designs";
  const auto add = [storage, &designs](const char* flag, int& value, int most, const std::string& help)
  {
    return storage->add_option(flag, value, help)
      ->check(NumberIn(1, most, "1.." + std::to_string(most)))
      ->group(designs);
  };
  vtkStorageAccounting::Settings& settings = arguments.Storage;
  add("--section-length", settings.TSectionLength, 64, "fragments in a section of the T-buffer")->capture_default_str();
  add("--m-section-length", settings.MSectionLength, 64,
    "fragments in a section of the M-buffer; by default the mean of the frame's pixels that hold any");
  add("--address-bits", settings.Bits.Address, 64, "bits of an address; by default as few as the fullest frame needs");
  add("--coordinate-bits", settings.Bits.Coordinate, 64, "bits of x, and of y, of a fragment in the R-buffer")
    ->capture_default_str();
  add("--depth-bits", settings.Bits.Depth, 64, "bits of a depth")->capture_default_str();
  add("--color-bits", settings.Bits.Color, 64, "bits of a colour with its opacity")->capture_default_str();
  AddOutput(storage, "a folder for table.txt, storage.json, bytes.png and accesses.png", written, arguments);
  storage->footer(
    "Four designs are compared: a linked list a pixel; the T-buffer, lists of sections; the R-buffer, a FIFO that is "
    "read pass by pass; the M-buffer, a\n"
    "section a pixel and more where it overflows. Traces and scenes also go through a simulator of each, which has to "
    "come to the same numbers.\n"
    "The R-buffer's takes long where pixels are deep: its time grows with the square of a pixel's fragments.\n"
    "Examples:\n"
    "  translucency storage quake4.json -o quake4          the figures of the T-buffer's paper\n"
    "  translucency storage quake4.json --section-length 3\n"
    "  translucency storage --scene frog.json --size 640x480\n"
    "  translucency trace --scene frog.json -o frog.trace\n"
    "  translucency storage frog.trace --m-section-length 4 --address-bits 24 -o frog\n"
    "'translucency schema histogram' says what a histogram holds, 'translucency trace --help' what a trace does.");
}

void AddProbe(CLI::App& app, Written& written, Arguments& arguments)
{
  auto* probe = app.add_subcommand("probe", "what part of a surface is seen at each depth of one pixel, by techniques");
  AddSceneOptions(probe, written, arguments);
  AddTechniques(probe, written, arguments);
  probe->add_option("--pixel", arguments.Pixel, "which one: X Y, from the lower left corner")->required();
  probe->add_option("--depths", arguments.Depths, "depths, evenly spread, besides those of the pixel's fragments")
    ->check(NumberIn(0, 100000, "0..100000"))
    ->capture_default_str();
  AddOutput(probe, "the visibilities: .json or .csv", written, arguments);
  probe->footer(
    "The exact visibility at a depth is the product of 1 - opacity of all fragments in front of it. A technique's is "
    "measured by drawing: the pixel's\n"
    "fragments in black, and one more at that depth, which shines and hides next to nothing. What is seen of its light "
    "is the visibility.\n"
    "With alpha_correction=on, the default of some, it can be more than 1; off gives the function itself. Techniques "
    "without a function (weighted, vtk-oit)\n"
    "are measured alike. Those of few layers have one fragment more to hold; screendoor and vtk-peel show nothing so "
    "faint. Of transmission colours the\n"
    "mean is taken.\n"
    "Examples:\n"
    "  translucency probe scene:car --pixel 640 360\n"
    "  translucency probe scene:car --pixel 640 360 --techniques wavelet,moment:moments=power-8 -o car.csv\n"
    "  translucency probe --scene frog.json --pixel 600 400 --depths 500 -o frog.json");
}

void DeclareCommands(CLI::App& app, Written& written, Arguments& arguments)
{
  arguments.Frames = BenchmarkSettings();
  auto* list = app.add_subcommand("list", "the techniques, their options, and whether this driver can run them");
  list->add_flag("--json", arguments.Json, "as JSON");

  auto* render = app.add_subcommand("render", "draw a picture by one technique");
  AddSceneOptions(render, written, arguments);
  AddTechnique(render, written, arguments);
  AddOutput(render, "the picture: " + PictureSuffixes(), written, arguments)->required();
  render->footer("Examples:\n"
                 "  translucency render frogtissue.mhd -o frog.png\n"
                 "  translucency render skin.stl bones.stl --opacity 0.3 --technique exact -o body.png\n"
                 "  translucency render --scene frog.json --technique adaptive --nodes 8 --size 1920x1080 -o "
                 "frog.exr");

  auto* compare =
    app.add_subcommand("compare", "draw by several techniques; pictures, differences and costs in a page");
  AddSceneOptions(compare, written, arguments);
  AddTechniques(compare, written, arguments);
  written.Values[compare->add_option("--reference", arguments.Reference, "the technique that is right")
                   ->capture_default_str()] = { TechniqueNames() };
  AddFrameOptions(compare, arguments.Frames);
  AddOutput(compare, "a folder for index.html, comparison.json, table.txt and the pictures", written, arguments)
    ->required();
  compare->footer("blend is always drawn too: what the others cost is told as a multiple of it.\n"
                  "Example:\n"
                  "  translucency compare --scene frog.json --techniques exact,adaptive:nodes=8,vtk-oit -o frog\n"
                  "  then open frog/index.html in a browser");

  auto* bench = app.add_subcommand("bench", "time techniques in turn, in one process");
  AddSceneOptions(bench, written, arguments);
  AddTechniques(bench, written, arguments);
  AddFrameOptions(bench, arguments.Frames);
  bench
    ->add_option("--orbit", arguments.Frames.Orbit,
      "degrees that the camera goes round while frames are timed: shows frames that take long when something new is "
      "met")
    ->check(NumberIn(-Infinity, Infinity, "degrees"))
    ->capture_default_str();
  AddOutput(bench, "a JSON file", written, arguments);
  bench->footer("Built-in scenes:\n" + BuiltInSceneHelp() +
    "Example:\n"
    "  translucency bench scene:rectangles:count=1200 --techniques exact,adaptive --frames 50 -o "
    "times.json");

  auto* run = app.add_subcommand(
    "run", "run a program that uses VTK: where it asks for depth peeling, it gets another technique");
  AddTechnique(run, written, arguments);
  run->add_flag("--always", arguments.Always, "whether or not it asks for depth peeling");
  CLI::Option* program = run->add_option("PROGRAM", arguments.Program, "the program and its arguments, behind --");
  program->required()->expected(-1);
  written.Values[program] = { { "--" } };
  run->footer(
    "Depth peeling is asked for by vtkRenderer::UseDepthPeelingOn, or by making a vtkDualDepthPeelingPass or a\n"
    "vtkDepthPeelingPass. With --always the technique draws what is translucent in every renderer, and in every pass\n"
    "that would blend it. The program, in C++ or Python, stays as it is; it must use a release of VTK that a drop-in "
    "is\n"
    "there for (VTK " TRANSLUCENCY_VTK_VERSION
    "), else it draws as it would have, after a message. Its exit status is that of this\n"
    "command.\n"
    "Examples:\n"
    "  translucency run -- python3 script.py\n"
    "  translucency run --technique exact -- ./viewer scan.vtp\n"
    "  translucency run --always -- f3d scan.vtp\n"
    "  xvfb-run translucency run --technique adaptive --nodes 8 -- python3 script.py   (without a display)");

  AddStorage(app, written, arguments);

  auto* trace = app.add_subcommand("trace", "write the translucent fragments of a scene, one by one");
  AddSceneOptions(trace, written, arguments);
  AddOutput(trace, "the trace: .csv (text) or .trace (24 bytes a fragment)", written, arguments)->required();
  trace->footer("A .csv begins with the lines '# size WIDTHxHEIGHT' and 'frame,x,y,z,r,g,b,a': a line a fragment; x "
                "and y are pixels from the lower\n"
                "left corner, z is the window depth, 0 to 1. Fragments come pixel by pixel, those of a pixel in the "
                "order of drawing.\n"
                "'translucency storage' reads both.\n"
                "Examples:\n"
                "  translucency trace --scene frog.json --size 640x480 -o frog.csv\n"
                "  translucency trace skin.stl bones.stl --opacity 0.3 -o body.trace");

  AddProbe(app, written, arguments);

  auto* schema = app.add_subcommand("schema", "print the JSON schema of scene files, or of histograms");
  AddChoice(schema, "KIND", arguments.Schema, "scene, or histogram: what 'translucency storage' reads",
    { "scene", "histogram" }, written)
    ->capture_default_str();
}

// For the build, and for packagers; --help does not list them.
void DeclareDescriptions(CLI::App& app, const Written& written)
{
  const auto add = [&app](const std::string& name, const std::string& help, const std::function<std::string()>& text)
  {
    app.add_subcommand(name, help)
      ->group("")
      ->callback(
        [text]
        {
          std::cout << text();
          throw CLI::Success();
        });
  };
  add("manual", "print the manual page", [&app] { return ManualText(app); });
  add("completion", "print a script for completion in bash", [&] { return CompletionText(app, written.Values); });
}

Input ToInput(const std::string& source, const Written& written)
{
  Input input;
  input.Source = source;
  if (!written.Color.empty())
  {
    input.Tint = ParseColor("--color", written.Color);
  }
  if (written.Opacity >= 0)
  {
    input.Opacity = written.Opacity;
  }
  if (!written.Transmission.empty())
  {
    input.Transmission = ParseColor("--transmission", written.Transmission);
  }
  input.Volume = written.Volume == "labels" ? Input::Meaning::Labels
    : written.Volume == "isosurfaces"       ? Input::Meaning::Isosurfaces
                                            : Input::Meaning::Automatic;
  input.Isovalues = written.Isovalues;
  input.Levels = written.Levels;
  input.Smoothing = written.Smoothing;
  return input;
}

// A histogram or a trace, which stands alone; false if it is a scene.
bool PutMeasured(const CLI::App& command, const Written& written, Arguments& arguments)
{
  const auto measured = std::find_if(written.Sources.begin(), written.Sources.end(),
    [](const std::string& source) { return IsTrace(source) || std::filesystem::path(source).extension() == ".json"; });
  if (measured == written.Sources.end())
  {
    return false;
  }
  const std::string alone = "'" + *measured + "' is a histogram or a trace, expected ";
  if (written.Sources.size() > 1)
  {
    throw Failure(alone + "no other INPUT, but there are " + std::to_string(written.Sources.size()));
  }
  for (const CLI::Option* option : command.get_options())
  {
    const bool scenes =
      option->get_group() == Look || option->get_group() == Looking || option->get_name() == "--scene";
    if (scenes && option->count() > 0)
    {
      throw Failure(alone + "no option of scenes, but there is " + option->get_name());
    }
  }
  arguments.Measured = *measured;
  arguments.Title = command.count("--title") > 0 ? std::optional<std::string>(written.Title) : std::nullopt;
  arguments.NeedsDisplay = !arguments.Output.empty();
  return true;
}

void PutTogether(const CLI::App& command, const Written& written, Arguments& arguments)
{
  const std::map<std::string, Action> actions{ { "list", Action::List }, { "render", Action::Render },
    { "compare", Action::Compare }, { "bench", Action::Bench }, { "run", Action::Run }, { "schema", Action::Schema },
    { "storage", Action::Storage }, { "trace", Action::Trace }, { "probe", Action::Probe } };
  arguments.Do = actions.at(command.get_name());
  if (arguments.Do == Action::List || arguments.Do == Action::Schema || arguments.Do == Action::Run)
  {
    arguments.NeedsDisplay = arguments.Do == Action::List;
    return;
  }
  if (arguments.Do == Action::Storage && PutMeasured(command, written, arguments))
  {
    return;
  }
  for (const std::string& source : written.Sources)
  {
    arguments.Inputs.push_back(ToInput(source, written));
  }
  const auto given = [&command](const std::string& name) { return command.count(name) > 0; };
  if (given("--scene"))
  {
    arguments.SceneFile = written.SceneFile;
  }
  else if (arguments.Inputs.empty())
  {
    throw Failure("there is nothing to draw, expected an INPUT or --scene FILE");
  }
  arguments.Title = given("--title") ? std::optional<std::string>(written.Title) : std::nullopt;
  arguments.Azimuth = given("--azimuth") ? std::optional<double>(written.Azimuth) : std::nullopt;
  arguments.Elevation = given("--elevation") ? std::optional<double>(written.Elevation) : std::nullopt;
  arguments.Zoom = given("--zoom") ? std::optional<double>(written.Zoom) : std::nullopt;
  if (given("--size"))
  {
    arguments.Size = ToSize(written.SizeText);
  }
  if (given("--background"))
  {
    arguments.Behind = ParseBackground("--background", written.Background);
  }
}
}

//------------------------------------------------------------------------------
std::optional<Arguments> ParseArguments(int argc, char** argv)
{
  Written written;
  Arguments arguments;
  CLI::App app("Draws translucent surfaces right, whatever the order in which they are drawn, and "
               "shows what that costs.",
    "translucency");
  app.set_version_flag("--version", TRANSLUCENCY_VERSION);
  app.require_subcommand(1);
  app.footer("Start with:\n"
             "  translucency list\n"
             "  translucency render FILE -o picture.png\n"
             "  translucency compare FILE -o folder      and open folder/index.html\n"
             "  translucency storage FILE                what designs of fragment storage take for its fragments\n"
             "  translucency run -- PROGRAM              a program of yours, by another technique\n"
             "'translucency COMMAND --help' says more of each command.");
  DeclareCommands(app, written, arguments);
  DeclareDescriptions(app, written);
  try
  {
    app.parse(argc, argv);
    PutTogether(*app.get_subcommands().front(), written, arguments);
  }
  catch (const CLI::Success& answer) // --help, --version, manual, completion
  {
    app.exit(answer);
    return {};
  }
  catch (const CLI::ParseError& error)
  {
    const bool runs = !app.get_subcommands().empty() && app.got_subcommand("run");
    throw Failure(std::string(error.what()) +
      (runs ? " (translucency run [OPTIONS] -- PROGRAM [ARGUMENTS])" : " (translucency --help)"));
  }
  return arguments;
}
