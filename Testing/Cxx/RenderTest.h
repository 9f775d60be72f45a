// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests that draw have in common: off-screen views, and VTK's messages, which fail a test that did not expect
 * them.
 */
#ifndef RenderTest_h
#define RenderTest_h

#include "AnalyticScene.h"
#include "Picture.h"

#include <vtkABufferPass.h>
#include <vtkAdaptiveTransparencyPass.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStorageCountPass.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

class vtkTranslucencyPass;

/// An off-screen window with one renderer.
class View
{
public:
  View(int width, int height, int samples = 0);
  explicit View(const AnalyticScene& scene, int samples = 0);

  /// Draws with the pass as the renderer's own.
  void SetPass(vtkRenderPass* pass) { this->Renderer->SetPass(pass); }

  /// Draws with the pass as the translucent one of vtkRenderStepsPass.
  void SetTranslucentPass(vtkRenderPass* pass);

  Picture Render();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// VTK's errors and warnings since the start of the test.
class RenderTest : public testing::Test
{
protected:
  void SetUp() override;

  /// Fails if a message was not expected.
  void TearDown() override;

  /// The messages so far, which the test expects and takes over.
  static std::vector<std::string> TakeMessages();
};

/// True if the driver behind a view that has rendered keeps the order of drawing among the fragments of a pixel.
bool KeepsDrawOrder(View& view);

/// Adds a lit, translucent ball of radius 60 and depth 0.6 at these coordinates. As impostors it is drawn by its points
/// as spheres, whose shaders set gl_FragDepth.
void AddBall(vtkRenderer* renderer, bool impostors, double x, double y, double z);

/// Keywords and values of a technique's options.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A new pass of a technique, by its name in vtkTranslucencyFactory. Fails where it does not take a setting.
vtkSmartPointer<vtkTranslucencyPass> NewTechnique(const std::string& name, const Settings& settings = {});

/// Sets options. Fails where a pass does not take one.
void Apply(vtkTranslucencyPass* pass, const Settings& settings);

/// A new pass that counts the accesses to its storage.
vtkSmartPointer<vtkStorageCountPass> NewCounting(const Settings& settings);

/// A technique, with a choice of an option by which it draws in another way, or, without an option, as by default.
struct Way
{
  std::string Technique;
  std::string Option;
  std::string Choice;
};

void PrintTo(const Way& way, std::ostream* os);

/// All techniques, VTK's, too, and choices by which they draw in another way.
std::vector<Way> AllWays();

/// A new pass. Fails where it does not take the choice.
vtkSmartPointer<vtkRenderPass> NewPass(const Way& way);

/// The option values of all storages (vtkStorageTable), the linked list first; and such a value as a part of a test's
/// name: LinkedList of linked-list.
const std::vector<std::string>& AllStorages();
std::string StorageInNames(const std::string& storage);

/// The names of this module's techniques, without those that are VTK's.
std::vector<std::string> OwnTechniques();

/// Draws a scene once by a pass.
Picture Draw(const AnalyticScene& scene, vtkTranslucencyPass* pass);

/// A new adaptive pass.
vtkSmartPointer<vtkAdaptiveTransparencyPass> NewAdaptive(int nodeCount, Reference::Removal removal);

/// The reference's compositor for such a pass, with alpha correction or without.
Compositor AdaptiveCompositor(int nodeCount, Reference::Removal removal, bool corrected = true);

#endif
