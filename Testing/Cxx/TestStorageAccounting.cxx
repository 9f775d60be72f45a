// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What designs of fragment storage take: the figures of the T-buffer's paper, and the closed forms against a simulator
// that knows none.
#include "vtkStorageAccounting.h"
#include "vtkStorageSimulator.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using Accounting = vtkStorageAccounting;
using Design = Accounting::Design;
using Fragment = vtkStorageSimulator::Fragment;
using Fragments = std::vector<Fragment>;

/// Table 1 of the paper: eight frames of QUAKE4; pixels of 1 to 5 fragments.
std::vector<Accounting::Histogram> PaperFrames()
{
  const std::vector<std::vector<std::int64_t>> table{ { 5812, 956, 6633, 2279, 189 }, { 5723, 956, 6634, 2278, 189 },
    { 8713, 956, 6634, 2278, 189 }, { 32588, 12040, 7235, 2279, 189 }, { 26082, 2729, 6636, 2179, 121 },
    { 27421, 7094, 7006, 1569, 173 }, { 15728, 3290, 6770, 1296, 15 }, { 95226, 8716, 6711, 671, 0 } };
  std::vector<Accounting::Histogram> frames;
  for (const auto& row : table)
  {
    Accounting::Histogram frame{ 640, 480, {} };
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      frame.Pixels[static_cast<std::int64_t>(i) + 1] = row[i];
    }
    frames.push_back(frame);
  }
  return frames;
}

Accounting PaperAccounting(int sectionLength = 2)
{
  Accounting::Settings settings;
  settings.TSectionLength = sectionLength;
  return Accounting(settings, PaperFrames());
}

Fragments RandomFragments(int width, int height, std::size_t count, unsigned int seed)
{
  std::mt19937 random(seed);
  Fragments fragments(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    fragments[i].X = static_cast<int>(random() % static_cast<unsigned int>(width));
    fragments[i].Y = static_cast<int>(random() % static_cast<unsigned int>(height));
    fragments[i].Depth = static_cast<float>(random() % 64) / 64; // some of a pixel are equal
    fragments[i].Color = { { static_cast<float>(i), 0, 0, 1 } }; // tells it from all others
  }
  return fragments;
}

std::vector<std::vector<float>> ByPixel(const Accounting::Layout& layout, const Fragments& fragments)
{
  std::vector<std::vector<float>> numbers(static_cast<std::size_t>(layout.Width) * layout.Height);
  for (const Fragment& fragment : fragments)
  {
    numbers[static_cast<std::size_t>(fragment.Y) * layout.Width + fragment.X].push_back(fragment.Color[0]);
  }
  return numbers;
}

/// What a design should give back of each pixel.
std::vector<std::vector<float>> Expected(const Accounting::Layout& layout, const Fragments& fragments)
{
  auto numbers = ByPixel(layout, fragments);
  for (auto& pixel : numbers)
  {
    if (layout.Kind == Design::LinkedList)
    {
      std::reverse(pixel.begin(), pixel.end());
    }
    else if (layout.Kind == Design::RBuffer)
    {
      std::stable_sort(pixel.begin(), pixel.end(),
        [&fragments](float a, float b)
        { return fragments[static_cast<std::size_t>(a)].Depth > fragments[static_cast<std::size_t>(b)].Depth; });
    }
  }
  return numbers;
}

void ExpectSame(const Accounting::Cost& simulated, const Accounting::Cost& computed, const std::string& what)
{
  EXPECT_EQ(simulated.Fragments, computed.Fragments) << what;
  EXPECT_EQ(simulated.Sections, computed.Sections) << what;
  EXPECT_EQ(simulated.Bytes, computed.Bytes) << what;
  EXPECT_EQ(simulated.Count.Stores, computed.Count.Stores) << what;
  EXPECT_EQ(simulated.Count.Reads, computed.Count.Reads) << what;
  EXPECT_EQ(simulated.Count.Table, computed.Count.Table) << what;
  EXPECT_EQ(simulated.Count.SecondDepth, computed.Count.SecondDepth) << what;
  EXPECT_EQ(simulated.Count.FrameBuffer, computed.Count.FrameBuffer) << what;
}

