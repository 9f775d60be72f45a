// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMBufferStorage
 * @brief   the M-buffer: a section of fragments for every pixel, and more where one is not enough
 *
 * The storage of the weight-factor algorithm, as the T-buffer's paper describes it (section 2.3.2): W x H sections of
 * as many fragments as a pixel holds on average, section i for pixel i; behind them those that pixels take when theirs
 * is full; a pointer memory with an entry a section.
 *
 * Bytes per pixel: 4 and SectionLength times 12 (8 with RGBA8), whether it holds anything or not; a section more takes
 * as much.
 *
 * The paper's pointers lead from a pixel's own section to the others; here a pixel's entry names the one that is being
 * filled, and its own comes last (Shaders/Storage/SectionPlaces.glsl).
 */
#ifndef vtkMBufferStorage_h
#define vtkMBufferStorage_h

#include "vtkSectionStorage.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkMBufferStorage : public vtkSectionStorage
{
public:
  static vtkMBufferStorage* New();
  vtkTypeMacro(vtkMBufferStorage, vtkSectionStorage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether SectionLength follows the scene: the mean of the fragments of those pixels that hold any, in the last
   * frames (default). A new length takes new shaders, so it stays as it is while the mean is less than three quarters
   * away from it. SetSectionLength turns this off.
   */
  void SetAutomaticSectionLength(bool automatic);
  vtkGetMacro(AutomaticSectionLength, bool);
  vtkBooleanMacro(AutomaticSectionLength, bool);
  ///@}

  void SetSectionLength(int fragments) override;

  const char* GetName() const override { return "m-buffer"; }
  void BeginFrame(const std::vector<Box>& boxes, const vtkTranslucencyCapabilities& capabilities) override;

protected:
  vtkMBufferStorage() = default;
  ~vtkMBufferStorage() override = default;

  int GetPixelFragments() const override { return this->SectionLength; }
  void Learn(const std::vector<unsigned int>& cells) override;

private:
  vtkMBufferStorage(const vtkMBufferStorage&) = delete;
  void operator=(const vtkMBufferStorage&) = delete;

  bool AutomaticSectionLength = true;
  vtkTypeInt64 LastFragments = 0; // of the last frame's tiles,
  vtkTypeInt64 LastPixels = 0;    // and the pixels that hold them
};
VTK_ABI_NAMESPACE_END

#endif
