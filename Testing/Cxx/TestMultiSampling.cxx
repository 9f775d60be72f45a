// Multi-sampled windows: edges are not smoothed, but everything is drawn, and right inside of edges.
#include "RenderTest.h"

#include <vtkTranslucencyStatistics.h>

class TestMultiSampling
  : public RenderTest
  , public testing::WithParamInterface<int>
{
};

//------------------------------------------------------------------------------
TEST_P(TestMultiSampling, DrawsTheInsideOfRectangles)
{
  const AnalyticScene scene = RandomLayers(200, 160, 81, 30, 0.05, 0.6);
  View view(scene, GetParam());
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  // Edges are on pixel borders, so that every pixel is inside.
  for (int frame = 0; frame < 2; ++frame)
  {
    const PictureDifference difference =
      Compare(view.Render(), scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, 1.5) << difference;
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, TestMultiSampling, testing::Values(2, 4, 8));
