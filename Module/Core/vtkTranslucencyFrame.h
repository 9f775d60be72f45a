/**
 * One frame of a technique: what vtkTranslucencyPass::RenderStages is written in.
 *
 * The viewport is drawn as one tile, or as several where fragment storage would pass its limit. The pass's stages run once
 * a tile; Gather may cut the current tile into parts, of which it goes on with the first.
 *
 * @code
 * bool vtkSomePass::RenderStages(vtkTranslucencyFrame& frame)
 * {
 *   return frame.Gather(this->Storage) && frame.Resolve("Some/Resolve.glsl", { { "SOME_DEFINE", "8" } }, {});
 * }
 * @endcode
 *
 * A stage that returns false has said why by GetError(); the pass then draws the tile by its fallback.
 */
#ifndef vtkTranslucencyFrame_h
#define vtkTranslucencyFrame_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkStorageAccounting.h"           // for the accesses
#include "vtkType.h"

#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

class vtkFragmentStorage;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkTranslucencyBuffer;
class vtkTranslucencyGLState;
class vtkTranslucencyPass;
class vtkTranslucencyPixels;
class vtkTranslucencyTargets;
class vtkShaderProgram;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyFrame
{
public:
  using Rectangle = std::array<int, 4>; // x, y, width, height in window pixels

  vtkTranslucencyFrame(vtkTranslucencyPass* pass, const vtkRenderState* state,
    vtkOpenGLRenderWindow* window, const vtkTranslucencyGLState& found);

  /// Draws the translucent props into the storage, as often and in as many tiles as it takes for nothing to be lost.
  bool Gather(vtkFragmentStorage* storage);

  using Defines = std::map<std::string, std::string>;
  using Uniforms = std::map<std::string, std::variant<int, float>>;

  /// What a technique without lists puts into the mappers' shaders. One text serves all stages of a frame, told apart by its uniform
  /// gatherStage: mappers build their shaders anew when the text changes.
  struct Gathering
  {
    std::string File; ///< gives gatherFragment(color, depth), with Outputs a third parameter: out vec4 outputs[Outputs]
    Defines Values;
    int Outputs = 0;       ///< colours that are drawn to targets
    bool Critical = false; ///< whether it changes records of pixels under a critical section
    bool Rejects = false;  ///< whether File gives rejectFragment(depth), too, which discards fragments before they are shaded
  };

  enum class Blending
  {
    Replace,          ///< fragments take the place of what is there
    Add,              ///< all channels
    AddAndAttenuate,  ///< colour is added, alpha multiplied with 1 - alpha
    Attenuate,        ///< all channels are multiplied with 1 - themselves
    Over,             ///< before what is there: front's colours, multiplied by their opacity, and opacity
    Filter,           ///< colour before what is there, which is multiplied by a second source colour (Shaders/Common/Output.glsl)
    Under,            ///< behind it: alpha is what is still seen, from 1 on
    Minimum,
    Maximum
  };

  /// How a buffer takes what is drawn to it, and what it holds before.
  struct Buffer
  {
    Blending Blend;
    std::array<float, 4> Clear;
  };

  /// A buffer that a stage reads, by the name of the sampler (Shaders/Common/Target.glsl).
  struct Input
  {
    std::string Sampler;
    const vtkTranslucencyTargets* From;
    int Index;
  };

  enum class Faces
  {
    All = 0,
    Back = 1,
    Front = 2
  };

  /// A prop that is drawn by itself.
  struct Part
  {
    vtkProp* Prop;
    int Number; ///< what shaders see as their uniform gatherPart
    Faces Drawn = Faces::All; ///< of its polygons; lines and points have no faces and are drawn in any case
  };

  /// One drawing of the translucent props, or of the screen.
  struct Stage
  {
    int Number = 0;
    std::vector<Part> Parts; ///< drawn in this order; empty: all props, in theirs
    vtkTranslucencyTargets* Targets = nullptr; ///< drawn to, and cleared before (but see Cleared); null: colours go over the opaque picture
    bool StoresOnly = false; ///< fragments draw no colours, though the gather has outputs for other stages
    Blending Blend = Blending::Add;
    bool HidesBehind = false; ///< fragments write depth, to a depth buffer of the targets that starts as the opaque one
    std::array<float, 4> Clear{ { 0, 0, 0, 0 } };
    std::vector<Input> Inputs;
    Uniforms Values;
    std::map<int, Buffer> Differing; ///< buffers for which Blend and Clear don't hold: needs Capabilities.MissingForBuffers to be empty
    int Cleared = VTK_INT_MAX; ///< how many of Targets are cleared, the first ones; the others keep what is in them, of earlier stages or frames
  };

