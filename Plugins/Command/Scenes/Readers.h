// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files, through VTK's readers and importers.
 */
#ifndef Readers_h
#define Readers_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkDataSet;

/// What a file holds: one data set, or actors with materials of their own.
struct FileContents
{
  vtkSmartPointer<vtkDataSet> Data;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

/// Reads a file by its suffix; throws Failure, also where the reader only complains, writes to stderr, exits or
/// crashes.
FileContents ReadFile(const std::string& file);

/// ".vtp .vtu ..."
std::string ReadableSuffixes();

#endif
