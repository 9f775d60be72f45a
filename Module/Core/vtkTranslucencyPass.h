// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyPass
 * @brief   draws translucent polygonal geometry right, whatever the order in which it is drawn
 *
 * The base of all techniques. It stands where vtkDepthPeelingPass would stand, as the translucent pass of a
 * vtkRenderStepsPass, or alone as a renderer's pass (then it draws lights, opaque geometry, volumes, overlays and the
 * renderer's effects too):
 *
 * @code
 * vtkNew<vtkAdaptiveTransparencyPass> pass;
 * renderer->SetPass(pass);
 * @endcode
 *
 * One frame:
 * 1. Opaque geometry is already in the framebuffer that is bound; that framebuffer stays bound, so that the depth test
 *    rejects what lies behind it before it is shaded.
 * 2. Gather: the translucent props are drawn with one call added to their shaders, which gives each fragment's colour,
 *    opacity and depth to the technique. No colour and no depth is written.
 * 3. Resolve: a full-screen pass turns what was gathered into colour and total transmittance.
 * 4. Composite: blending puts that over the opaque picture. The GL state is then as it was found.
 *
 * A subclass says what happens in RenderStages, in terms of vtkTranslucencyFrame; it has a folder of shaders and a row
 * in vtkTranslucencyFactory, and nothing else has to know it.
 *
 * Within other passes it draws to the first colour attachment of the framebuffer that it finds, and leaves the others
 * and the opaque depth as they are. So what translucent surfaces cover is, to passes that look at depths, positions or
 * normals (vtkEDLShading, vtkDepthOfFieldPass, vtkSSAOPass), as if they were not there: outlines, focus and occlusion
 * are those of what is opaque, and darken or blur the translucent surfaces before it along with it. (VTK's own
 * translucent pass lets vtkSSAOPass take the position of whichever surface was drawn last.)
 *
 * Some props draw by shaders that the call of stage 2 can't get into: those of actors of their own, to which they don't
 * hand their property keys on, or a whole shader of the user's. Each of them is drawn by itself, once for each of its
 * layers, and its fragments are given to the technique from there, with one warning that names the prop
 * (vtkTranslucencyUnreached, vtkTranslucencyLayers): all techniques draw them where they are, with up to 255 layers a
 * pixel.
 *
 * Where the driver lacks what a technique needs, the frame is drawn by depth peeling (vtkDepthPeelPass, which needs
 * least) or, failing that, by VTK's depth peeling or plain blending, with one warning that names what is missing;
 * GetStatistics()->GetFallback() tells which.
 * During hardware selection the geometry is drawn plainly.
 */
#ifndef vtkTranslucencyPass_h
#define vtkTranslucencyPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <memory> // for Internals
#include <string> // for options
#include <vector> // for options

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationDoubleVectorKey;
class vtkOpenGLRenderWindow;
class vtkTranslucencyFrame;
class vtkTranslucencyStatistics;
class vtkWindow;
struct vtkTranslucencyCapabilities;
struct vtkTranslucencyOption;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkTranslucencyPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * The pass that draws the translucent props, a vtkTranslucentPass by default.
   */
  void SetTranslucentPass(vtkRenderPass* pass);
  vtkGetObjectMacro(TranslucentPass, vtkRenderPass);
  ///@}

  ///@{
  /**
   * The pass that draws volumes among the translucent props, each where it lies: a vtkVolumetricPass, or null (the
   * default) where something else draws them, as vtkRenderStepsPass does after its translucent pass. Where this pass
   * draws alone it draws volumes in any case. Volumes that can't be divided at surfaces are drawn over them, after a
   * warning that names them: all but those of vtkGPUVolumeRayCastMapper (and the mappers that use it) with an
   * ImageSampleDistance of 1.
   */
  void SetVolumetricPass(vtkRenderPass* pass);
  vtkGetObjectMacro(VolumetricPass, vtkRenderPass);
  ///@}

  enum CriticalSectionType
  {
    Automatic = 0,
    Interlock = 1,
    Spinlock = 2,
    Unprotected = 3
  };

  ///@{
  /**
   * How fragments of one pixel are kept from changing its record at the same time, where a technique keeps records of
   * bounded size (Shaders/CriticalSection): Automatic (the default) takes Unprotected on software rasterizers, which
   * shade them one after the other, Interlock where the driver has an extension for it, and Spinlock elsewhere.
   * Interlock keeps the order of drawing, Spinlock does not, and wants GL_ARB_ES3_1_compatibility, so that helper
   * invocations don't wait. Unprotected on a GPU loses fragments: for trials. Another value is an error and changes
   * nothing.
   */
  void SetCriticalSection(int section);
  vtkGetMacro(CriticalSection, int);
  ///@}

  ///@{
  /**
   * Whether the stages are timed. Off by default: it waits for the GPU at each stage's end.
   */
  vtkSetMacro(MeasureTimes, bool);
  vtkGetMacro(MeasureTimes, bool);
  vtkBooleanMacro(MeasureTimes, bool);
  ///@}

  /**
   * What the last frame drew and cost. Asking waits for that frame to end; the window's context must be current, as it
   * is after Render().
   */
  vtkTranslucencyStatistics* GetStatistics();

  ///@{
  /**
   * The technique's options by keyword, as every user interface sees them: the properties of this class, of its
   * subclass and of its storage. SetOption returns false, after an error that names the option and the values it takes,
   * if there is no such option or the value is not one of its.
   */
  bool SetOption(const std::string& keyword, const std::string& value);
  std::string GetOption(const std::string& keyword);
  int GetNumberOfOptions();
  std::string GetOptionKeyword(int index);
  std::string GetOptionHelp(int index);
  ///@}

  /**
   * The declarations behind the options: not wrapped, for C++ interfaces that want ranges, defaults and types.
   */
  virtual std::vector<vtkTranslucencyOption> GetOptions();

  ///@{
  /**
   * Empty if the driver behind the window can run this technique, with its present options, else what it lacks. The
   * window's context must be current. The same of a driver that has an OpenGL of this version, and nothing beyond it.
   */
  std::string GetMissing(vtkOpenGLRenderWindow* window);
  std::string GetMissing(int major, int minor);
  ///@}

  ///@{
  /**
   * What a prop's translucent surfaces let through of red, green and blue, each from 0 to 1: a surface of opacity a and
   * transmission colour t hides a * (1 - t) of what lies behind it. Black, the default, is a surface as VTK has it,
   * such as gauze, which hides what it covers; red is a red filter, which leaves the red of what lies behind; white
   * hides nothing, and only adds its own colour, times a. (The survey in Real-Time Rendering, 4th edition, section 5.5,
   * tells the two kinds apart; coverage and transmission as in McGuire and Mara 2017, "Phenomenological transparency".)
   * The prop must be translucent by its opacity or by vtkActor::ForceTranslucentOn; of an assembly, it is the
   * assembly's. The splats of a vtkPointGaussianMapper that is Emissive, as it is by default, only add light in VTK,
   * too: they are white while the key is not set.
   *
   * Techniques that keep one transmittance, not three, take the mean and warn (KeepsTransmissionColors). Volumes, and
   * the fallbacks of passes that can't draw, have no transmission colours.
   *
   * They live in the prop's property keys, TRANSMISSION_COLOR. A number outside 0 to 1 or NaN is an error and changes
   * nothing. GetTransmissionColor gives false if the key, set in another way, is not three such numbers.
   */
  static vtkInformationDoubleVectorKey* TRANSMISSION_COLOR();
  static void SetTransmissionColor(vtkProp* prop, double red, double green, double blue);
  static bool GetTransmissionColor(vtkProp* prop, double color[3]);
  ///@}

  /**
   * Whether the technique, with its present options, keeps a transmittance of red, green and blue each.
   */
  virtual bool KeepsTransmissionColors() const { return false; }

  /**
   * Whether the technique, with its present options, keeps all fragments of a pixel: volumes are divided at them, and
   * bodies absorb by their thickness (vtkTranslucencyMaterial). If not, volumes are drawn over the surfaces, after a
   * warning.
   */
  virtual bool KeepsFragments() const { return false; }