  /// A record in colours: its words, of which the first ones are EMPTY_NUMBER before stage 0. Later stages go on with what that has left.
  struct Fetched
  {
    int Words;
    int Empty;
  };

  /// Records of that many words for each sample of the tile, which is cut where they would pass the limit (MiB, 0 for the default).
  ///
  /// They lie in buffers, or, if fetched has words, in colours that fragments fetch (Shaders/Common/PixelTargets.glsl), which is
  /// several times as fast on the software rasterizer: where the driver can, the critical section is chosen automatically, a pixel has one
  /// sample, and all of the picture's records find room.
  bool UsePixels(vtkTranslucencyPixels& pixels, int words, double memoryLimit, const Fetched& fetched = { 0, 0 });

  /// Whether the records last asked for lie in colours.
  bool FetchesRecords() const { return this->FetchedRecords != nullptr; }

  /// Makes targets as large as the framebuffer; formats are floats a pixel, 1, 2 or 4 each.
  bool UseTargets(vtkTranslucencyTargets& targets, const std::vector<int>& formats);

  /// Gives the shaders words to read (STORAGE_BINDING_TABLE in Shaders/Common/Bindings.glsl).
  bool UseTable(vtkTranslucencyBuffer& table, const std::vector<unsigned int>& words);

  /// The translucent props, in the order of drawing.
  std::vector<vtkProp*> GetProps() const;
  vtkRenderer* GetRenderer() const;

  /// Between which depths the boxes of the translucent props lie, 0 at the near plane, 1 at the far plane, linear in the distance
  /// (Shaders/Common/LinearDepth.glsl). All of it where a prop does not know its box.
  std::array<double, 2> GetDepthRange() const;

  /// Draws the translucent props. If any is given it becomes whether a fragment was left by the depth test and by the gather, which may
  /// discard fragments; that waits for the drawing's end.
  bool Draw(const Gathering& gathering, const Stage& stage, bool* any = nullptr);

  /// Runs a shader with a main function of its own over the tile, of which each output goes to a buffer of the stage's targets. Several
  /// outputs need locations, and so Capabilities.MissingForBuffers to be empty. If any is given it becomes whether the shader has left a
  /// fragment that it did not discard; that waits for it.
  bool DrawScreen(const std::string& file, const Defines& defines, const Stage& stage, bool* any = nullptr);

  /// Clears a stage's targets.
  bool Clear(const Stage& stage);

  /// What a buffer holds of the tile, as vtkTranslucencyTargets::Read gives it.
  std::vector<float> Read(const vtkTranslucencyTargets& targets, int index);

  /// Runs a shader (which ends with Shaders/Common/Composite.glsl) over the tile and blends what it gives over the opaque picture.
  bool Composite(const std::string& file, const Defines& defines, const std::vector<Input>& inputs, const Uniforms& uniforms = {});

  /// Which squares of pixels a resolve draws: those in which the storage expects more than Fewer and at most Most fragments
  /// a pixel, and those with pixels that earlier resolves have left to this Level, 0 to 29
  /// (Shaders/Common/Statistics.glsl). The default is all squares that hold fragments.
  struct Squares
  {
    int Level = 0;
    int Fewer = 0;
    int Most = VTK_INT_MAX;

    /// Only what was left to this level.
    static Squares LeftTo(int level) { return { level, VTK_INT_MAX, VTK_INT_MAX }; }
  };

  /// Numbers that differ from those of an earlier frame wherever the translucent picture may: camera, lights, props and all that they are drawn
  /// from. For techniques that refine a view over frames while it does not change.
  std::vector<vtkTypeUInt64> GetFingerprint() const;

  /// Of a pixel, as far as the window has several and the driver can tell them apart.
  int GetSamples() const { return this->Samples; }

  /// How many transmittances of a pixel shaders tell apart (Shaders/Common/Channels.glsl): three, of red, green and blue, where a prop that is
  /// drawn has a transmission colour and the technique keeps them, else one.
  int GetChannels() const { return this->Transmission == Transmissions::Colored ? 3 : 1; }

  /// How what Shaders/Common/Over.glsl gives is put over the opaque picture.
  Blending GetOver() const { return this->GetChannels() == 3 ? Blending::Filter : Blending::Over; }

  /// What the resolves that follow see: WholePixel, or one sample (Shaders/Common/Samples.glsl); and if among is a level, only squares
  /// with pixels that were left to that, too.
  void SetSample(int sample, int among = -1);
  static constexpr int WholePixel = -1;

  /// Makes room for the colours of the tile's samples that a resolve stores (Shaders/Common/SampleColors.glsl).
  bool ReserveSampleColors();

