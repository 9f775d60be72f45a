/**
 * What a vtkTranslucencyPass keeps from frame to frame, shared with vtkTranslucencyFrame.
 */
#ifndef vtkTranslucencyInternals_h
#define vtkTranslucencyInternals_h

#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyLayers.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyPeelingGuard.h"
#include "vtkTranslucencyStatistics.h"
#include "vtkTranslucencyUnreached.h"
#include "vtkTranslucencyVolumes.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkOpenGLRenderWindow.h" // for the weak pointer
#include "vtkTimeStamp.h"
#include "vtkVolumetricPass.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

class vtkDepthPeelingPass;
class vtkOpenGLFramebufferObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkTranslucencyRenderStepsPass;

/// What stands for a pass in the mappers' shaders. Mappers refer to it until they draw without it: it must not keep the pass alive, which may
/// own mappers.
class vtkTranslucencyHook : public vtkOpenGLRenderPass
{
public:
  static vtkTranslucencyHook* New();
  vtkTypeMacro(vtkTranslucencyHook, vtkOpenGLRenderPass);

  using vtkOpenGLRenderPass::PostRender;
  using vtkOpenGLRenderPass::PreRender;

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override
  {
    return !this->Pass || this->Pass->PreReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop);
  }
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override
  {
    return !this->Pass || this->Pass->PostReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop);
  }
  bool SetShaderParameters(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject* VAO) override
  {
    return !this->Pass || this->Pass->SetShaderParameters(program, mapper, prop, VAO);
  }
  vtkMTimeType GetShaderStageMTime() override { return this->Pass ? this->Pass->GetShaderStageMTime() : 0; }

  vtkTranslucencyPass* Pass = nullptr; // null once it is gone

protected:
  vtkTranslucencyHook() = default;
  ~vtkTranslucencyHook() override = default;
};

struct vtkTranslucencyPass::Internals
{
  /// Deletes all OpenGL objects, or forgets them, if their context is gone.
  void Release(bool alive);

  // The window and the context in it that the OpenGL objects belong to, and what that can do.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  void* Context = nullptr;
  vtkTranslucencyCapabilities Capabilities;

  vtkNew<vtkTranslucencyHook> Hook;

  // Gather: the text that goes into the mappers' shaders, what it was made from, and when it last changed.
  std::string GatherKey;
  std::string GatherText;
  std::string GatherCall;    // the call of it; GATHERED_DEPTH stands for the fragment's depth
  bool GatherStores = false; // whether it has effects besides the colours that it draws
  bool GatherFetches = false; // whether it fetches records, and draws them in the place of VTK's colour
  bool GatherRejects = false; // whether the text has a function to be called before the fragment is shaded
  vtkTimeStamp GatherTextTime;
  bool GatherWritesDepth = false;
  std::function<void()> KeepGatherBlending = [] {}; // as the stage that draws wants it
  vtkTranslucencyFrame::Faces GatherFaces = vtkTranslucencyFrame::Faces::All;
  int RenderedProps = 0; // by the last drawing
  bool Gathering = false;
  vtkTranslucencyFrame::Uniforms GatherUniforms; // of the stage, its samplers' texture units among them
  std::string GatherError; // of a mapper whose shader has no place for the call

  /// Draws the props of a state with the pass's text in their shaders.
  void DrawReached(const vtkRenderState* state);

  // Props that the text does not reach, and what takes their fragments one layer at a time.
  vtkTranslucencyUnreached Unreached{ { "gatherFragment(" } };
  vtkTranslucencyLayers Layers;

  /// The translucent props that have a transmission colour, and the class of one whose colour is none.
  struct Transmitting
  {
    int Props = 0;
    int Emissive = 0; // of them: those whose mapper gives them one
    std::string Invalid;
  };
  static Transmitting CountTransmitting(const vtkRenderState* state);

  vtkTranslucencyVolumes Volumes;

  // The opaque depth, captured only if a shader asks for it.
  vtkSmartPointer<vtkTextureObject> OpaqueDepth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> OpaqueFramebuffer;
  int OpaqueDepthBits = 0;
  bool OpaqueDepthCaptured = false;
  bool CaptureOpaqueDepth();
  // Binds it to a texture unit of its own, and puts back what was bound there.
  void ActivateOpaqueDepth();
  void DeactivateOpaqueDepth();
  int OpaqueDepthUnit = 0;
  int OpaqueDepthUnitBefore = 0;
  vtkTranslucencyFrame::Rectangle Viewport{ { 0, 0, 0, 0 } };

  // Resolve: programs, owned by the window's shader cache, by what they were made from.
  std::map<std::string, vtkShaderProgram*> Programs;
  unsigned int VertexArray = 0;

  // Blocks of Frame.glsl and Statistics.glsl: of the latter, the words before the squares.
  struct ResolveStatistics
  {
    unsigned int DeepestPixel;
    unsigned int Unfinished;
    unsigned int LeftLevels;
    unsigned int Unused;
  };
  const ResolveStatistics& GetResolveStatistics(); // waits for the resolves so far, once
  std::optional<ResolveStatistics> Resolved;
  vtkTranslucencyBuffer FrameBlock;
  vtkTranslucencyBuffer StatisticsBlock;
  vtkTranslucencyBuffer SampleColors; // Shaders/Common/SampleColors.glsl
  vtkTranslucencyBuffer PixelFragments; // Shaders/Storage/CountAccesses.glsl

  // The tiles of the last frame, the first drawn last, and the fragments in them all, with the room that those took.
  std::vector<vtkTranslucencyFrame::Rectangle> Plan;
  vtkTypeInt64 PlanFragments = 0;
  vtkTypeInt64 PlanUnits = 0;

  vtkNew<vtkTranslucencyStatistics> Statistics;
  double GatherTime = -1; // milliseconds, all tiles; negative if not measured
  double ResolveTime = -1;

  // Alone, the pass draws by these steps, of which it is one.
  vtkSmartPointer<vtkTranslucencyRenderStepsPass> Steps;
  vtkNew<vtkVolumetricPass> VolumesAlone;

  vtkSmartPointer<vtkDepthPeelingPass> Peeling;
  vtkTranslucencyPeelingGuard Guard;
  std::string Warned; // the reason for a fallback that was last warned of
  std::string MissingForSamples; // the same for drawing with one sample,
  std::string MeanTransmission; // for taking transmission colours by their mean,
  std::string InvalidTransmission; // for those that are none,
  std::string UndividedVolumes; // for volumes that are drawn over the surfaces,
  std::set<std::string> UnreachedKinds; // and for props that the text does not reach
};

#endif
