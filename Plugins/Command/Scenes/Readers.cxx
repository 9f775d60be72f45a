// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Basics/Failure.h"
#include "Basics/Messages.h"
#include "Basics/Suffix.h"
#include "GltfImporter.h"
#include "ReadGuard.h"
#include "Scene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetReader.h"
#include "vtkMapper.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVRMLImporter.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{
template <typename Reader>
FileContents ReadData(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  FileContents contents;
  contents.Data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  return contents;
}

template <typename Importer>
FileContents Import(const std::string& file)
{
  vtkNew<vtkRenderWindow> window; // importers want one; nothing is drawn in it
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<Importer> importer;
  importer->SetFileName(file.c_str());
  importer->SetRenderWindow(window);
  importer->Update();

  FileContents contents;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator position;
  actors->InitTraversal(position);
  while (vtkActor* actor = actors->GetNextActor(position))
  {
    if (!actor->GetMapper())
    {
      continue;
    }
    actor->GetMapper()->Update();
    auto* surface = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    if (surface && surface->GetNumberOfCells() > 0)
    {
      CheckSurface(file, surface);
      contents.Actors.push_back(actor);
    }
  }
  return contents;
}

// VTK's reader takes as many triangles as there are and says nothing of those that are missing. A binary file says
// how many it holds, each of 50 bytes, after a heading of 80.
FileContents ReadTriangles(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::array<char, 84> heading{};
  in.read(heading.data(), heading.size());
  const bool text = std::strncmp(heading.data(), "solid", 5) == 0;
  std::uint32_t count = 0;
  std::memcpy(&count, heading.data() + 80, sizeof(count));
  vtkByteSwap::Swap4LE(&count);
  const std::uintmax_t expected = 84 + 50 * static_cast<std::uintmax_t>(count);
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (!text && size < expected)
  {
    throw Failure(file + ": has " + std::to_string(size) + " bytes, expected " + std::to_string(expected) +
      " for its " + std::to_string(count) + " triangles");
  }
  return ReadData<vtkSTLReader>(file);
}

struct Format
{
  const char* Suffix;
  FileContents (*Read)(const std::string& file);
  bool Strict = false; // the reader only warns where it should fail
};

const Format Formats[] = {
  { ".vtp", ReadData<vtkXMLPolyDataReader> },
  { ".vtu", ReadData<vtkXMLUnstructuredGridReader> },
  { ".vtk", ReadData<vtkDataSetReader>, true },
  { ".vti", ReadData<vtkXMLImageDataReader> },
  { ".mhd", ReadData<vtkMetaImageReader> },
  { ".ply", ReadData<vtkPLYReader> },
  { ".stl", ReadTriangles },
  { ".obj", ReadData<vtkOBJReader> },
  { ".wrl", Import<vtkVRMLImporter> },
  { ".glb", Import<GltfImporter> },
};

const Format& FindFormat(const std::string& file)
{
  const std::string suffix = SuffixOf(file);
  for (const Format& format : Formats)
  {
    if (suffix == format.Suffix)
    {
      return format;
    }
  }
  throw Failure(file + ": has the suffix '" + suffix + "', expected one of " + ReadableSuffixes());
}

// Filters believe what cells say of their points.
void CheckCells(const std::string& file, vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfConnectivityIds() == 0)
  {
    return;
  }
  double range[2];
  cells->GetConnectivityArray()->GetRange(range);
  if (range[0] < 0 || range[1] >= static_cast<double>(points))
  {
    const auto wrong = static_cast<long long>(range[0] < 0 ? range[0] : range[1]);
    throw Failure(
      file + ": a cell has point " + std::to_string(wrong) + ", expected 0 to " + std::to_string(points - 1));
  }
}

// VTK's PLY reader of 9.6 gives polygons of no points for those that the end of a file has cut off, and says nothing.
void CheckSizes(const std::string& file, vtkCellArray* cells)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    if (cells->GetCellSize(cell) == 0)
    {
      throw Failure(file + ": a cell has no points, expected at least one; the file may be cut off");
    }
  }
}

void CheckData(const std::string& file, vtkDataSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells : { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
    {
      CheckCells(file, cells, points);
      CheckSizes(file, cells);
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    CheckCells(file, grid->GetCells(), points);
  }
}

void CheckFile(const std::string& file)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    throw Failure(file + ": there is no such file");
  }
  if (!std::filesystem::is_regular_file(file, error))
  {
    throw Failure(file + ": is not a file, expected one of " + ReadableSuffixes());
  }
  if (std::filesystem::file_size(file, error) == 0)
  {
    throw Failure(file + ": is empty");
  }
}

FileContents ReadGuarded(const Format& format, const std::string& file)
{
  const std::string what = file + ": can't be read as " + format.Suffix;
  ReadGuard guard(what, format.Strict);
  FileContents contents;
  try
  {
    contents = format.Read(file);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(what + ": " + error.what());
  }
  guard.Finish();
  return contents;
}
}

//------------------------------------------------------------------------------
FileContents ReadFile(const std::string& file)
{
  const Format& format = FindFormat(file);
  CheckFile(file);
  Messages::Get()->ThrowError("before " + file);
  const FileContents contents = ReadGuarded(format, file);
  const bool empty = contents.Actors.empty() && (!contents.Data || contents.Data->GetNumberOfPoints() == 0);
  if (empty)
  {
    throw Failure(file + ": has no cells, expected at least one");
  }
  if (contents.Data)
  {
    CheckData(file, contents.Data);
  }
  return contents;
}

//------------------------------------------------------------------------------
std::string ReadableSuffixes()
{
  std::string suffixes;
  for (const Format& format : Formats)
  {
    suffixes += (suffixes.empty() ? "" : " ") + std::string(format.Suffix);
  }
  return suffixes;
}
