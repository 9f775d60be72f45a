// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyFrame
 *
 * One frame of a technique: what vtkTranslucencyPass::RenderStages is written in.
 *
 * The viewport is drawn as one tile, or as several where fragment storage would pass its limit. The pass's stages run
 * once a tile; Gather may cut the current tile into parts, of which it goes on with the first.
 *
 * @code
 * bool vtkSomePass::RenderStages(vtkTranslucencyFrame& frame)
 * {
 *   bool drawn;
 *   do
 *   {
 *     drawn = frame.Gather(this->Storage) && frame.Resolve("Some/Resolve.glsl", { { "SOME_DEFINE", "8" } }, {});
 *   } while (drawn && !frame.IsComplete());
 *   return drawn;
 * }
 * @endcode
 *
 * A stage that returns false has said why by GetError(); the pass then draws the tile by its fallback.
 */
#ifndef vtkTranslucencyFrame_h
#define vtkTranslucencyFrame_h

#include "vtkFragmentStorage.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyPixels.h"
#include "vtkTranslucencyStage.h"
#include "vtkType.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;
class vtkTranslucencyBuffer;
class vtkTranslucencyFrameShaders;
class vtkTranslucencyGLState;
class vtkTranslucencyGeometry;
class vtkTranslucencyPass;
class vtkTranslucencyRecords;
class vtkTranslucencyResolver;
class vtkTranslucencyTargets;
class vtkTranslucencyTiles;
struct vtkTranslucencyResources;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyFrame
{
public:
  using Rectangle = std::array<int, 4>; // x, y, width, height in window pixels
  using Defines = vtkTranslucencyShader::Defines;
  using Uniforms = vtkTranslucencyShader::Uniforms;
  using Gathering = vtkTranslucencyGathering;
  using Stage = vtkTranslucencyStage;
  using Blending = Stage::Blending;
  using Buffer = Stage::Buffer;
  using Input = Stage::Input;
  using Faces = Stage::Faces;
  using Part = Stage::Part;
  using Fetched = vtkTranslucencyPixels::Fetched;

  vtkTranslucencyFrame(vtkTranslucencyPass* pass, vtkTranslucencyResources& resources, const vtkRenderState* state,
    vtkOpenGLRenderWindow* window, const vtkTranslucencyGLState& found, bool usesStorage);
  ~vtkTranslucencyFrame();

  /// Draws the translucent props into the storage, in as many tiles as it takes. Whether all fragments have found room
  /// may be open until IsComplete; where they have not, resolves draw nothing, and the tile has to be gathered again,
  /// as often as it takes for nothing to be lost.
  bool Gather(vtkFragmentStorage* storage);

  /// Whether what was gathered is complete. Waits for the GPU, once a tile: best asked after the resolves, which then
  /// have not waited.
  bool IsComplete();

  /// Records of that many words for each sample of the tile, which is cut where they would pass the limit (MiB, 0 for
  /// the default).
  ///
  /// They lie in buffers, or, if fetched has words, in colours that fragments fetch (Shaders/Common/PixelTargets.glsl),
  /// which is several times as fast on the software rasterizer: where the driver can, the critical section is chosen
  /// automatically, a pixel has one sample, and all of the picture's records find room.
  ///
  /// Words are what was there before, or 0 if zeroed and they lie in buffers.
  bool UsePixels(vtkTranslucencyPixels& pixels, int words, double memoryLimit, const Fetched& fetched = { 0, 0 },
    bool zeroed = false);

  /// Whether the records last asked for lie in colours.
  bool FetchesRecords() const;

  /// Makes targets as large as the framebuffer; formats are floats a pixel, 1, 2 or 4 each, of 32 bits or of 16.
  bool UseTargets(vtkTranslucencyTargets& targets, const std::vector<int>& formats, bool halves = false);

  /// Makes a table of words, row by row, that stages can read as an input: a usampler2D.
  bool UseTable(vtkTranslucencyTargets& table, int columns, const std::vector<unsigned int>& words);

  /// The translucent props, in the order of drawing.
  std::vector<vtkProp*> GetProps() const;
  vtkRenderer* GetRenderer() const;

  /// Between which depths they lie: vtkTranslucencyScene.
  std::array<double, 2> GetDepthRange() const;

  /// Draws the translucent props. If any is given it becomes whether a fragment was left by the depth test and by the
  /// gather, which may discard fragments; that waits for the drawing's end.
  bool Draw(const Gathering& gathering, const Stage& stage, bool* any = nullptr);

  /// Runs a shader with a main function of its own over the tile, of which each output goes to a buffer of the stage's
  /// targets. If any is given it becomes whether the shader has left a fragment that it did not discard; that waits for
  /// it.
  bool DrawScreen(const std::string& file, const Defines& defines, const Stage& stage, bool* any = nullptr);

  /// Clears a stage's targets.
  bool Clear(const Stage& stage);

  /// What a buffer holds of the tile, as vtkTranslucencyTargets::Read gives it.
  std::vector<float> Read(const vtkTranslucencyTargets& targets, int index);