/// The simulator comes to the closed form's numbers, and gives back every fragment in its place.
void Check(const Accounting::Settings& settings, int width, int height, const Fragments& fragments,
  const std::vector<Design>& designs)
{
  const Accounting accounting(settings, { vtkStorageSimulator::Count(width, height, fragments) });
  ASSERT_EQ(accounting.GetError(), "");
  for (const Design design : designs)
  {
    const Accounting::Layout layout = accounting.GetLayout(design, 0);
    const auto result = vtkStorageSimulator::Run(layout, fragments);
    ASSERT_EQ(result.Error, "");
    ExpectSame(result.Cost, accounting.GetCost(design, 0), vtkStorageDesign::GetName(design));
    EXPECT_TRUE(ByPixel(layout, result.Read) == Expected(layout, fragments)) << vtkStorageDesign::GetName(design);
  }
}
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, GivesThePapersFigures)
{
  const Accounting accounting = PaperAccounting();
  ASSERT_EQ(accounting.GetError(), "");
  const auto toR = accounting.GetSaving(Design::TBuffer, Design::RBuffer);
  const auto toM = accounting.GetSaving(Design::TBuffer, Design::MBuffer);
  // The paper's, in its own precision, within two points.
  EXPECT_NEAR(100 * toR.Storage, 29, 2);
  EXPECT_NEAR(100 * toM.Storage, 67, 2);
  EXPECT_NEAR(100 * toR.Accesses, 52, 2);
  EXPECT_NEAR(100 * toM.Accesses, -27, 2);
  // What the header says.
  EXPECT_NEAR(100 * toR.Storage, 28.8, 0.05);
  EXPECT_NEAR(100 * toM.Storage, 68, 0.5);
  EXPECT_NEAR(100 * toR.Accesses, 51.5, 0.05);
  EXPECT_NEAR(100 * toM.Accesses, -28.4, 0.05);
  EXPECT_EQ(accounting.GetLayout(Design::TBuffer, 0).Bits.Address, 17);
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, LongSectionsOfShallowPixelsTakeMoreThanTheRBuffer)
{
  const Accounting accounting = PaperAccounting(3); // section 4: frame 480, and no other
  for (std::size_t frame = 0; frame < 8; ++frame)
  {
    const bool more =
      accounting.GetCost(Design::TBuffer, frame).Bytes > accounting.GetCost(Design::RBuffer, frame).Bytes;
    EXPECT_EQ(more, frame == 7) << "frame " << frame;
  }
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, WholeBytesComeAsCloseForStorage)
{
  Accounting::Settings settings;
  settings.Bits = { 12, 32, 32, 3, 16 }; // 8 bytes a fragment, 11 in the R-buffer, 2 an address: its sections don't fit
  EXPECT_NE(Accounting(settings, PaperFrames()).GetError(), "");
  double sum = 0;
  for (const auto& frame : PaperFrames())
  {
    double sections = 0;
    for (const auto& pixels : frame.Pixels)
    {
      sections += static_cast<double>(pixels.second * ((pixels.first + 1) / 2));
    }
    const double t = 307200 * 2 + sections * (2 * 8 + 2);
    const double r = static_cast<double>(frame.GetFragments()) * 11 + 307200 * 4 + 307200 * 3.0 / 8;
    sum += 1 - t / r;
  }
  EXPECT_NEAR(100 * sum / 8, 28.7, 0.05);
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, CountsByHand)
{
  // Four pixels: one of 5 fragments, one of 2, two of none.
  Accounting::Settings settings;
  settings.Bits = { 4, 16, 24, 3, 8 };
  settings.TSectionLength = 2;
  settings.MSectionLength = 3;
  const Accounting accounting(settings, { { 2, 2, { { 5, 1 }, { 2, 1 } } } });
  ASSERT_EQ(accounting.GetError(), "");
  const auto list = accounting.GetCost(Design::LinkedList, 0);
  EXPECT_EQ(list.Bytes, 4 * 1 + 7 * 6);
  EXPECT_EQ(list.Count.GetTotal(), 7 + 7 + 2);
  const auto t = accounting.GetCost(Design::TBuffer, 0);
  EXPECT_EQ(t.Sections, 4);
  EXPECT_EQ(t.Bytes, 4 * 1 + 4 * (2 * 5 + 1));
  EXPECT_EQ(t.Count.GetTotal(), 7 + 7 + 2);
  const auto r = accounting.GetCost(Design::RBuffer, 0);
  EXPECT_EQ(r.Bytes, 7 * 6 + 4 * 2 + 4 * 3 / 8.0);
  EXPECT_EQ(r.Count.Reads, 15 + 3);
  EXPECT_EQ(r.Count.GetTotal(), 7 + 18 + 18 + 7);
  const auto m = accounting.GetCost(Design::MBuffer, 0);
  EXPECT_EQ(m.Sections, 5);
  EXPECT_EQ(m.Bytes, 5 * (3 * 5 + 1));
  EXPECT_EQ(m.Count.GetTotal(), 7 + 7);
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, ChoosesAddresses)
{
  const auto bits = [](Design design, const std::vector<Accounting::Histogram>& frames)
  { return Accounting({}, frames).GetLayout(design, 0).Bits.Address; };
  EXPECT_EQ(bits(Design::LinkedList, { { 8, 1, { { 1, 3 } } } }), 2); // three and none
  EXPECT_EQ(bits(Design::LinkedList, { { 8, 1, { { 1, 4 } } } }), 3);
  EXPECT_EQ(bits(Design::TBuffer, { { 8, 1, { { 1, 3 } } }, { 8, 1, { { 2, 4 } } } }), 3); // of the fullest frame
  EXPECT_EQ(bits(Design::MBuffer, { { 8, 1, { { 1, 8 } } } }), 1);
  EXPECT_EQ(bits(Design::MBuffer, { { 8, 1, { { 1, 7 }, { 100, 1 } } } }), 3); // sections of 13: seven more
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, SaysWhatIsWrong)
{
  const auto error = [](const Accounting::Settings& settings, const Accounting::Histogram& frame)
  { return Accounting(settings, { frame }).GetError(); };
  const Accounting::Histogram frame{ 4, 4, { { 3, 5 } } };
  Accounting::Settings settings;
  EXPECT_EQ(error(settings, frame), "");
  settings.TSectionLength = 0;
  EXPECT_EQ(error(settings, frame), "the T-buffer's section length is 0, expected 1 to 64");
  settings = {};
  settings.MSectionLength = 65;
  EXPECT_EQ(error(settings, frame), "the M-buffer's section length is 65, expected 0 to 64");
  settings = {};
  settings.Bits.Address = 3;
  EXPECT_EQ(error(settings, frame), "address bits are 3, expected at least 4 for the 15 sections of the linked-list");
  settings.Bits.Address = 4;
  EXPECT_EQ(error(settings, frame), "");
  settings = {};
  settings.Bits.Coordinate = 1;
  EXPECT_EQ(error(settings, frame), "frame 0: width is 4, expected 1 to 2, with coordinates of 1 bits");
  EXPECT_EQ(error({}, { 4, 0, {} }), "frame 0: height is 0, expected 1 to 65536, with coordinates of 16 bits");
  EXPECT_EQ(error({}, { 4, 4, { { 0, 5 } } }), "frame 0: fragments of a pixel is 0, expected 1 to 1000000000");
  EXPECT_EQ(error({}, { 4, 4, { { 2, 10 }, { 3, 7 } } }), "frame 0: pixels of 3 fragments is 7, expected 0 to 6");
  EXPECT_EQ(error({}, { 4, 4, { { 2, -1 } } }), "frame 0: pixels of 2 fragments is -1, expected 0 to 16");
  EXPECT_EQ(
    error({}, { 4, 4, { { 600000000, 2 } } }), "frame 0 has more than 1000000000 fragments, expected at most as many");
}

