// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"

#define CSV_IO_NO_THREAD
#include <csv.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <regex>

namespace
{
namespace fs = std::filesystem;
using Fragment = vtkStorageSimulator::Fragment;

constexpr int LargestSide = 65535; // pixels are kept in 16 bits
constexpr std::size_t FragmentsAStep = 1 << 20;
const char Magic[] = { 'F', 'R', 'A', 'G', 'M', 'E', 'N', 'T' };
constexpr std::uint32_t Version = 1;

const char* const Suffixes = ".csv or .trace";
const char* const Columns = "frame,x,y,z,r,g,b,a";

// What a value may be.
struct Range
{
  double Least;
  double Most;
  const char* Expected;
};
const Range Depths{ 0, 1, "a number in 0..1" };
const Range Colors{ 0, std::numeric_limits<float>::max(), "a finite number, 0 or more" };

std::string NumberText(float number)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), number).ptr);
}

// Throws where a value is out of its range; text is how it is written.
void CheckValue(const std::string& where, const char* what, const std::string& text, double value, const Range& range)
{
  if (!(value >= range.Least && value <= range.Most))
  {
    throw Failure(where + ": " + what + " is " + text + ", expected " + range.Expected);
  }
}

void CheckPixel(const std::string& where, const char* what, long long value, int size)
{
  if (value < 0 || value >= size)
  {
    throw Failure(where + ": " + what + " is " + std::to_string(value) + ", expected a pixel of the frame, 0 to " +
      std::to_string(size - 1));
  }
}

void CheckFragment(const std::string& where, const Fragment& fragment, const std::array<int, 2>& size)
{
  CheckPixel(where, "x", fragment.X, size[0]);
  CheckPixel(where, "y", fragment.Y, size[1]);
  CheckValue(where, "z", NumberText(fragment.Depth), fragment.Depth, Depths);
  const char* names[] = { "r", "g", "b", "a" };
  for (int i = 0; i < 4; ++i)
  {
    CheckValue(where, names[i], NumberText(fragment.Color[i]), fragment.Color[i], i < 3 ? Colors : Depths);
  }
}

void CheckSide(const std::string& where, const char* what, unsigned long long side)
{
  if (side < 1 || side > LargestSide)
  {
    throw Failure(
      where + ": " + what + " is " + std::to_string(side) + ", expected 1 to " + std::to_string(LargestSide));
  }
}

// A frame begins: its number has to be above that of the one before.
void AddFrame(const std::string& where, unsigned int number, Trace& trace)
{
  if (!trace.Frames.empty() && number <= trace.Frames.back().Number)
  {
    throw Failure(where + ": frame is " + std::to_string(number) + ", expected more than " +
      std::to_string(trace.Frames.back().Number) + ", that of the frame before");
  }
  trace.Frames.push_back({ number, {} });
}

void CheckRoom(const std::string& where, unsigned long long fragments)
{
  if (fragments > static_cast<unsigned long long>(vtkStorageAccounting::MostFragments))
  {
    throw Failure(where + ": the frame has " + std::to_string(fragments) + " fragments, expected at most " +
      std::to_string(vtkStorageAccounting::MostFragments));
  }
}

//------------------------------------------------------------------------------
// .csv
using Reader = io::CSVReader<8, io::trim_chars<' ', '\t'>>;

// A whole cell as a number.
template <typename Number>
Number Parse(const std::string& where, const char* what, const char* cell, const char* expected)
{
  Number number{};
  const char* end = cell + std::strlen(cell);
  const auto result = std::from_chars(cell, end, number);
  if (result.ec != std::errc() || result.ptr != end || cell == end)
  {
    throw Failure(where + ": " + what + " is '" + Quotable(cell) + "', expected " + expected);
  }
  return number;
}

std::array<int, 2> ReadSize(const std::string& file, Reader& reader)
{
  static const std::regex form("# size ([0-9]{1,9})x([0-9]{1,9})");
  const char* line = reader.next_line();
  std::cmatch match;
  if (!line || !std::regex_match(line, match, form))
  {
    throw Failure(file + ":1: is '" + Quotable(line ? line : "") +
      "', expected '# size WIDTHxHEIGHT', the size of the frames in pixels");
  }
  const std::array<int, 2> size{ { std::stoi(match[1]), std::stoi(match[2]) } };
  CheckSide(file + ":1", "width", static_cast<unsigned long long>(size[0]));
  CheckSide(file + ":1", "height", static_cast<unsigned long long>(size[1]));
  return size;
}

