// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Values out of range are refused with an error that names the option, the value and what was expected.
#include "RenderTest.h"

#include <vtkFragmentStorage.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyOption.h>

#include <cmath>
#include <limits>

namespace
{
struct BadValue
{
  std::string Name;
  std::function<double(vtkAdaptiveTransparencyPass*, vtkABufferPass*)> Get;
  std::function<void(vtkAdaptiveTransparencyPass*, vtkABufferPass*)> Set;
  std::string Expected;
};

void PrintTo(const BadValue& value, std::ostream* os)
{
  *os << value.Name;
}

BadValue NodeCount(int count, const std::string& name)
{
  return { "NodeCount" + name, [](auto* adaptive, auto*) -> double { return adaptive->GetNodeCount(); },
    [count](auto* adaptive, auto*) { adaptive->SetNodeCount(count); }, "1 to 64" };
}

BadValue NodeRemoval(int removal, const std::string& name)
{
  return { "NodeRemoval" + name, [](auto* adaptive, auto*) -> double { return adaptive->GetNodeRemoval(); },
    [removal](auto* adaptive, auto*) { adaptive->SetNodeRemoval(removal); },
    "underestimate (0), overestimate (1) or mixed (2)" };
}

BadValue Tolerance(double tolerance, const std::string& name)
{
  return { "Tolerance" + name, [](auto* adaptive, auto*) { return adaptive->GetTolerance(); },
    [tolerance](auto* adaptive, auto*) { adaptive->SetTolerance(tolerance); }, "0 to 1" };
}

BadValue Show(int show, const std::string& name)
{
  return { "Show" + name, [](auto* adaptive, auto*) -> double { return adaptive->GetShow(); },
    [show](auto* adaptive, auto*) { adaptive->SetShow(show); }, "picture (0), error (1) or nodes (2)" };
}

BadValue Resolve(int resolve, const std::string& name)
{
  return { "Resolve" + name, [](auto*, auto* exact) -> double { return exact->GetResolve(); },
    [resolve](auto*, auto* exact) { exact->SetResolve(resolve); }, "recursive (0) or iterative (1)" };
}

BadValue ColorFormat(int format, const std::string& name)
{
  return { "ColorFormat" + name, [](auto*, auto* exact) -> double { return exact->GetStorage()->GetColorFormat(); },
    [format](auto*, auto* exact) { exact->GetStorage()->SetColorFormat(format); }, "half-float (0) or rgba8 (1)" };
}

BadValue MemoryLimit(double limit, const std::string& name)
{
  return { "MemoryLimit" + name, [](auto*, auto* exact) { return exact->GetStorage()->GetMemoryLimit(); },
    [limit](auto*, auto* exact) { exact->GetStorage()->SetMemoryLimit(limit); }, "0 or more" };
}

BadValue StorageDesign(int design, const std::string& name)
{
  return { "StorageDesign" + name, [](auto*, auto* exact) -> double { return exact->GetStorageDesign(); },
    [design](auto*, auto* exact) { exact->SetStorageDesign(design); },
    "linked-list (0), t-buffer (1), r-buffer (2) or m-buffer (3)" };
}

BadValue SectionLength(int length, const std::string& name)
{
  return { "SectionLength" + name, [](auto*, auto* exact) -> double { return exact->GetSectionLength(); },
    [length](auto*, auto* exact) { exact->SetSectionLength(length); }, "1 to 64" };
}
}

class TestBadValue
  : public RenderTest
  , public testing::WithParamInterface<BadValue>
{
};

//------------------------------------------------------------------------------
TEST_P(TestBadValue, IsAnErrorAndChangesNothing)
{
  vtkNew<vtkAdaptiveTransparencyPass> adaptive;
  vtkNew<vtkABufferPass> exact;
  const double before = GetParam().Get(adaptive, exact);
  const vtkMTimeType adaptiveTime = adaptive->GetMTime();
  const vtkMTimeType exactTime = exact->GetMTime();
  GetParam().Set(adaptive, exact);
  EXPECT_EQ(GetParam().Get(adaptive, exact), before);
  EXPECT_EQ(adaptive->GetMTime(), adaptiveTime);
  EXPECT_EQ(exact->GetMTime(), exactTime);
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  const std::string option = GetParam().Name.substr(0, GetParam().Name.find('_'));
  EXPECT_NE(messages[0].find(option + " is "), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find(", expected " + GetParam().Expected + "\n"), std::string::npos) << messages[0];
}

INSTANTIATE_TEST_SUITE_P(Options, TestBadValue,
  testing::Values(NodeCount(0, "_0"), NodeCount(-1, "_Negative"), NodeCount(65, "_65"), NodeCount(1000, "_1000"),
    Tolerance(-0.1, "_Negative"), Tolerance(1.1, "_AboveOne"),
    Tolerance(std::numeric_limits<double>::quiet_NaN(), "_NaN"), Show(-1, "_Negative"), Show(3, "_3"),
    NodeRemoval(-1, "_Negative"), NodeRemoval(3, "_3"), Resolve(-1, "_Negative"), Resolve(2, "_2"),
    ColorFormat(-1, "_Negative"), ColorFormat(2, "_2"), MemoryLimit(-1, "_Negative"),
    MemoryLimit(std::numeric_limits<double>::quiet_NaN(), "_NaN"), StorageDesign(-1, "_Negative"),
    StorageDesign(4, "_4"), SectionLength(0, "_0"), SectionLength(-1, "_Negative"), SectionLength(65, "_65"),
    SectionLength(10000, "_10000")),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestOptions = RenderTest;

namespace
{
// Of every technique but VTK's own.
std::vector<vtkSmartPointer<vtkTranslucencyPass>> NewPasses()
{
  std::vector<vtkSmartPointer<vtkTranslucencyPass>> passes;
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const auto pass = vtkSmartPointer<vtkRenderPass>::Take(
      vtkTranslucencyFactory::CreateTechnique(vtkTranslucencyFactory::GetTechniqueName(i)));
    if (auto* own = vtkTranslucencyPass::SafeDownCast(pass))
    {
      passes.emplace_back(own);
    }
  }
  return passes;
}
}

