// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Drivers that end at an older OpenGL: every technique that says that it runs there draws the same picture as with all
// that the driver has, says nothing, and leaves OpenGL as it was.
//
// Mesa is told what to leave out when a process starts. So this program draws its pictures with the whole driver first,
// and starts itself again without what an OpenGL of TRANSLUCENCY_TEST_OPENGL lacks; then the tests run. With --left-out
// it says instead what Mesa is told: for scripts/document-drivers.
#include "GLState.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkDepthPeelPass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyMaterial.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

#include <unistd.h>

namespace
{
// What has become a part of OpenGL up to 3.2, as far as Mesa tells it as extensions, and one that it switches together
// with a part of 3.2 (ARB_texture_storage_multisample).
const std::set<std::string> PartsOf32{ "ARB_copy_buffer", "ARB_depth_buffer_float", "ARB_depth_clamp",
  "ARB_draw_buffers", "ARB_draw_elements_base_vertex", "ARB_draw_instanced", "ARB_fragment_coord_conventions",
  "ARB_fragment_shader", "ARB_framebuffer_object", "ARB_framebuffer_sRGB", "ARB_half_float_pixel",
  "ARB_half_float_vertex", "ARB_map_buffer_range", "ARB_pixel_buffer_object", "ARB_point_sprite",
  "ARB_provoking_vertex", "ARB_seamless_cube_map", "ARB_shader_objects", "ARB_shader_texture_lod", "ARB_sync",
  "ARB_texture_buffer_object", "ARB_texture_compression_rgtc", "ARB_texture_float", "ARB_texture_multisample",
  "ARB_texture_non_power_of_two", "ARB_texture_rectangle", "ARB_texture_rg", "ARB_texture_storage_multisample",
  "ARB_uniform_buffer_object", "ARB_vertex_array_bgra", "ARB_vertex_array_object", "ARB_vertex_buffer_object",
  "ARB_vertex_shader" };

// And by 3.3.
const std::set<std::string> PartsOf33{ "ARB_blend_func_extended", "ARB_explicit_attrib_location",
  "ARB_instanced_arrays", "ARB_occlusion_query2", "ARB_sampler_objects", "ARB_shader_bit_encoding",
  "ARB_texture_rgb10_a2ui", "ARB_texture_swizzle", "ARB_timer_query", "ARB_vertex_type_2_10_10_10_rev" };

// What macOS has besides, where OpenGL ends at 4.1.
const std::set<std::string> PartsOf41{ "ARB_ES2_compatibility", "ARB_draw_buffers_blend", "ARB_draw_indirect",
  "ARB_gpu_shader5", "ARB_gpu_shader_fp64", "ARB_internalformat_query", "ARB_sample_shading",
  "ARB_separate_shader_objects", "ARB_shader_subroutine", "ARB_shading_language_include", "ARB_tessellation_shader",
  "ARB_texture_buffer_object_rgb32", "ARB_texture_cube_map_array", "ARB_texture_gather", "ARB_texture_query_lod",
  "ARB_texture_storage", "ARB_transform_feedback2", "ARB_transform_feedback3", "ARB_vertex_attrib_64bit",
  "ARB_viewport_array", "EXT_debug_label", "EXT_debug_marker", "EXT_framebuffer_multisample_blit_scaled",
  "EXT_texture_compression_s3tc", "EXT_texture_filter_anisotropic", "EXT_texture_sRGB_decode", "NV_texture_barrier" };

// Recent Mesas switch all extensions that are always there together: without these a part of OpenGL 3.0 is missing,
// too, depths as numbers with a stencil. They have functions for what can be done without, and nothing for shaders.
const std::set<std::string> SwitchedTogether{ "AMD_shader_trinary_minmax", "ARB_clear_buffer_object",
  "ARB_clear_texture", "ARB_compressed_texture_pixel_storage", "ARB_debug_output", "ARB_direct_state_access",
  "ARB_get_program_binary", "ARB_get_texture_sub_image", "ARB_invalidate_subdata", "ARB_map_buffer_alignment",
  "ARB_multi_bind", "ARB_parallel_shader_compile", "ARB_program_interface_query", "ARB_robustness",
  "ARB_separate_shader_objects", "ARB_shader_subroutine", "ARB_shading_language_include", "ARB_texture_storage",
  "ARB_texture_border_clamp", "ARB_vertex_attrib_binding", "KHR_parallel_shader_compile" };

std::string Version()
{
  const char* version = std::getenv("TRANSLUCENCY_TEST_OPENGL");
  return version ? version : "";
}

// Others have names of their own for what Mesa switches as one: of these, only what shaders can do is looked at.
bool IsIn(const std::string& extension)
{
  const bool looked = extension.compare(0, 4, "ARB_") == 0 || extension.find("_shader") != std::string::npos;
  return !looked || PartsOf32.count(extension) > 0 || PartsOf33.count(extension) > 0 ||
    (Version() == "4.1" && PartsOf41.count(extension) > 0);
}

// Set where those have been left in.
const char* const Together = "TRANSLUCENCY_TEST_TOGETHER";

/// The scenes, by number.
enum Scene
{
  Layers,   // flat ones, an opaque one among them
  Surfaces, // impostors, an opaque ball, a shader that the techniques don't reach
  Filters,  // that transmit colours
  Glass,    // that refracts, diffuses and disperses
  SceneCount
};

const char* const SceneNames[] = { "Layers", "Surfaces", "Filters", "Glass" };

constexpr int Width = 120;
constexpr int Height = 90;

void AddSurfaces(vtkRenderer* renderer)
{
  AddBall(renderer, true, 40, 45, -0.3);
  AddBall(renderer, true, 80, 45, 0.1);
  AddBall(renderer, false, 60, 20, 0.2);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(60, 60, 0);
  sphere->SetRadius(30);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  for (bool own : { false, true })
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(own ? 0.5 : 1);
    actor->SetScale(own ? 1 : 0.5, own ? 1 : 0.5, own ? 0.01 : 0.005);
    if (own)
    {
      actor->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                        "//VTK::Output::Dec\n"
                                                        "void main() { gl_FragData[0] = vec4(1.0, 0.5, 0.0, 0.5); }\n");
    }
    renderer->AddActor(actor);
  }
}