void ReadRows(const std::string& file, Reader& reader, Trace& trace)
{
  Progress progress("reading " + file);
  char* frame = nullptr;
  std::array<char*, 2> pixel{};
  std::array<char*, 5> values{}; // z, r, g, b, a
  const char* const integer = "an integer, 0 or more";
  for (std::size_t row = 0;
       reader.read_row(frame, pixel[0], pixel[1], values[0], values[1], values[2], values[3], values[4]); ++row)
  {
    if (row % FragmentsAStep == 0)
    {
      progress.Step();
    }
    const std::string where = file + ":" + std::to_string(reader.get_file_line());
    const auto number = Parse<unsigned int>(where, "frame", frame, integer);
    if (trace.Frames.empty() || number != trace.Frames.back().Number)
    {
      AddFrame(where, number, trace);
    }
    const auto value = [&](int index, const char* what, const Range& range)
    { return Parse<float>(where, what, values[index], range.Expected); };
    const Fragment fragment{ Parse<int>(where, "x", pixel[0], integer), Parse<int>(where, "y", pixel[1], integer),
      value(0, "z", Depths),
      { { value(1, "r", Colors), value(2, "g", Colors), value(3, "b", Colors), value(4, "a", Depths) } } };
    CheckFragment(where, fragment, trace.Size);
    trace.Frames.back().Fragments.push_back(fragment);
    CheckRoom(where, trace.Frames.back().Fragments.size());
  }
}

Trace ReadCsv(const std::string& file)
{
  Trace trace;
  try
  {
    Reader reader(file);
    trace.Size = ReadSize(file, reader);
    reader.read_header(io::ignore_no_column, "frame", "x", "y", "z", "r", "g", "b", "a");
    ReadRows(file, reader, trace);
  }
  catch (const io::error::base& error)
  {
    throw Failure(file + ": " + Quotable(error.what()) + " Expected the columns " + Columns);
  }
  return trace;
}

void WriteCsv(const Trace& trace, std::ostream& out)
{
  out << "# size " << trace.Size[0] << "x" << trace.Size[1] << "\n" << Columns << "\n";
  for (const TraceFrame& frame : trace.Frames)
  {
    for (const Fragment& fragment : frame.Fragments)
    {
      out << frame.Number << "," << fragment.X << "," << fragment.Y << "," << NumberText(fragment.Depth);
      for (const float channel : fragment.Color)
      {
        out << "," << NumberText(channel);
      }
      out << "\n";
    }
  }
}

//------------------------------------------------------------------------------
// .trace
constexpr std::size_t RecordBytes = 24;

template <typename Number>
void Append(std::string& bytes, Number number)
{
  for (std::size_t i = 0; i < sizeof(number); ++i)
  {
    bytes += static_cast<char>(number >> (8 * i) & 0xff);
  }
}

void Append(std::string& bytes, float number)
{
  std::uint32_t word;
  std::memcpy(&word, &number, sizeof(word));
  Append(bytes, word);
}

// Takes numbers from the start of a file on, and says where it has ended too early.
class Bytes
{
public:
  explicit Bytes(const std::string& file)
    : File(file)
    , In(file, std::ios::binary)
    , Left(fs::file_size(file))
  {
  }

  std::string GetPlace() const { return this->File + ": byte " + std::to_string(this->At); }
  std::uintmax_t GetLeft() const { return this->Left; }

  const char* Take(std::size_t count, const std::string& what)
  {
    if (this->Left < count || !this->In.read(this->Taken, static_cast<std::streamsize>(count)))
    {
      throw Failure(this->GetPlace() + ": the file ends, expected " + what);
    }
    this->Left -= count;
    this->At += count;
    return this->Taken;
  }

  template <typename Number>
  Number TakeNumber(const std::string& what)
  {
    const char* bytes = this->Take(sizeof(Number), what);
    return Read<Number>(bytes);
  }

  template <typename Number>
  static Number Read(const char*& bytes)
  {
    Number number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
    {
      number |= static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(*bytes++)) << (8 * i));
    }
    return number;
  }

  static float ReadFloat(const char*& bytes)
  {
    const auto word = Read<std::uint32_t>(bytes);
    float number;
    std::memcpy(&number, &word, sizeof(number));
    return number;
  }

private:
  std::string File;
  std::ifstream In;
  std::uintmax_t Left;
  std::uintmax_t At = 0;
  char Taken[RecordBytes] = {};
};

Fragment ToFragment(const char* record)
{
  Fragment fragment;
  fragment.X = Bytes::Read<std::uint16_t>(record);
  fragment.Y = Bytes::Read<std::uint16_t>(record);
  fragment.Depth = Bytes::ReadFloat(record);
  for (float& channel : fragment.Color)
  {
    channel = Bytes::ReadFloat(record);
  }
  return fragment;
}

void ReadFrame(const std::string& file, Bytes& bytes, Trace& trace)
{
  const std::string place = bytes.GetPlace();
  AddFrame(place, bytes.TakeNumber<std::uint32_t>("a frame's number"), trace);
  TraceFrame& frame = trace.Frames.back();
  const std::string name = "frame " + std::to_string(frame.Number);
  const std::string counted = bytes.GetPlace();
  const auto count = bytes.TakeNumber<std::uint64_t>("the number of fragments of " + name);
  if (count == 0)
  {
    throw Failure(counted + ": " + name + " has 0 fragments, expected at least one");
  }
  CheckRoom(counted, count);
  if (bytes.GetLeft() < count * RecordBytes)
  {
    throw Failure(counted + ": " + name + " has " + std::to_string(count) + " fragments, expected " +
      std::to_string(count * RecordBytes) + " bytes for them, but the file ends after " +
      std::to_string(bytes.GetLeft()));
  }
  Progress progress("reading " + file);
  frame.Fragments.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i % FragmentsAStep == 0)
    {
      progress.Step(name);
    }
    frame.Fragments.push_back(ToFragment(bytes.Take(RecordBytes, "a fragment")));
    CheckFragment(file + ": " + name + ", fragment " + std::to_string(i), frame.Fragments.back(), trace.Size);
  }
}

