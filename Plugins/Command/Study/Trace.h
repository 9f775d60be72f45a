// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Traces: the translucent fragments of one or more frames, in the order in which each pixel's were drawn.
 *
 * .csv: the line "# size WIDTHxHEIGHT", the line "frame,x,y,z,r,g,b,a" (columns may stand in another order), and a line
 * a fragment: the number of its frame, its pixel from the lower left corner, its window depth, 0 to 1, its colour, 0 or
 * more, not multiplied by the opacity, and its opacity, 0 to 1. Frames come one after the other, their numbers grow.
 *
 * .trace: the same, little endian: the eight bytes "FRAGMENT", then as 32-bit integers the version, 1, width, height
 * and the number of frames; for each frame its number in 32 bits and its fragments in 64; and 24 bytes a fragment: x
 * and y as 16-bit integers, z, r, g, b and a as 32-bit floats.
 */
#ifndef Trace_h
#define Trace_h

#include "vtkStorageSimulator.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

struct TraceFrame
{
  unsigned int Number = 0;
  std::vector<vtkStorageSimulator::Fragment> Fragments;
};

struct Trace
{
  std::array<int, 2> Size{ { 0, 0 } };
  std::vector<TraceFrame> Frames; ///< at least one, each with at least one fragment
};

/// True if the file's suffix is that of a trace.
bool IsTrace(const std::filesystem::path& file);

/// Throws Failure unless traces of the file's suffix can be written.
void CheckTraceSuffix(const std::filesystem::path& file);

/// Throws Failure that names file, line or record, value, and what was expected.
Trace ReadTrace(const std::string& file);

/// Writes .csv or .trace. Throws Failure; name is what to call the file in it.
void WriteTrace(const Trace& trace, const std::filesystem::path& file, const std::string& name);

#endif
