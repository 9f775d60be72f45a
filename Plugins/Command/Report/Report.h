// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What compare and bench have found out, as text and as JSON.
 */
#ifndef Report_h
#define Report_h

#include "Techniques/Benchmark.h"
#include "Techniques/Picture.h"

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

struct ReportRow
{
  TechniqueChoice Technique;
  std::string Help;
  Timing Times;
  std::optional<Difference> ToReference; ///< compare only; none for the reference itself
  std::string PictureFile;               ///< compare only, beside the report
  std::string DifferenceFile;            ///< compare only; empty for the reference
};

struct Report
{
  std::string Title;
  std::vector<std::string> Inputs;
  std::array<int, 2> Size{ { 0, 0 } };
  int Samples = 1; ///< of a pixel
  std::string Driver;
  std::size_t Actors = 0;
  long long Triangles = 0;
  BenchmarkSettings Settings;
  std::string Reference; ///< its label; empty in bench
  std::vector<ReportRow> Rows;
};

/// One line a technique, with a heading.
std::string ToText(const Report& report);

/// Everything; README.md beside this file says what the keys mean.
nlohmann::ordered_json ToJson(const Report& report);

/// What JSON says of a technique as it was asked for; help is what it is.
nlohmann::ordered_json ToJson(const TechniqueChoice& technique, const std::string& help);

/// Rows of cells under headings, the first column to the left, the others to the right.
std::string Aligned(const std::vector<std::vector<std::string>>& rows);

/// "3,700,000"
std::string Grouped(long long number);

/// With that many digits after the point.
std::string Fixed(double number, int digits);

#endif