void AddGlass(vtkRenderer* renderer)
{
  AddBall(renderer, false, 60, 45, 0.1);
  vtkNew<vtkTranslucencyMaterial> glass;
  glass->SetIndexOfRefraction(1.5);
  glass->SetDiffusion(0.1);
  glass->SetDispersion(0.3);
  vtkTranslucencyMaterial::SetMaterial(renderer->GetActors()->GetLastActor(), glass);
}

struct Case
{
  Way Technique;
  int Drawn;
  int Samples;
};

std::string NameOf(const Case& tested)
{
  std::string name =
    tested.Technique.Technique + tested.Technique.Option + tested.Technique.Choice + SceneNames[tested.Drawn];
  name += std::to_string(tested.Samples);
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }), name.end());
  return name;
}

/// All that runs without storage buffers.
std::vector<Case> Cases()
{
  std::vector<Way> ways = AllWays();
  const std::vector<Way> more{ { "weighted", "method", "sum" }, { "weighted", "method", "average" },
    { "weighted", "weight_function", "equation7" }, { "sorted", "order", "backface" },
    { "sorted", "operator", "under" }, { "screendoor", "mask", "ordered-4x4" }, { "screendoor", "offset", "primitive" },
    { "stochastic", "alpha_correction", "off" }, { "stochastic", "depth_samples", "64" }, { "peel", "layers", "3" } };
  ways.insert(ways.end(), more.begin(), more.end());
  std::vector<Case> cases;
  for (const Way& way : ways)
  {
    const auto pass = NewPass(way);
    auto* own = vtkTranslucencyPass::SafeDownCast(pass);
    for (int drawn = 0; own && own->GetMissing(3, 3).empty() && drawn < SceneCount; ++drawn)
    {
      cases.push_back({ way, drawn, 1 });
      cases.push_back({ way, drawn, 4 });
    }
  }
  return cases;
}

// What draws the same with the whole driver. Where there is no storage techniques of sums draw the geometry again, auto
// takes what is exact and needs none, and one transmittance is kept, not three.
Way WholeOf(const Way& way)
{
  const std::string sums[] = { "fourier", "shadowmap", "wavelet", "moment" };
  if (std::find(std::begin(sums), std::end(sums), way.Technique) != std::end(sums))
  {
    return { way.Technique, "memory", "fixed" };
  }
  if (way.Technique == "auto" || way.Choice == "bucket-sort")
  {
    return { "peel", "", "" };
  }
  return way;
}

