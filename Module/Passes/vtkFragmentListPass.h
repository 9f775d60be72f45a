/**
 * @class   vtkFragmentListPass
 * @brief   a technique that keeps all fragments and resolves them in one full-screen pass
 *
 * What the variable-memory techniques share: the storage that holds the fragments, and the stages "gather, resolve".
 */
#ifndef vtkFragmentListPass_h
#define vtkFragmentListPass_h

#include "vtkFragmentStorage.h" // for Storage
#include "vtkSmartPointer.h"    // for Storage
#include "vtkTranslucencyFrame.h" // for Squares
#include "vtkTranslucencyPass.h"

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

  std::vector<vtkTranslucencyOption> GetOptions() override;
  std::string GetMissing(vtkOpenGLRenderWindow* window) override;

protected:
  vtkFragmentListPass();
  ~vtkFragmentListPass() override;

  /**
   * Draws, exactly and in registers, pixels of few fragments: up to 8, 16 and 32, as far as that is not more than most. rest is
   * what is left: pixels of longer lists, and squares that are full of them.
   */
  bool ResolveShortLists(
    vtkTranslucencyFrame& frame, int most, vtkTranslucencyFrame::Squares& rest);

  /**
   * Sorts and blends, exactly, what earlier resolves have left: pixels with more fragments than registers or a driver's loops
   * can take. There is no limit to the fragments of a pixel.
   */
  bool ResolveLongLists(
    vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Squares& rest);

  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  vtkSmartPointer<vtkFragmentStorage> Storage;

private:
  vtkFragmentListPass(const vtkFragmentListPass&) = delete;
  void operator=(const vtkFragmentListPass&) = delete;
};

#endif
