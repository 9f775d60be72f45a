// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVTranslucency
 * @brief   puts a technique into one of ParaView's render views
 *
 * A view has one of them in each of its processes: the client, and every rank of the server. It is a representation,
 * since these are told by a view that they belong to it (vtkView::AddRepresentation); it draws nothing itself. The
 * server manager makes it with the view, by the definitions that WriteDefinitions.cxx writes, and hands all properties
 * named Translucency... to it.
 *
 * The technique goes below ParaView's camera pass: vtkPVSynchronizedRenderer::SetRenderPass puts it there in a process
 * that draws alone, and below vtkIceTCompositePass where ranks draw together, which a vtkPVRanksPass takes the place
 * of for the frames that it is for, where all ranks agree. So what ParaView does above that pass (composition of ranks
 * and tiles, FXAA, tone mapping, eye-dome lighting) goes on, and what the renderer does below it (SSAO, FXAA, volumes,
 * overlays, selection) is done by vtkTranslucencyFactory::CreateSteps. Ray tracing and the drawing of values have
 * passes of their own, which are left alone.
 */
#ifndef vtkPVTranslucency_h
#define vtkPVTranslucency_h

#include "vtkDataRepresentation.h"
#include "vtkPVTranslucencyViewsModule.h" // for the export macro

#include <memory> // for Internals

class vtkObject;
class vtkTranslucencyStatistics;

class VTKPVTRANSLUCENCYVIEWS_EXPORT vtkPVTranslucency : public vtkDataRepresentation
{
public:
  static vtkPVTranslucency* New();
  vtkTypeMacro(vtkPVTranslucency, vtkDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The technique, by its name in vtkTranslucencyFactory, or "None" for what ParaView draws by itself. Another name is
   * an error and changes nothing.
   */
  void SetTechnique(const char* name);

  ///@{
  /**
   * An option of a technique, which need not be the one that draws: "adaptive nodes". A name or a value that there is
   * not is an error and changes nothing.
   */
  void SetIntegerOption(const char* option, int value);
  void SetRealOption(const char* option, double value);
  void SetChoiceOption(const char* option, const char* value);
  ///@}

  /**
   * Samples per pixel of what the technique draws with, opaque surfaces included: 1 (the default) to 8. More than one
   * takes the place of FXAA. Another number is an error and changes nothing.
   */
  void SetSamples(int samples);

  /**
   * Whether the stages of a frame are timed, which waits for the GPU.
   */
  void SetMeasureTimes(bool measure);

  /**
   * The release of the plugin that has defined the view's properties, which is the server's. Another one than this is
   * an error.
   */
  void SetRelease(const char* release);

  ///@{
  /**
   * What the last frame took: vtkTranslucencyStatistics. Where ranks draw together, counts and bytes are the sum over
   * all ranks, and the rest is the largest of any. Zero, and negative times, where no technique of this project draws.
   * Large numbers are doubles, since ParaView's panels have nothing to show longer integers.
   */
  double GetFragments();
  double GetDeepestPixel();
  double GetBytes();
  int GetTiles();
  int GetGeometryPasses();
  int GetScreenPasses();
  int GetShaderBuilds();
  double GetGatherTime();
  double GetResolveTime();
  const char* GetFallback();
  ///@}

  /**
   * Whether the view's last frame was drawn by the server, and shown here.
   */
  bool IsDrawnByServer();

protected:
  vtkPVTranslucency();
  ~vtkPVTranslucency() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkPVTranslucency(const vtkPVTranslucency&) = delete;
  void operator=(const vtkPVTranslucency&) = delete;

  void SetOption(const char* option, const std::string& value);
  void MakePasses();
  void PutIn();
  void BeginFrame();
  void EndFrame();
  void CompareRanks();
  vtkTranslucencyStatistics* GetStatistics();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