class Drawing
{
public:
  Drawing(const Case& drawn, const Way& way)
    : Shown(GetScene(drawn.Drawn), drawn.Samples == 1 ? 0 : drawn.Samples)
    , Pass(NewPass(way))
  {
    if (drawn.Drawn == Surfaces)
    {
      AddSurfaces(this->Shown.Renderer);
    }
    if (drawn.Drawn == Glass)
    {
      AddGlass(this->Shown.Renderer);
    }
    this->Shown.SetPass(this->Pass);
  }

  static AnalyticScene GetScene(int drawn)
  {
    AnalyticScene scene = RandomLayers(Width, Height, 7, drawn == Surfaces || drawn == Glass ? 2 : 12, 0.1, 0.7);
    return drawn == Filters ? scene.Transmitting(3) : scene;
  }

  View Shown;
  vtkSmartPointer<vtkRenderPass> Pass;
};

std::filesystem::path FileOf(const Case& drawn)
{
  return std::filesystem::path(std::getenv("TRANSLUCENCY_TEST_PICTURES")) / NameOf(drawn);
}

void PrintTo(const Case& tested, std::ostream* os)
{
  *os << NameOf(tested);
}

class TestOldDrivers
  : public RenderTest
  , public testing::WithParamInterface<Case>
{
};

// The wrong kind of messages.
std::vector<std::string> WithoutExpected(std::vector<std::string> messages, const Case& drawn)
{
  const auto expected = [&drawn](const std::string& message)
  {
    return message.find("by their mean") != std::string::npos || message.find("can't reach") != std::string::npos ||
      (drawn.Technique.Choice == "centroid" && message.find("are not sorted") != std::string::npos) ||
      message.find("drawing as with Fixed") != std::string::npos;
  };
  messages.erase(std::remove_if(messages.begin(), messages.end(), expected), messages.end());
  return messages;
}
}

//------------------------------------------------------------------------------
TEST_P(TestOldDrivers, DrawTheSame)
{
  const Case& drawn = this->GetParam();
  Drawing drawing(drawn, drawn.Technique);
  const Picture picture = drawing.Shown.Render();
  auto* pass = vtkTranslucencyPass::SafeDownCast(drawing.Pass);
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  for (const std::string& message : WithoutExpected(TakeMessages(), drawn))
  {
    ADD_FAILURE() << message;
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));

  Picture whole = picture;
  std::ifstream file(FileOf(drawn), std::ios::binary);
  const auto bytes = static_cast<std::streamsize>(whole.Rgb.size() * sizeof(double));
  file.read(reinterpret_cast<char*>(whole.Rgb.data()), bytes);
  ASSERT_EQ(file.gcount(), bytes);
  const PictureDifference difference = Compare(picture, whole);
  if (drawn.Samples > 1 && (drawn.Drawn == Surfaces || drawn.Drawn == Glass) && Version() == "3.3")
  {
    // A driver that does not shade samples shades a fragment once for its pixel: where surfaces bend colours differ a
    // little, and so do depths, which random numbers are made from. Glass spreads that.
    const bool random = drawn.Technique.Technique == "stochastic";
    EXPECT_LE(difference.RootMeanSquare, (drawn.Drawn == Glass ? 2 : 1) * (random ? 0.015 : 0.0005)) << difference;
    EXPECT_LE(difference.Largest, random ? 64 : 6) << difference;
  }
  else
  {
    EXPECT_LE(difference.Largest, 1) << difference;
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGL, TestOldDrivers, testing::ValuesIn(Cases()),
  [](const testing::TestParamInfo<Case>& info) { return NameOf(info.param); });

//------------------------------------------------------------------------------
TEST(TestOldDriver, HasNoMoreThanItsVersion)
{
  View view(16, 16);
  view.Render();
  const auto found = vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow::SafeDownCast(view.Window));
  const auto expected = vtkTranslucencyCapabilities::OfVersion(Version()[0] - '0', Version()[2] - '0');
  EXPECT_EQ(found.MissingForTargets, "");
  std::string missing = expected.MissingForStorage;
  const std::string cleared = ", GL_ARB_clear_buffer_object";
  if (std::getenv(Together) && missing.find(cleared) != std::string::npos)
  {
    missing.erase(missing.find(cleared), cleared.size());
  }
  EXPECT_EQ(found.MissingForStorage, missing);
  EXPECT_EQ(found.MissingForRetries, expected.MissingForRetries);
  EXPECT_EQ(found.BlendsBuffersApart, expected.BlendsBuffersApart);
  EXPECT_EQ(found.ShadesSamples, expected.ShadesSamples);
}

