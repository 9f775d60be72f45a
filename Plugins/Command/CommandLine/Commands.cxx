// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Arguments.h"
#include "Basics/Embedded.h"
#include "Basics/Failure.h"
#include "Basics/OutputFiles.h"
#include "Basics/Progress.h"
#include "Program.h"
#include "Report/Page.h"
#include "Report/Report.h"
#include "Scenes/SceneFile.h"
#include "Study/HistogramFile.h"
#include "Study/Probe.h"
#include "Study/StorageReport.h"
#include "Study/Trace.h"
#include "TechniqueList.h"
#include "Techniques/Stage.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

// What a command draws: the inputs and how they are seen; the parts are read by ReadParts.
struct Task
{
  Scene Setting;
  std::vector<Input> Inputs;
  std::string Title;
};

Task MakeTask(const Arguments& arguments)
{
  Task task;
  if (arguments.SceneFile)
  {
    const SceneFile file = ReadSceneFile(*arguments.SceneFile);
    task.Setting = file.Setting;
    task.Inputs = file.Inputs;
    task.Title = file.Title;
  }
  task.Inputs.insert(task.Inputs.end(), arguments.Inputs.begin(), arguments.Inputs.end());
  task.Setting.Size = arguments.Size.value_or(task.Setting.Size);
  task.Setting.Samples = arguments.Samples;
  task.Setting.Behind = arguments.Behind ? arguments.Behind : task.Setting.Behind;
  task.Setting.Eye.Azimuth = arguments.Azimuth.value_or(task.Setting.Eye.Azimuth);
  task.Setting.Eye.Elevation = arguments.Elevation.value_or(task.Setting.Eye.Elevation);
  task.Setting.Eye.Zoom = arguments.Zoom.value_or(task.Setting.Eye.Zoom);
  task.Title = arguments.Title.value_or(task.Title);
  for (const Input& input : task.Title.empty() ? task.Inputs : std::vector<Input>())
  {
    task.Title += (task.Title.empty() ? "" : ", ") + fs::path(input.Source).filename().string();
  }
  return task;
}

void ReadParts(Task& task)
{
  for (const Input& input : task.Inputs)
  {
    AddInput(input, task.Setting);
  }
}

// The techniques as asked for, or all; then those that a report can't do without.
std::vector<TechniqueChoice> ChooseTechniques(
  const std::vector<std::string>& asked, const std::vector<std::string>& needed)
{
  std::vector<TechniqueChoice> choices;
  const auto isThere = [&choices](const std::string& label)
  {
    return std::any_of(
      choices.begin(), choices.end(), [&label](const TechniqueChoice& choice) { return choice.Label == label; });
  };
  for (const std::string& text : asked)
  {
    const TechniqueChoice choice = ChooseTechnique(text);
    if (isThere(choice.Label))
    {
      throw Failure("technique '" + choice.Label + "' is named twice, expected once");
    }
    choices.push_back(choice);
  }
  for (const TechniqueInfo& technique : asked.empty() ? ListTechniques() : std::vector<TechniqueInfo>())
  {
    choices.push_back(ChooseTechnique(technique.Name));
  }
  for (const std::string& text : needed)
  {
    const TechniqueChoice choice = ChooseTechnique(text);
    if (!isThere(choice.Label))
    {
      choices.push_back(choice);
    }
  }
  return choices;
}

std::string HelpOf(const TechniqueChoice& choice)
{
  for (const TechniqueInfo& technique : ListTechniques())
  {
    if (technique.Name == choice.Name)
    {
      return technique.Help;
    }
  }
  return "";
}

// A file name for a technique with its options.
std::string FileNameOf(const TechniqueChoice& choice)
{
  std::string name = choice.Label;
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '.' && c != '_'; }, '-');
  return name;
}

std::string Contents(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream contents;
  contents << in.rdbuf();
  return contents.str();
}

std::vector<std::string> SourcesOf(const Task& task)
{
  std::vector<std::string> sources;
  std::transform(task.Inputs.begin(), task.Inputs.end(), std::back_inserter(sources),
    [](const Input& input) { return input.Source; });
  return sources;
}

Report StartReport(
  const Task& task, const std::vector<TechniqueChoice>& techniques, const BenchmarkSettings& settings, Stage& stage)
{
  Report report;
  report.Title = task.Title;
  report.Inputs = SourcesOf(task);
  report.Size = task.Setting.Size;
  report.Samples = task.Setting.Samples;
  report.Driver = stage.GetDriver();
  report.Actors = task.Setting.Parts.size();
  report.Triangles = CountTriangles(task.Setting);
  report.Settings = settings;
  for (const TechniqueChoice& technique : techniques)
  {
    ReportRow row;
    row.Technique = technique;
    row.Help = HelpOf(technique);
    report.Rows.push_back(row);
  }
  return report;
}

std::vector<int> AddAll(const Scene& scene, const std::vector<TechniqueChoice>& techniques, Stage& stage)
{
  std::vector<int> numbers;
  for (const TechniqueChoice& technique : techniques)
  {
    numbers.push_back(stage.Add(scene, technique));
  }
  return numbers;
}