  /// Blends them over the opaque picture, all samples in one pass.
  bool CompositeSamples();

  /// Runs a resolve shader over squares of the current tile and blends what it gives over the opaque picture. The storage last
  /// gathered into is there for it to read. Level 0 comes first. Levels are below LEVEL_EACH_SAMPLE (Shaders/Common/Bindings.glsl).
  bool Resolve(const std::string& file, const Defines& defines, const Squares& squares,
    const Uniforms& uniforms = {});

  /// Before a resolve that includes Storage/SortList.glsl.
  bool PrepareSorting();

  /// Puts the pixels' lists of fragments into front-to-back order, where they lie.
  bool SortLists(const Squares& squares);

  /// Whether pixels of this tile were left to a level. Waits for the resolves so far.
  bool IsLeftTo(int level);

  /// The most fragments in a pixel that the resolves so far have counted. Waits for them.
  vtkTypeInt64 GetDeepestPixel();

  /// Draws the current tile by plain blending, in drawing order: what is left when a stage has failed.
  void Blend();

  /// True while there are tiles left; makes the next one current.
  bool NextTile();

  const Rectangle& GetTile() const { return this->Tile; }
  const std::string& GetError() const { return this->Error; }

  /// Says why a stage has failed; false, for the stage to return.
  bool Fail(const std::string& error);

  vtkTranslucencyFrame(const vtkTranslucencyFrame&) = delete;
  vtkTranslucencyFrame& operator=(const vtkTranslucencyFrame&) = delete;

private:
  class ScopedTimer;
  class ScopedTextures;
  class ScopedTargets;

  friend class vtkTranslucencyPass;
  static void SetUniforms(vtkShaderProgram* program, const Uniforms& uniforms);
  void ChooseTransmission();
  Defines GetOfferedDefines() const;
  bool UseStatistics();
  static void FinishStores();
  void FinishRecords();
  bool FetchPixels(vtkTranslucencyPixels& pixels, int words, vtkTypeInt64 limit);
  Stage GetFetchedStage(const Stage& stage) const;
  bool Retrieve();
  bool CountAccesses();
  void ReportAccesses();
  void UseWholeViewportIfItFits();
  void UseWholeViewport();
  void UseTile();
  void CutTile(int parts);
  bool NeedsDepthTest();
  void PrepareDrawing();
  void DrawVertices(unsigned int primitive, int count);
  void DrawGeometry(const Stage& stage, bool colors, bool* any = nullptr);
  void DrawProps(const vtkRenderState* state, const Stage& stage, bool colors, bool* any);
  void DrawUnreached(vtkProp* prop, const Stage& stage, bool colors, bool* any);
  vtkShaderProgram* PrepareHandOver();
  bool IsDrawn();
  void PrepareColors(const Stage& stage);
  void SetBlending(const Stage& stage);
  void KeepBlending(const Stage& stage);
  std::map<std::string, std::string> GetSelection() const;
  bool DrawVolumes();
  bool PrepareGather();
  bool PrepareGather(const Gathering& gathering);
  std::string GetMeanText() const;
  vtkShaderProgram* PrepareProgram(
    const std::string& vertexFile, const std::string& file, const Defines& defines);

  vtkTranslucencyPass* Pass;
  const vtkRenderState* State;
  vtkOpenGLRenderWindow* Window;
  Rectangle Drawn; // the part of the viewport that the scissor test leaves
  Rectangle Tile;
  std::vector<Rectangle> Waiting; // tiles still to be drawn, the next one last
  vtkTypeInt64 LastUnits; // of room, that fragments took in the frame before, all tiles
  vtkFragmentStorage* Storage = nullptr;
  int Samples = 1; // of a pixel
  int TargetSamples = 1; // the same, whether or not the driver can tell them apart
  enum class Transmissions
  {
    None,
    Mean, // of the transmission colours, where the technique keeps one channel
    Colored
  };
  Transmissions Transmission = Transmissions::None;
  bool Cut = false; // whether this frame has cut a tile
  bool CountsStatistics = false; // whether a shader of this frame has counted any (Shaders/Common/Statistics.glsl)
  bool HasRecords = false; // whether this frame has records of pixels in buffers,
  vtkTranslucencyTargets* FetchedRecords = nullptr; // or in these colours,
  int FetchedEmpty = 0; // of which so many words are empty in the beginning
  int Sample = WholePixel; // that resolves see
  int Among = -1;
  vtkStorageAccounting::Histogram Counted; // where accesses are counted: of all tiles,
  vtkStorageAccounting::Accesses Accesses; // and the accesses to them
  std::string Error;
};

#endif