//------------------------------------------------------------------------------
TEST(TestStorageAccounting, FramesWithoutFragmentsDontCountInMeans)
{
  const Accounting::Histogram frame{ 4, 4, { { 3, 5 } } };
  const auto one = Accounting({}, { frame }).GetSaving(Design::TBuffer, Design::RBuffer);
  const auto two = Accounting({}, { frame, { 4, 4, {} } }).GetSaving(Design::TBuffer, Design::RBuffer);
  EXPECT_EQ(one.Storage, two.Storage);
  EXPECT_EQ(one.Accesses, two.Accesses);
  EXPECT_EQ(Accounting({}, { { 4, 4, {} } }).GetSaving(Design::TBuffer, Design::RBuffer).Storage, 0);
}

//------------------------------------------------------------------------------
RC_GTEST_PROP(TestStorageSimulator, ComesToTheClosedForms, ())
{
  Accounting::Settings settings;
  settings.TSectionLength = *rc::gen::inRange(1, 65);
  settings.MSectionLength = *rc::gen::inRange(0, 65);
  settings.Bits.Coordinate = *rc::gen::inRange(4, 33);
  settings.Bits.Depth = *rc::gen::inRange(1, 65);
  settings.Bits.Color = *rc::gen::inRange(1, 65);
  settings.Bits.State = *rc::gen::inRange(1, 65);
  settings.Bits.Address = *rc::gen::element(0, 10, 17, 64);
  const int width = *rc::gen::inRange(1, 9);
  const int height = *rc::gen::inRange(1, 9);
  const std::size_t count = *rc::gen::inRange<std::size_t>(0, 600);
  Check(settings, width, height, RandomFragments(width, height, count, *rc::gen::arbitrary<unsigned int>()),
    vtkStorageDesign::GetAll());
  RC_ASSERT(!testing::Test::HasFailure());
}

