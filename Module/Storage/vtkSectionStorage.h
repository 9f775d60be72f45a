// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSectionStorage
 * @brief   fragments of a pixel in sections, one behind the other: what T-buffer and M-buffer share
 *
 * - entries, 4 bytes per pixel: the section that is being filled, and how far; 0 if there is none
 * - fragments, 12 bytes (HalfFloat) or 8 (RGBA8) each: depth, colour; 4 more with transmission colours, 4 in
 * multi-sampled windows
 * - next sections, 4 bytes per section: the section that was filled before
 * - links, 4 bytes per fragment: only where fragments are sorted where they lie (pixels of more than 32), or volumes
 * are between them
 *
 * Fragments come in the reverse order of drawing, as from linked lists, and without the link that each of those has:
 * the next one lies beside it. What is lost instead is the room in sections that are not full.
 * Shaders/Storage/Sections.glsl has the rest, and how it stands concurrent drawing.
 */
#ifndef vtkSectionStorage_h
#define vtkSectionStorage_h

#include "vtkCellStorage.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkSectionStorage : public vtkCellStorage
{
public:
  vtkTypeMacro(vtkSectionStorage, vtkCellStorage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    LongestSection = 64
  };

  ///@{
  /**
   * How many fragments a section holds, 1 to 64. A value out of range is an error and changes nothing.
   */
  virtual void SetSectionLength(int fragments);
  vtkGetMacro(SectionLength, int);
  ///@}

  int GetSectionFragments() const override { return this->SectionLength; }
  std::map<std::string, std::string> GetDefines() const override;

protected:
  vtkSectionStorage() = default;
  ~vtkSectionStorage() override = default;

  /// Bits of the number of free places in a section.
  int GetFreeBits() const;

  /// From the next tile on.
  void UseSectionLength(int fragments);

  const char* GetFileName() const override;
  std::vector<Layout> GetLayouts() const override;
  int GetUnitFragments() const override { return this->SectionLength; }
  vtkTypeInt64 GetMostUnits(const Rectangle& tile) const override;
  unsigned int CountFree(const unsigned int* entries, int count) const override;

  int SectionLength = 4;

private:
  vtkSectionStorage(const vtkSectionStorage&) = delete;
  void operator=(const vtkSectionStorage&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