TEST_F(TestOptions, TakesTheValuesAtTheEndsOfARange)
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  for (int count : { 1, 64 })
  {
    pass->SetNodeCount(count);
    EXPECT_EQ(pass->GetNodeCount(), count);
    pass->SetSectionLength(count);
    EXPECT_EQ(pass->GetSectionLength(), count);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestOptions, ByKeywordAreTheProperties)
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  EXPECT_TRUE(pass->SetOption("nodes", "24"));
  EXPECT_EQ(pass->GetNodeCount(), 24);
  EXPECT_EQ(pass->GetOption("nodes"), "24");
  EXPECT_TRUE(pass->SetOption("section_length", "7"));
  EXPECT_EQ(pass->GetSectionLength(), 7);
  EXPECT_TRUE(pass->SetOption("storage", "m-buffer"));
  EXPECT_EQ(pass->GetStorageDesign(), vtkFragmentListPass::MBuffer);
  EXPECT_EQ(pass->GetOption("storage"), "m-buffer");
}

//------------------------------------------------------------------------------
TEST_F(TestOptions, TakeBackTheirOwnText)
{
  for (const vtkSmartPointer<vtkTranslucencyPass>& pass : NewPasses())
  {
    for (int i = 0; i < pass->GetNumberOfOptions(); ++i)
    {
      const std::string keyword = pass->GetOptionKeyword(i);
      SCOPED_TRACE(std::string(pass->GetClassName()) + ", " + keyword);
      EXPECT_FALSE(pass->GetOptionHelp(i).empty());
      const std::string text = pass->GetOption(keyword);
      EXPECT_TRUE(pass->SetOption(keyword, text));
      EXPECT_EQ(pass->GetOption(keyword), text);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestOptions, StartWithTheirDeclaredDefaults)
{
  for (const vtkSmartPointer<vtkTranslucencyPass>& pass : NewPasses())
  {
    for (const vtkTranslucencyOption& option : pass->GetOptions())
    {
      EXPECT_EQ(option.Get(), option.Default) << pass->GetClassName() << ", " << option.Name;
    }
  }
}

//------------------------------------------------------------------------------
// The setters themselves; what is off or on has no range.
TEST_F(TestOptions, RefuseWhatIsJustOutOfRange)
{
  int refused = 0;
  for (const vtkSmartPointer<vtkTranslucencyPass>& pass : NewPasses())
  {
    for (const vtkTranslucencyOption& option : pass->GetOptions())
    {
      SCOPED_TRACE(std::string(pass->GetClassName()) + ", " + option.Name);
      const double step = option.Type == vtkTranslucencyOption::Kind::Real ? 0.125 : 1;
      for (double value : { option.Minimum - step, option.Maximum + step })
      {
        if (std::isinf(value) || option.Choices == std::vector<std::string>{ "off", "on" })
        {
          continue;
        }
        ++refused;
        const vtkMTimeType before = pass->GetMTime();
        option.Set(value);
        EXPECT_EQ(option.Get(), option.Default) << value;
        EXPECT_EQ(pass->GetMTime(), before) << value;
        const std::vector<std::string> messages = TakeMessages();
        ASSERT_EQ(messages.size(), 1u) << value;
        EXPECT_NE(messages[0].find(option.Name + " is "), std::string::npos) << messages[0];
        EXPECT_NE(messages[0].find("expected"), std::string::npos) << messages[0];
      }
    }
  }
  EXPECT_GT(refused, 60);
}

//------------------------------------------------------------------------------
TEST_F(TestOptions, RefuseWhatTheyDoNotTake)
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  const struct
  {
    std::string Keyword;
    std::string Value;
    std::string Named; // by the error
  } refused[] = {
    { "nodes", "0", "nodes is '0', expected an integer in 1..64" },
    { "nodes", "1000", "nodes is '1000', expected an integer in 1..64" },
    { "nodes", "many", "nodes is 'many', expected" },
    { "nodes", "", "nodes is '', expected" },
    { "nodes", "8.5", "nodes is '8.5', expected" },
    { "nodes", "nan", "nodes is 'nan', expected" },
    { "memory_limit", "-1", "memory_limit is '-1', expected a number" },
    { "color_format", "rgb565", "color_format is 'rgb565', expected half-float or rgba8" },
    { "storage", "x-buffer", "storage is 'x-buffer', expected linked-list, t-buffer, r-buffer or m-buffer" },
    { "section_length", "0", "section_length is '0', expected an integer in 1..64" },
    { "section_length", "10000", "section_length is '10000', expected an integer in 1..64" },
    { "section_length", "long", "section_length is 'long', expected" },
    { "node", "8", "no option 'node', expected one of" },
    { "", "", "no option '', expected one of" },
  };
  for (const auto& attempt : refused)
  {
    EXPECT_FALSE(pass->SetOption(attempt.Keyword, attempt.Value)) << attempt.Named;
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << attempt.Named;
    EXPECT_NE(messages[0].find(attempt.Named), std::string::npos) << messages[0];
  }
  EXPECT_EQ(pass->GetNodeCount(), 16);
  EXPECT_EQ(pass->GetStorageDesign(), vtkFragmentListPass::LinkedList);
  EXPECT_EQ(pass->GetSectionLength(), 4);
}
