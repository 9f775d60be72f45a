// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyFrameShaders
 *
 * The shaders of one frame: the text that goes into those of mappers, and the programs that run over the screen. All
 * are put together from the same defines, which follow from what the frame draws and where it keeps it.
 */
#ifndef vtkTranslucencyFrameShaders_h
#define vtkTranslucencyFrameShaders_h

#include "vtkTranslucencyShader.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkFragmentStorage;
class vtkObject;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkShaderProgram;
class vtkTranslucencyPass;
struct vtkTranslucencyGathering;
struct vtkTranslucencyResources;

class vtkTranslucencyFrameShaders
{
public:
  vtkTranslucencyFrameShaders(vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window, int criticalSection);

  using Defines = vtkTranslucencyShader::Defines;

  /// What the defines follow from.
  struct Context
  {
    vtkFragmentStorage* Storage = nullptr; ///< of fragments, if they are stored
    int Channels = 1;                      ///< that transmittances are told apart by
    bool TakesMean = false;                ///< of transmission colours, of which there are some
    bool ShadesSurfaces = false;           ///< whether materials change surfaces
    bool Absorbs = false;                  ///< whether there are bodies whose absorption is drawn
    int Samples = 1;                       ///< of a pixel that are told apart
    int TargetSamples = 1;                 ///< that it has
    int RecordTargets = 0;                 ///< colours in which records of pixels lie, if they lie in colours
  };
  /// The samples of what is bound. Where storage tells them apart, which wants their masks, one, with a warning in the
  /// pass's name, if the driver has none.
  void ChooseSamples(vtkObject* pass, bool storage);

  /// What is drawn of a state's transmission colours and materials.
  void ChooseTransmission(vtkTranslucencyPass* pass, const vtkRenderState* state);

  Context& GetContext() { return this->Current; }
  const Context& GetContext() const { return this->Current; }

  /// The file of Shaders/CriticalSection.
  std::string GetCriticalSection() const;

  /// Gives the mappers the text that stores fragments, and that for volumes. False, with the reason in GetError(), if
  /// it does not compile.
  bool PrepareStoring();

  /// The same for a technique without lists.
  bool PrepareGathering(const vtkTranslucencyGathering& gathering);

  /// Makes a program ready. Null, with the reason in GetError(), if it does not compile.
  vtkShaderProgram* PrepareProgram(const std::string& vertexFile, const std::string& file, const Defines& defines);

  /// The program that draws a layer of a prop as a mapper draws its fragments (vtkTranslucencyLayers).
  vtkShaderProgram* PrepareHandOver();

  const std::string& GetError() const { return this->Error; }

private:
  Defines GetOfferedDefines() const;
  vtkTranslucencyShader::Selection GetSelection() const;
  std::string GetColorText() const;
  bool Fail(const std::string& error);

  vtkTranslucencyResources& Resources;
  vtkOpenGLRenderWindow* Window;
  int CriticalSection;
  Context Current;
  std::string Error;
};
VTK_ABI_NAMESPACE_END

#endif
