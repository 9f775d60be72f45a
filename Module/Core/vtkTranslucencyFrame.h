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
#include "vtkType.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkFragmentStorage;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkTranslucencyGLState;
class vtkTranslucencyPass;
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
  using Uniforms = std::map<std::string, int>;

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

  /// Of a pixel, as far as the window has several and the driver can tell them apart.
  int GetSamples() const { return this->Samples; }

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

  vtkTranslucencyFrame(const vtkTranslucencyFrame&) = delete;
  vtkTranslucencyFrame& operator=(const vtkTranslucencyFrame&) = delete;

private:
  class ScopedTimer;

  bool Fail(const std::string& error);
  Defines GetOfferedDefines() const;
  void UseWholeViewportIfItFits();
  void UseTile();
  void CutTile(int parts);
  bool NeedsDepthTest();
  void PrepareDrawing();
  void DrawVertices(unsigned int primitive, int count);
  void DrawGeometry();
  bool DrawVolumes();
  bool PrepareGather();
  vtkShaderProgram* PrepareProgram(
    const std::string& vertexFile, const std::string& file, const Defines& defines);

  vtkTranslucencyPass* Pass;
  const vtkRenderState* State;
  vtkOpenGLRenderWindow* Window;
  Rectangle Drawn; // the part of the viewport that the scissor test leaves
  Rectangle Tile;
  std::vector<Rectangle> Waiting; // tiles still to be drawn, the next one last
  vtkTypeInt64 LastFragments; // of the frame before, all tiles
  vtkFragmentStorage* Storage = nullptr;
  int Samples = 1; // of a pixel
  int Sample = WholePixel; // that resolves see
  int Among = -1;
  std::string Error;
};

#endif