void MeasureRows(
  const std::vector<TechniqueChoice>& techniques, const std::vector<int>& numbers, Stage& stage, Report& report)
{
  const auto timings = Measure(stage, techniques, numbers, report.Settings);
  for (std::size_t i = 0; i < timings.size(); ++i)
  {
    report.Rows[i].Times = timings[i];
  }
}

// The one technique that was asked for, with the options given by flags.
TechniqueChoice ChooseTechniqueOf(const Arguments& arguments)
{
  TechniqueChoice technique = ChooseTechnique(arguments.Techniques.empty() ? "adaptive" : arguments.Techniques.front());
  for (const auto& setting : arguments.Settings)
  {
    AddSetting(technique, setting.first, setting.second);
  }
  return technique;
}

void RunRender(const Arguments& arguments)
{
  CheckPictureSuffix(arguments.Output);
  const TechniqueChoice technique = ChooseTechniqueOf(arguments);
  Task task = MakeTask(arguments);
  if (!BackgroundOf(task.Setting))
  {
    CheckHoldsTransparency(arguments.Output);
  }
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);
  OutputFiles files;
  const fs::path file = files.Add(arguments.Output);
  stage.Draw(stage.Add(task.Setting, technique));
  stage.Read()->Write(file, arguments.Output);
  files.Commit();
}

// Draws each technique's picture and writes it and its difference to the reference.
std::map<std::string, std::string> DrawPictures(const std::vector<int>& numbers, std::size_t reference,
  const fs::path& folder, Stage& stage, OutputFiles& files, Report& report)
{
  std::map<std::string, std::string> contents;
  const auto write = [&](const Picture& picture, const std::string& name)
  {
    const fs::path file = files.Add(folder / name);
    picture.Write(file, (folder / name).string());
    contents[name] = Contents(file);
  };
  stage.Draw(numbers[reference]);
  const std::unique_ptr<Picture> right = stage.Read();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    ReportRow& row = report.Rows[i];
    stage.Settle(numbers[i]);
    stage.Draw(numbers[i]);
    const std::unique_ptr<Picture> picture = stage.Read();
    row.PictureFile = FileNameOf(row.Technique) + ".png";
    write(*picture, row.PictureFile);
    if (i != reference)
    {
      row.ToReference = picture->CompareTo(*right);
      row.DifferenceFile = FileNameOf(row.Technique) + "-difference.png";
      write(*picture->AbsoluteDifference(*right, 8), row.DifferenceFile);
    }
  }
  return contents;
}

void RunCompare(const Arguments& arguments)
{
  const auto techniques = ChooseTechniques(arguments.Techniques, { arguments.Reference, "blend" });
  const std::string reference = ChooseTechnique(arguments.Reference).Label;
  std::size_t referenceRow = 0;
  while (techniques[referenceRow].Label != reference)
  {
    ++referenceRow;
  }
  Task task = MakeTask(arguments);
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);

  const fs::path folder = arguments.Output;
  OutputFiles files;
  files.AddFolder(folder);
  const auto numbers = AddAll(task.Setting, techniques, stage);
  Report report = StartReport(task, techniques, arguments.Frames, stage);
  report.Reference = reference;
  const auto pictures = DrawPictures(numbers, referenceRow, folder, stage, files, report);
  MeasureRows(techniques, numbers, stage, report);

  const std::string table = ToText(report);
  files.AddText(folder / "table.txt", table);
  files.AddText(folder / "comparison.json", ToJson(report).dump(2) + "\n");
  files.AddText(folder / "index.html", ToPage(report, pictures));
  files.Commit();
  std::cout << table << "\nThe pictures side by side: " << (folder / "index.html").string() << "\n";
}

void RunBench(const Arguments& arguments)
{
  const auto techniques = ChooseTechniques(arguments.Techniques, { "blend" });
  Task task = MakeTask(arguments);
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);
  OutputFiles files;
  const fs::path file = arguments.Output.empty() ? fs::path() : files.Add(arguments.Output);

  const auto numbers = AddAll(task.Setting, techniques, stage);
  Report report = StartReport(task, techniques, arguments.Frames, stage);
  MeasureRows(techniques, numbers, stage, report);
  if (!file.empty())
  {
    OutputFiles::Write(file, ToJson(report).dump(2) + "\n", arguments.Output);
    files.Commit();
  }
  std::cout << ToText(report);
}

// The fragments of a scene, as the one frame of a trace.
Trace TraceScene(const Task& task, Stage& stage)
{
  Progress progress("tracing", 2);
  const int number = stage.AddTrace(task.Setting);
  progress.Step("drawing " + task.Title);
  stage.Draw(number);
  progress.Step("reading back");
  Trace trace{ task.Setting.Size, { { 0, stage.GetFragments(number) } } };
  if (trace.Frames.front().Fragments.empty())
  {
    throw Failure(task.Title + ": has no translucent fragments, expected at least one");
  }
  return trace;
}