//------------------------------------------------------------------------------
class TestOldDriverWarnings : public RenderTest
{
};

// That options of the storage do nothing is said, and once. fourier also says that it draws as in fixed memory.
TEST_F(TestOldDriverWarnings, NameOptionsThatDoNothing)
{
  struct Expected
  {
    Way Technique;
    std::vector<std::string> Messages;
  };
  const std::vector<Expected> all{
    { { "fourier", "memory_limit", "64" },
      { "drawing as with Fixed", "MemoryLimit is 64, but the driver has no storage buffers" } },
    { { "peel", "memory_limit", "64" }, { "the targets that bucket-sort draws to have no limit" } },
  };
  for (const Expected& expected : all)
  {
    const auto pass = NewPass(expected.Technique);
    if (auto* peel = vtkDepthPeelPass::SafeDownCast(pass))
    {
      peel->SetMethod(vtkDepthPeelPass::BucketSort);
    }
    View view(Drawing::GetScene(Layers));
    view.SetPass(pass);
    view.Render();
    view.Render();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), expected.Messages.size()) << expected.Technique.Technique;
    for (std::size_t i = 0; i < messages.size(); ++i)
    {
      EXPECT_NE(messages[i].find(expected.Messages[i]), std::string::npos) << messages[i];
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// Draws all pictures with the whole driver.
void DrawAll()
{
  for (const Case& drawn : Cases())
  {
    const Picture picture = Drawing(drawn, WholeOf(drawn.Technique)).Shown.Render();
    std::ofstream file(FileOf(drawn), std::ios::binary);
    file.write(reinterpret_cast<const char*>(picture.Rgb.data()),
      static_cast<std::streamsize>(picture.Rgb.size() * sizeof(double)));
  }
}

// What the driver has and an OpenGL of the version lacks, as MESA_EXTENSION_OVERRIDE wants it.
std::string LeftOut()
{
  View view(16, 16);
  view.Render();
  view.Window->MakeCurrent();
  std::string left;
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const std::string name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    left += IsIn(name.substr(3)) ? "" : "-" + name + " "; // behind GL_
  }
  return left;
}

// Whether the driver has what OpenGL has since 3.0: a depth buffer of floating-point numbers with a stencil.
bool HasFloatingDepths()
{
  View view(16, 16);
  view.Render();
  view.Window->MakeCurrent();
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(
    GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8, 1, 1, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, nullptr);
  const bool has = glGetError() == GL_NO_ERROR;
  glBindTexture(GL_TEXTURE_2D, 0);
  glDeleteTextures(1, &texture);
  return has;
}

// What was left out, without those that Mesa switches together with that.
std::string LeftOutApart()
{
  std::istringstream left(std::getenv("MESA_EXTENSION_OVERRIDE"));
  std::string apart;
  const std::string sign = "-GL_";
  for (std::string word; left >> word;)
  {
    apart += SwitchedTogether.count(word.substr(sign.size())) > 0 ? "" : word + " ";
  }
  return apart;
}
}

//------------------------------------------------------------------------------
int main(int count, char* words[])
{
  testing::InitGoogleTest(&count, words);
  if (count == 2 && std::string(words[1]) == "--left-out" && !Version().empty())
  {
    std::cout << LeftOut() << "\n";
    return EXIT_SUCCESS;
  }
  const char* folder = std::getenv("TRANSLUCENCY_TEST_PICTURES");
  if (Version().empty() || !folder)
  {
    std::cerr << "to be run with TRANSLUCENCY_TEST_OPENGL=4.1 or 3.3, and a folder as TRANSLUCENCY_TEST_PICTURES\n";
    return EXIT_FAILURE;
  }
  if (!std::getenv("MESA_GL_VERSION_OVERRIDE"))
  {
    std::filesystem::create_directories(folder);
    DrawAll();
    setenv("MESA_EXTENSION_OVERRIDE", LeftOut().c_str(), 1);
    setenv("MESA_GL_VERSION_OVERRIDE", Version().c_str(), 1);
    execv("/proc/self/exe", words);
    return EXIT_FAILURE;
  }
  if (!std::getenv(Together) && !HasFloatingDepths())
  {
    setenv("MESA_EXTENSION_OVERRIDE", LeftOutApart().c_str(), 1);
    setenv(Together, "1", 1);
    execv("/proc/self/exe", words);
    return EXIT_FAILURE;
  }
  return RUN_ALL_TESTS();
}