  /// Runs a shader (which ends with Shaders/Common/Composite.glsl) over the tile and blends what it gives over the
  /// opaque picture.
  bool Composite(
    const std::string& file, const Defines& defines, const std::vector<Input>& inputs, const Uniforms& uniforms = {});

  /// Which squares of pixels a resolve draws: those in which the storage expects more than Fewer and at most Most
  /// fragments a pixel, and those with pixels that earlier resolves have left to this Level, 0 to 29
  /// (Shaders/Common/Statistics.glsl). The default is all squares that hold fragments.
  struct Squares
  {
    int Level = 0;
    int Fewer = 0;
    int Most = VTK_INT_MAX;

    /// Only what was left to this level.
    static Squares LeftTo(int level) { return { level, VTK_INT_MAX, VTK_INT_MAX }; }
  };

  /// Numbers that differ from those of an earlier frame wherever the translucent picture may: camera, lights, props and
  /// all that they are drawn from. For techniques that refine a view over frames while it does not change.
  std::vector<vtkTypeUInt64> GetFingerprint() const;

  /// Of a pixel, as far as the window has several and the driver can tell them apart.
  int GetSamples() const;

  /// How many transmittances of a pixel shaders tell apart (Shaders/Common/Channels.glsl): three, of red, green and
  /// blue, where a prop that is drawn has a transmission colour and the technique keeps them, else one.
  int GetChannels() const;

  /// How what Shaders/Common/Over.glsl gives is put over the opaque picture.
  Blending GetOver() const;

  /// What the resolves that follow see: WholePixel, or one sample (Shaders/Common/Samples.glsl); and if among is a
  /// level, only squares with pixels that were left to that, too.
  void SetSample(int sample, int among = -1);
  static constexpr int WholePixel = -1;
  int GetSample() const;

  /// Makes room for the colours of the tile's samples that a resolve stores (Shaders/Common/SampleColors.glsl).
  bool ReserveSampleColors();

  /// Blends them over the opaque picture, all samples in one pass.
  bool CompositeSamples();

  /// Runs a resolve shader over squares of the current tile and blends what it gives over the opaque picture. The
  /// storage last gathered into is there for it to read. Level 0 comes first. Levels are below LEVEL_EACH_SAMPLE
  /// (Shaders/Common/Bindings.glsl).
  bool Resolve(const std::string& file, const Defines& defines, const Squares& squares, const Uniforms& uniforms = {});

  /// Before a resolve that includes Storage/SortList.glsl.
  bool PrepareSorting();

  /// Puts the pixels' lists of fragments into front-to-back order, where they lie.
  bool SortLists(const Squares& squares);

  /// Whether pixels of this tile were left to a level, or squares of it to a resolve. False where fragments have not
  /// found room. Waits for the resolves so far.
  bool IsLeftTo(int level);
  bool IsLeftTo(const Squares& squares);

  /// The most fragments in a pixel that the resolves so far have counted. Waits for them.
  vtkTypeInt64 GetDeepestPixel();

  /// Draws the current tile by plain blending, in drawing order: what is left when a stage has failed.
  void Blend();

  /// True while there are tiles left; makes the next one current.
  bool NextTile();

  /// What the camera's picture fills.
  const Rectangle& GetPicture() const { return this->Picture; }

  /// What is drawn: all of it, and the current tile.
  const Rectangle& GetViewport() const;
  const Rectangle& GetTile() const;

  const std::string& GetError() const { return this->Error; }

  /// Says why a stage has failed; false, for the stage to return.
  bool Fail(const std::string& error);

  vtkTranslucencyFrame(const vtkTranslucencyFrame&) = delete;
  vtkTranslucencyFrame& operator=(const vtkTranslucencyFrame&) = delete;

private:
  bool DrawCells(const char* file, vtkTypeInt64 most);
  bool Retrieve();
  bool FinishGathering();
  bool Absorb();
  void Finish(vtkFragmentStorage::Outcome outcome);
  bool IsDrawn();
  void UseTile();
  void FinishRecords();
  vtkShaderProgram* PrepareProgram(const std::string& vertexFile, const std::string& file, const Defines& defines);

  vtkTranslucencyPass* Pass;
  vtkTranslucencyResources& Resources;
  Rectangle Picture;           // what the camera's picture fills, of which the viewport is what is drawn
  vtkTranslucencyTiles& Tiles; // of the resources
  const vtkRenderState* State;
  vtkOpenGLRenderWindow* Window;
  std::unique_ptr<vtkTranslucencyFrameShaders> Shaders;
  std::unique_ptr<vtkTranslucencyGeometry> Geometry;
  std::unique_ptr<vtkTranslucencyResolver> Resolver;
  std::unique_ptr<vtkTranslucencyRecords> Records;
  vtkFragmentStorage* Storage = nullptr;
  bool SummedUp = false; // whether the tile is complete is yet to be asked
  bool Complete = true;
  bool HasRoom = true; // to gather again
  std::string Error;
};
VTK_ABI_NAMESPACE_END

#endif