//------------------------------------------------------------------------------
TEST(TestStorageSimulator, TakesAMillionFragments)
{
  Check({}, 64, 64, RandomFragments(64, 64, 1000000, 1), vtkStorageDesign::GetAll());
}

//------------------------------------------------------------------------------
TEST(TestStorageSimulator, TakesADeepPixel)
{
  Check({}, 1, 1, RandomFragments(1, 1, 100000, 2), { Design::LinkedList, Design::TBuffer, Design::MBuffer });
  Check({}, 3, 1, RandomFragments(1, 1, 100000, 3), { Design::LinkedList, Design::TBuffer, Design::MBuffer });
  // The R-buffer reads its FIFO once a fragment here: a fifth of the fragments, a twenty-fifth of the time.
  Check({}, 1, 1, RandomFragments(1, 1, 20000, 4), { Design::RBuffer });
}

//------------------------------------------------------------------------------
TEST(TestStorageSimulator, ReadsNothingFromNothing)
{
  Check({}, 5, 3, {}, vtkStorageDesign::GetAll());
}

//------------------------------------------------------------------------------
TEST(TestStorageSimulator, SaysWhatIsWrong)
{
  const Accounting accounting({}, { { 4, 4, { { 3, 1 } } } });
  const auto error = [&accounting](Design design, const Fragments& fragments)
  { return vtkStorageSimulator::Run(accounting.GetLayout(design, 0), fragments).Error; };
  for (const Design design : vtkStorageDesign::GetAll())
  {
    EXPECT_EQ(error(design, { { 3, 3, 1.0f, {} } }), "");
    EXPECT_EQ(error(design, { { 3, 3, 1.0f, {} }, { 4, 0, 0.5f, {} } }),
      "fragment 1 is at 4, 0 and depth 0.500000, expected a pixel of 4x4 and a depth of 0 to 1");
    EXPECT_NE(error(design, { { 0, -1, 0.5f, {} } }), "");
    EXPECT_NE(error(design, { { 0, 0, std::numeric_limits<float>::quiet_NaN(), {} } }), "");
  }
  // The addresses are those of a frame of two or three sections.
  EXPECT_NE(error(Design::LinkedList, Fragments(4)), "");
  EXPECT_EQ(error(Design::TBuffer, Fragments(6)), "");
  EXPECT_EQ(error(Design::TBuffer, Fragments(8)), "section 4 has no address, expected more than 2 bits for it");
  EXPECT_EQ(error(Design::MBuffer, Fragments(6)), "");
  EXPECT_NE(error(Design::MBuffer, Fragments(9)), "");
}