void RunTrace(const Arguments& arguments)
{
  CheckTraceSuffix(arguments.Output);
  Task task = MakeTask(arguments);
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);
  OutputFiles files;
  const fs::path file = files.Add(arguments.Output);
  const Trace trace = TraceScene(task, stage);
  WriteTrace(trace, file, arguments.Output);
  files.Commit();
  std::cout << Grouped(static_cast<long long>(trace.Frames.front().Fragments.size())) << " fragments\n";
}

void CheckPixel(const std::array<int, 2>& pixel, const std::array<int, 2>& size)
{
  if (pixel[0] < 0 || pixel[0] >= size[0] || pixel[1] < 0 || pixel[1] >= size[1])
  {
    throw Failure("pixel is " + std::to_string(pixel[0]) + " " + std::to_string(pixel[1]) +
      ", expected one of the picture, 0 0 to " + std::to_string(size[0] - 1) + " " + std::to_string(size[1] - 1));
  }
}

void RunProbe(const Arguments& arguments)
{
  if (!arguments.Output.empty())
  {
    CheckProbeSuffix(arguments.Output);
  }
  Probe probe;
  for (const TechniqueChoice& technique : ChooseTechniques(arguments.Techniques, {}))
  {
    probe.Rows.push_back({ technique, HelpOf(technique), "", {} });
  }
  Task task = MakeTask(arguments);
  CheckPixel(arguments.Pixel, task.Setting.Size);
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);
  OutputFiles files;
  const fs::path file = arguments.Output.empty() ? fs::path() : files.Add(arguments.Output);
  probe.Title = task.Title;
  probe.Inputs = SourcesOf(task);
  probe.Size = task.Setting.Size;
  probe.Pixel = arguments.Pixel;
  const auto fragments = TakePixel(TraceScene(task, stage).Frames.front().Fragments, probe.Pixel, task.Title);
  AddExact(fragments, stage.GetCamera(), arguments.Depths, probe);
  MeasureRows(fragments, stage.GetCamera(), probe);
  if (!file.empty())
  {
    OutputFiles::Write(file, ToFile(probe, arguments.Output), arguments.Output);
    files.Commit();
  }
  std::cout << ToText(probe);
}

StorageReport AccountScene(const Arguments& arguments)
{
  Task task = MakeTask(arguments);
  Stage stage(task.Setting.Size, task.Setting.Samples, !BackgroundOf(task.Setting));
  ReadParts(task);
  StorageReport report = AccountStorage(task.Title, { "the frame" }, TraceScene(task, stage), arguments.Storage);
  report.Title = task.Title;
  report.Inputs = SourcesOf(task);
  return report;
}

StorageReport AccountMeasured(const Arguments& arguments)
{
  const std::string& file = arguments.Measured;
  StorageReport report;
  if (IsTrace(file))
  {
    const Trace trace = ReadTrace(file);
    std::vector<std::string> names;
    for (const TraceFrame& frame : trace.Frames)
    {
      names.push_back("Frame" + std::to_string(frame.Number));
    }
    report = AccountStorage(file, names, trace, arguments.Storage);
  }
  else
  {
    const HistogramFile histogram = ReadHistogramFile(file);
    report = AccountStorage(file, histogram.Names, histogram.Frames, arguments.Storage);
    report.Title = histogram.Title;
  }
  report.Title = arguments.Title.value_or(report.Title.empty() ? fs::path(file).filename().string() : report.Title);
  report.Inputs = { file };
  return report;
}

void RunStorage(const Arguments& arguments)
{
  const StorageReport report = arguments.Measured.empty() ? AccountScene(arguments) : AccountMeasured(arguments);
  const std::string table = ToText(report);
  const fs::path folder = arguments.Output;
  if (!folder.empty())
  {
    OutputFiles files;
    files.AddFolder(folder);
    DrawChart(report, StorageChart::Bytes, files.Add(folder / "bytes.png"), (folder / "bytes.png").string());
    DrawChart(report, StorageChart::Accesses, files.Add(folder / "accesses.png"), (folder / "accesses.png").string());
    files.AddText(folder / "table.txt", table);
    files.AddText(folder / "storage.json", ToJson(report).dump(2) + "\n");
    files.Commit();
  }
  std::cout << table;
}
}

//------------------------------------------------------------------------------
void RunCommand(const Arguments& arguments)
{
  switch (arguments.Do)
  {
    case Action::List:
      std::cout << TechniqueListText(arguments.Json);
      break;
    case Action::Render:
      RunRender(arguments);
      break;
    case Action::Compare:
      RunCompare(arguments);
      break;
    case Action::Bench:
      RunBench(arguments);
      break;
    case Action::Run:
      RunProgram(ChooseTechniqueOf(arguments), arguments.Always, arguments.Program);
      break;
    case Action::Schema:
      std::cout << (arguments.Schema == "histogram" ? Embedded::HistogramSchema : Embedded::SceneSchema);
      break;
    case Action::Storage:
      RunStorage(arguments);
      break;
    case Action::Trace:
      RunTrace(arguments);
      break;
    case Action::Probe:
      RunProbe(arguments);
      break;
  }
}
