// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// A technique that fails half way: the reason is told once, the picture is drawn all the same, nothing else is
// disturbed.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkFragmentListPass.h>
#include <vtkObjectFactory.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTranslucencyFrame.h>
#include <vtkTranslucencyStatistics.h>

using TestFailure = RenderTest;

namespace
{
/// Gathers, then asks for something that isn't there.
class BrokenPass : public vtkFragmentListPass
{
public:
  static BrokenPass* New();
  vtkTypeMacro(BrokenPass, vtkFragmentListPass);

  std::string File = "No/Such.glsl";
  vtkTranslucencyFrame::Defines Defines;

protected:
  bool ResolveLists(vtkTranslucencyFrame& frame) override { return frame.Resolve(this->File, this->Defines, {}); }
};
vtkStandardNewMacro(BrokenPass);

constexpr double Peeled = 4; // what peeling to the end, in bytes, may differ on such a scene, in units of 1/255

AnalyticScene SomeLayers()
{
  return RandomLayers(200, 160, 91, 20, 0.1, 0.6);
}

void ExpectFallback(BrokenPass* pass, const std::string& reason, std::vector<std::string> (*take)())
{
  const AnalyticScene scene = SomeLayers();
  View view(scene);
  view.SetPass(pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, Peeled) << "frame " << frame << ": " << difference;
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  }
  const std::vector<std::string> messages = take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find(reason), std::string::npos) << messages[0];
}
}

//------------------------------------------------------------------------------
TEST_F(TestFailure, OfAShaderThatIsMissing)
{
  vtkNew<BrokenPass> pass;
  ExpectFallback(pass, "No/Such.glsl is not in the shader table", TakeMessages);
}

//------------------------------------------------------------------------------
TEST_F(TestFailure, OfADefineThatIsMissing)
{
  vtkNew<BrokenPass> pass;
  pass->File = "Adaptive/Resolve.glsl";
  pass->Defines = { { "NODE_COUNT", "8" } };
  ExpectFallback(pass, "Adaptive/", TakeMessages);
}

//------------------------------------------------------------------------------
TEST_F(TestFailure, OfADefineThatNoFileMentions)
{
  vtkNew<BrokenPass> pass;
  pass->File = "ABuffer/ResolveSorted.glsl";
  pass->Defines = { { "NODE_COUMT", "8" } };
  ExpectFallback(pass, "NODE_COUMT is mentioned by none of its files", TakeMessages);
}

//------------------------------------------------------------------------------
TEST_F(TestFailure, OfADefineThatIsOnlyPartOfOtherNames)
{
  for (const std::string part : { "COLOR_FORM", "OLOR_FORMAT", "LOR_FOR" })
  {
    vtkNew<BrokenPass> pass;
    pass->File = "ABuffer/ResolveSorted.glsl";
    pass->Defines = { { part, "8" } };
    ExpectFallback(pass, part + " is mentioned by none of its files", TakeMessages);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFailure, OfAShaderThatDoesNotCompileNamesFileAndLine)
{
  vtkNew<BrokenPass> pass;
  pass->File = "Adaptive/Resolve.glsl";
  pass->Defines = { { "NODE_COUNT", "8 +" }, { "NODE_REMOVAL", "0" }, { "EQUAL_DEPTHS", "0" },
    { "EQUAL_DEPTHS_LEVEL", "1u" }, { "UNFINISHED_LEVEL", "2u" } };
  ExpectFallback(pass, "Adaptive/EachNode.glsl:", TakeMessages);
}
