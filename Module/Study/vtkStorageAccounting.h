// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStorageAccounting
 *
 * What designs of fragment storage take for a frame, in bytes and in accesses to memory, in closed form, from nothing
 * but how many pixels hold how many fragments: the evaluation of the T-buffer's paper ("T-buffer", section 4: Table 2
 * and the sums behind it), for hardware that keeps fragments as tightly as its fields allow.
 *
 * - Linked list: a node a fragment, with the address of the next one; a table with the first one of each pixel.
 * - T-buffer: the same with sections of several fragments; the start-section table and the next-section table hold the
 * addresses.
 * - R-buffer: fragments of all pixels in one FIFO, with their coordinates; what is read and is not the farthest of its
 * pixel goes in again. A second depth buffer and the pixels' states tell which one is.
 * - M-buffer: each pixel has a section from the start, and more behind those of all pixels where it needs them; a
 * pointer a section.
 *
 * With L fragments a section (L is 1 for linked lists), N_i pixels of i fragments, F fragments, P pixels that hold any,
 * WxH pixels, a, f, c, z and s the bits of an address, of a fragment (depth and colour), of a coordinate, of a depth
 * and of a state:
 *
 *                sections                              bits                                 reads other accesses linked
 * list  F                                     WH a + F (f + a)                     F                          table: P
 *   T-buffer     sum N_i ceil(i / L)                   WH a + sections (L f + a)            F table: P R-buffer     0
 * F (f + 2 c) + WH z + WH s            sum N_i i (i + 1) / 2      second depth buffer: reads, frame buffer: F M-buffer
 * WH + sum N_i max(0, ceil(i / L) - 1)  sections (L f + a)                   F                          none
 *
 * and F stores each. As in the paper, addresses that are looked up for a fragment that is being stored are not counted,
 * nor are those that are read together with a section: next sections, and the M-buffer's pointers.
 *
 * The paper gives no sizes of fields. With those below, an automatic address, and 640x480 pixels, its Table 1 gives the
 * T-buffer 28.8 % less storage than the R-buffer (the paper: 29 %), 68 % less than the M-buffer (67 %), 51.5 % fewer
 * accesses (52 %), and 28.4 % more (27 %). Sizes in whole bytes come as close for storage against the R-buffer: 8 a
 * fragment, 11 in the R-buffer, 2 an address give 28.7 %.
 */
#ifndef vtkStorageAccounting_h
#define vtkStorageAccounting_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkStorageDesign.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStorageAccounting
{
public:
  using Design = vtkStorageDesign::Kind;
  using Accesses = vtkStorageDesign::Accesses;

  /// How many pixels of a frame hold how many fragments.
  struct Histogram
  {
    int Width = 0;
    int Height = 0;
    std::map<std::int64_t, std::int64_t> Pixels; ///< by the number of their fragments, 1 or more

    std::int64_t GetFragments() const;
    std::int64_t GetPixels() const; ///< that hold fragments
  };

  /// Bits of the fields, 1 to 64.
  struct Packing
  {
    int Coordinate = 16; ///< x, and y: of the R-buffer's fragments
    int Depth = 32;      ///< of a fragment, and of the second depth buffer
    int Color = 32;      ///< with the opacity
    int State = 3;       ///< of a pixel: the R-buffer's
    int Address = 0;     ///< 0: as few as tell the sections of the fullest frame, and none, apart
  };

  struct Settings
  {
    Packing Bits;
    int TSectionLength = 2; ///< fragments in a section of the T-buffer, 1 to 64
    int MSectionLength =
      0; ///< of the M-buffer, 1 to 64; 0: the frame's mean over the pixels that hold any, rounded, 1 or more
  };

  /// A design as it is built for a frame.
  struct Layout
  {
    Design Kind = Design::LinkedList;
    int Width = 0;
    int Height = 0;
    std::int64_t SectionLength = 1; ///< of the T-buffer and the M-buffer
    Packing Bits;                   ///< the address is not 0
  };

  struct Cost
  {
    std::int64_t Fragments = 0;
    std::int64_t Sections = 0; ///< nodes of the linked list; 0 for the R-buffer
    double Bytes = 0;          ///< bits / 8, not rounded
    Accesses Count;
  };

  /// How much less one design takes than another, 1 for all of it, negative where it takes more.
  struct Saving
  {
    double Storage = 0;
    double Accesses = 0;
  };

  /// The most fragments of a frame: sums of accesses stay below 2^63.
  static constexpr std::int64_t MostFragments = 1000000000;

  vtkStorageAccounting(const Settings& settings, const std::vector<Histogram>& frames);

  /// Empty, or what is wrong with the settings or a frame, its value and what was expected. Then there is nothing else
  /// to ask.
  const std::string& GetError() const { return this->Error; }

  Layout GetLayout(Design design, std::size_t frame) const;
  Cost GetCost(Design design, std::size_t frame) const;

  /// The mean over the frames that hold fragments; 0 if none does.
  Saving GetSaving(Design design, Design other) const;

private:
  std::string FindError() const;
  std::int64_t GetSectionLength(Design design, const Histogram& frame) const;
  std::int64_t GetAddressed(Design design) const;

  Settings Given;
  std::vector<Histogram> Frames;
  std::string Error;
};
VTK_ABI_NAMESPACE_END

#endif
