// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentListPass
 * @brief   a technique that keeps all fragments and resolves them in one full-screen pass
 *
 * What the variable-memory techniques share: the storage that holds the fragments, and the stages "gather, resolve".
 */
#ifndef vtkFragmentListPass_h
#define vtkFragmentListPass_h

#include "vtkFragmentStorage.h"   // for Storage
#include "vtkSmartPointer.h"      // for Storage
#include "vtkTranslucencyFrame.h" // for Squares
#include "vtkTranslucencyPass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkFragmentListPass : public vtkTranslucencyPass
{
public:
  vtkTypeMacro(vtkFragmentListPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the fragments lie: a vtkLinkedListStorage by default. A storage serves one pass; null is an error.
   */
  void SetStorage(vtkFragmentStorage* storage);
  vtkFragmentStorage* GetStorage();
  ///@}

  enum StorageDesignType
  {
    LinkedList = 0,
    TBuffer = 1,
    RBuffer = 2,
    MBuffer = 3
  };

  ///@{
  /**
   * The design of the storage (in the order of vtkStorageTable): LinkedList (the default), TBuffer, RBuffer or
   * MBuffer. Another design makes a new storage, with the colour format and the memory limit of the one before. Another
   * value is an error and changes nothing. -1 where SetStorage has given one of none of these designs.
   */
  void SetStorageDesign(int design);
  int GetStorageDesign();
  ///@}

  ///@{
  /**
   * How many fragments a section of the T-buffer or the M-buffer holds, 1 to 64; 4 by default, but for the M-buffer,
   * which follows the scene until this is set. Set for a storage that has no sections, it does nothing, and drawing
   * warns of it. A value out of range is an error and changes nothing.
   */
  void SetSectionLength(int fragments);
  vtkGetMacro(SectionLength, int);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsFragments() const override { return true; }

protected:
  vtkFragmentListPass();
  ~vtkFragmentListPass() override;

  /**
   * The levels of the resolves (see Shaders/Common/Statistics.glsl).
   */
  enum Level
  {
    Short = 0,            // up to 8, 16 and 32 fragments, in registers: 0, 1, 2
    Technique = 3,        // the subclass's own
    ShortEqualDepths = 4, // short lists with fragments of equal depth
    Runs = 5,             // up to 256 fragments, exactly
    Long = 6,             // any number of fragments, exactly
    TechniqueMore = 7     // and above: for pixels that the subclass leaves to itself
  };

  /**
   * A level as shaders write it.
   */
  static std::string LevelText(int level);

  /**
   * Draws, exactly and in registers, pixels of few fragments: up to 8, 16 and 32, as far as that is not more than most.
   * Longer lists are left to a level; rest is that level and the squares that are full of them. All samples of these
   * pixels are drawn at once: where a single sample is resolved, rest is everything.
   */
  bool ResolveShortLists(vtkTranslucencyFrame& frame, int most, int longer, vtkTranslucencyFrame::Squares& rest);

  /**
   * Draws, exactly, what earlier resolves have left to ShortEqualDepths and to Long: there is no limit to the fragments
   * of a pixel, whatever registers and a driver's loops can take. The last resolve of every technique.
   */
  bool ResolveLeftLists(vtkTranslucencyFrame& frame);

  /**
   * What is done with the fragments of the current tile before they are resolved: for passes that look at them.
   */
  virtual bool UseLists(vtkTranslucencyFrame& vtkNotUsed(frame)) { return true; }

  /**
   * Draws what the storage holds of the current tile: the resolves of the technique, which see the whole pixel or one
   * sample of it.
   */
  virtual bool ResolveLists(vtkTranslucencyFrame& frame) = 0;

  /**
   * The T-buffer and the M-buffer want one extension more where fragments of a pixel come in any order.
   */
  std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const override;
  bool UsesStorage(const vtkTranslucencyCapabilities& capabilities) const override;
  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  vtkSmartPointer<vtkFragmentStorage> Storage;

private:
  void UseSectionLength();
  bool ResolveEachSample(vtkTranslucencyFrame& frame);

  int SectionLength = 4;
  bool SectionLengthGiven = false;
  bool SectionLengthWarned = false;

  int LargestBlock = 0; // of the short lists in this tile

  vtkFragmentListPass(const vtkFragmentListPass&) = delete;
  void operator=(const vtkFragmentListPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