Trace ReadBinary(const std::string& file)
{
  Bytes bytes(file);
  if (std::memcmp(bytes.Take(sizeof(Magic), "the eight bytes 'FRAGMENT'"), Magic, sizeof(Magic)) != 0)
  {
    throw Failure(file + ": is not a trace, expected the eight bytes 'FRAGMENT' at its start");
  }
  const auto version = bytes.TakeNumber<std::uint32_t>("the version");
  if (version != Version)
  {
    throw Failure(file + ": byte 8: version is " + std::to_string(version) + ", expected " + std::to_string(Version));
  }
  Trace trace;
  for (int i = 0; i < 2; ++i)
  {
    const std::string place = bytes.GetPlace();
    const char* what = i == 0 ? "width" : "height";
    const auto side = bytes.TakeNumber<std::uint32_t>(what);
    CheckSide(place, what, side);
    trace.Size[i] = static_cast<int>(side);
  }
  const auto frames = bytes.TakeNumber<std::uint32_t>("the number of frames");
  for (std::uint32_t i = 0; i < frames; ++i)
  {
    ReadFrame(file, bytes, trace);
  }
  if (bytes.GetLeft() > 0)
  {
    throw Failure(bytes.GetPlace() + ": " + std::to_string(bytes.GetLeft()) +
      " bytes are left behind the last frame, expected none");
  }
  return trace;
}

void WriteBinary(const Trace& trace, std::ostream& out)
{
  std::string bytes(Magic, sizeof(Magic));
  Append(bytes, Version);
  Append(bytes, static_cast<std::uint32_t>(trace.Size[0]));
  Append(bytes, static_cast<std::uint32_t>(trace.Size[1]));
  Append(bytes, static_cast<std::uint32_t>(trace.Frames.size()));
  for (const TraceFrame& frame : trace.Frames)
  {
    Append(bytes, static_cast<std::uint32_t>(frame.Number));
    Append(bytes, static_cast<std::uint64_t>(frame.Fragments.size()));
    for (const Fragment& fragment : frame.Fragments)
    {
      Append(bytes, static_cast<std::uint16_t>(fragment.X));
      Append(bytes, static_cast<std::uint16_t>(fragment.Y));
      Append(bytes, fragment.Depth);
      for (const float channel : fragment.Color)
      {
        Append(bytes, channel);
      }
    }
    out << bytes;
    bytes.clear();
  }
}

// How a suffix is read and written.
struct Format
{
  const char* Suffix;
  Trace (*Read)(const std::string& file);
  void (*Write)(const Trace& trace, std::ostream& out);
};
const Format Formats[] = { { ".csv", ReadCsv, WriteCsv }, { ".trace", ReadBinary, WriteBinary } };

const Format* FindFormat(const fs::path& file)
{
  const auto* found = std::find_if(std::begin(Formats), std::end(Formats),
    [&file](const Format& format) { return file.extension() == format.Suffix; });
  return found == std::end(Formats) ? nullptr : found;
}
}

//------------------------------------------------------------------------------
bool IsTrace(const fs::path& file)
{
  return FindFormat(file) != nullptr;
}

//------------------------------------------------------------------------------
void CheckTraceSuffix(const fs::path& file)
{
  if (!IsTrace(file))
  {
    throw Failure("'" + file.string() + "' has the suffix '" + file.extension().string() + "', expected " + Suffixes);
  }
}

//------------------------------------------------------------------------------
Trace ReadTrace(const std::string& file)
{
  CheckTraceSuffix(file);
  std::error_code error;
  if (!fs::is_regular_file(file, error) || !std::ifstream(file))
  {
    throw Failure(file + ": can't be read, expected a trace");
  }
  if (fs::file_size(file) == 0)
  {
    throw Failure(file + ": is empty, expected a trace");
  }
  const Trace trace = FindFormat(file)->Read(file);
  if (trace.Frames.empty())
  {
    throw Failure(file + ": has no fragments, expected at least one");
  }
  return trace;
}

//------------------------------------------------------------------------------
void WriteTrace(const Trace& trace, const fs::path& file, const std::string& name)
{
  CheckTraceSuffix(file);
  CheckSide(name, "width", static_cast<unsigned long long>(trace.Size[0]));
  CheckSide(name, "height", static_cast<unsigned long long>(trace.Size[1]));
  for (const TraceFrame& frame : trace.Frames)
  {
    for (std::size_t i = 0; i < frame.Fragments.size(); ++i)
    {
      CheckFragment(name + ": fragment " + std::to_string(i), frame.Fragments[i], trace.Size);
    }
  }
  Progress progress("writing " + name);
  progress.Step();
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  FindFormat(file)->Write(trace, out);
  out.close();
  if (!out)
  {
    throw Failure("'" + name + "' can't be written: " + std::strerror(errno));
  }
}
