// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One off-screen window in which several techniques draw the same scene, one at a time.
 *
 * Each technique has a renderer, actors and mappers of its own, over the same meshes: to go from one to the next
 * rebuilds no shader, so that frames of different techniques can be timed in turn.
 */
#ifndef Stage_h
#define Stage_h

#include "Picture.h"
#include "Techniques.h"

#include "vtkNew.h"
#include "vtkStorageSimulator.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderer;
struct Scene;

/// What a frame drew and cost, as far as the technique tells (VTK's own passes tell nothing).
struct FrameStatistics
{
  bool Known = false;
  long long Fragments = 0;
  long long DeepestPixel = 0;
  double Mebibytes = 0;
  int Tiles = 0;
  int GeometryPasses = 0;
  int ScreenPasses = 0;
  int ShaderBuilds = 0;
  int Transmittances = 0; ///< that the technique, as it is set, keeps for transmission colours: 3, or 1 for their mean
  std::string Chosen;     ///< by a technique that chooses among others, which one, as Techniques.h writes it,
  std::string Reason;     ///< and why; empty for all others
  std::string Fallback;   ///< what was drawn instead, if the driver could not run the technique
};

/// What a frame takes of a fragment storage: see vtkStorageCountPass.
struct StorageCounts
{
  int SectionLength = 1;
  double PackedMebibytes = 0;
  long long Stores = 0;
  long long Reads = 0;
  long long Table = 0;
  long long SecondDepth = 0;
  long long FrameBuffer = 0;
  long long Total = 0;
};

/// Milliseconds on the GPU.
struct StageTimes
{
  double Gather = 0;
  double Resolve = 0;
};

class Stage
{
public:
  /// Opens a window; throws Failure if the driver can't draw pictures of that size, or not with so many samples a
  /// pixel. transparent: whether pictures hold the opacity.
  explicit Stage(const std::array<int, 2>& size, int samples = 1, bool transparent = false);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// The camera that scenes are seen by: as the first scene says, unless it was set before. Its clipping range becomes
  /// that of what is there.
  vtkCamera* GetCamera();
  void SetCamera(vtkCamera* camera);

  /// One more technique that draws the scene; the number to name it by.
  int Add(const Scene& scene, const TechniqueChoice& technique);

  /// A drawing that keeps the fragments of its frames (vtkFragmentTracePass); the number to name it by.
  int AddTrace(const Scene& scene);

  /// The fragments of its last frame. Throws Failure if the driver can't give them.
  const std::vector<vtkStorageSimulator::Fragment>& GetFragments(int trace);

  /// Draws a frame and waits for its end; milliseconds. Throws Failure if VTK reported an error.
  double Draw(int technique);

  /// Draws a frame to floats instead of the window: red, green, blue and opacity of each pixel, row by row from the
  /// lowest.
  std::vector<float> DrawInFloats(int technique);

  /// Draws frames until a technique that chooses among others has come to rest; for all others, none.
  void Settle(int technique);

  /// Moves the camera round the scene.
  void Orbit(double degrees);

  /// What the technique's last frame drew.
  FrameStatistics GetStatistics(int technique);

  /// Draws a frame with timers on; nothing if the technique has none.
  std::optional<StageTimes> DrawMeasured(int technique);

  /// Draws a frame that counts accesses; nothing if the technique has no fragment storage.
  std::optional<StorageCounts> CountStorage(int technique);

  /// The frame drawn last.
  std::unique_ptr<Picture> Read();

  /// The driver's words for itself.
  std::string GetDriver();

  /// Empty if the driver can run the technique, else what it lacks.
  std::string GetMissing(const std::string& technique);

private:
  vtkOpenGLRenderWindow* GetOpenGLWindow();
  int AddPass(const Scene& scene, const TechniqueChoice& technique, vtkRenderPass* pass);

  struct Player
  {
    TechniqueChoice Technique;
    vtkSmartPointer<vtkRenderer> Renderer;
    vtkSmartPointer<vtkRenderPass> Pass;
  };
  /// Throws Failure if VTK reported an error, or the technique gave way to another for a reason that is not the
  /// driver's: its options are then not what they should be.
  void CheckFrame(const Player& player);

  bool Transparent;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkCamera> Camera; // of all renderers
  std::vector<Player> Players;
};

#endif