protected:
  vtkTranslucencyPass();
  ~vtkTranslucencyPass() override;

  /**
   * The technique: gathers and resolves the frame's current tile. False if a stage failed, which the frame has
   * reported.
   */
  virtual bool RenderStages(vtkTranslucencyFrame& frame) = 0;

  /**
   * Draws the translucent props, and volumes by a pass that may be null: a frame of the technique, or its fallback. For
   * a pass that has others draw in its place.
   */
  virtual void RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass);

  /**
   * Whether the technique, with its present options, keeps fragments, or records of pixels, in storage buffers. If not
   * it draws to targets, or over the picture, which each driver can.
   */
  virtual bool UsesStorage(const vtkTranslucencyCapabilities& capabilities) const;

  /**
   * What a driver lacks, empty if nothing: here, what storage needs, or targets.
   */
  virtual std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const;

  /**
   * The option critical_section, and what a driver lacks for its value: for techniques that keep records of pixels.
   */
  vtkTranslucencyOption GetCriticalSectionOption();
  std::string FindMissingForCriticalSection(const vtkTranslucencyCapabilities& capabilities) const;

  /**
   * What the driver behind the window can do.
   */
  const vtkTranslucencyCapabilities& GetCapabilities(vtkOpenGLRenderWindow* window);

  /**
   * Bytes of graphics memory that the subclass holds, and the release of it. Where the context is gone, only handles
   * are left to forget. A subclass that holds any calls ReleaseGraphicsResources(nullptr) in its destructor.
   */
  virtual vtkTypeInt64 GetTechniqueBytes() { return 0; }
  virtual void ReleaseTechniqueResources(bool vtkNotUsed(contextAlive)) {}

  vtkRenderPass* TranslucentPass = nullptr;
  vtkRenderPass* VolumetricPass = nullptr;
  bool MeasureTimes = false;
  int CriticalSection = Automatic;
  bool HasStorage = true; // of the driver that has drawn last; true before

private:
  vtkTranslucencyPass(const vtkTranslucencyPass&) = delete;
  void operator=(const vtkTranslucencyPass&) = delete;

  void RenderAlone(const vtkRenderState* state);
  void RenderGathered(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
  // Draws all tiles. Gives what went wrong; whole becomes whether that was before anything was composited.
  std::string RenderTiles(const vtkRenderState* state, vtkOpenGLRenderWindow* window, bool& whole);
  // Whether props were met that the text doesn't reach; those are known from then on.
  bool FindUnreached(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
  // Says why, once: a warning if the driver lacks something, an error if something went wrong.
  void SayFallback(const std::string& reason, bool lacking, const std::string& instead);
  void RenderFallback(
    const vtkRenderState* state, vtkRenderPass* volumetricPass, const std::string& reason, bool lacking);
  void RenderByVTK(const vtkRenderState* state, vtkRenderPass* volumetricPass, const std::string& reason, bool lacking);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
