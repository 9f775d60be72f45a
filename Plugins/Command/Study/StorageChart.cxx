// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StorageReport.h"

#include "Basics/Messages.h"
#include "Techniques/Picture.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlot.h"
#include "vtkRenderWindow.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
constexpr std::array<int, 2> ChartSize{ { 1100, 600 } };
constexpr std::size_t MostLabels = 10; // frames that are named below the axis

// One row a frame, one column a design, behind that of the frames' places.
vtkSmartPointer<vtkTable> MakeTable(const StorageReport& report, StorageChart chart)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkFloatArray> places;
  places->SetName("frame");
  for (std::size_t i = 0; i < report.Frames.size(); ++i)
  {
    places->InsertNextValue(static_cast<float>(i));
  }
  table->AddColumn(places);
  for (std::size_t design = 0; design < report.Frames.front().Layouts.size(); ++design)
  {
    vtkNew<vtkFloatArray> column;
    column->SetName(vtkStorageDesign::GetName(report.Frames.front().Layouts[design].Kind).c_str());
    for (const StorageFrame& frame : report.Frames)
    {
      const vtkStorageAccounting::Cost& cost = frame.Costs[design];
      column->InsertNextValue(static_cast<float>(
        chart == StorageChart::Bytes ? cost.Bytes / (1024 * 1024) : static_cast<double>(cost.Count.GetTotal()) / 1e6));
    }
    table->AddColumn(column);
  }
  return table;
}

void NameFrames(const StorageReport& report, vtkAxis* axis)
{
  const std::size_t step = (report.Frames.size() + MostLabels - 1) / MostLabels;
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> names;
  for (std::size_t i = 0; i < report.Frames.size(); i += step)
  {
    places->InsertNextValue(static_cast<double>(i));
    names->InsertNextValue(report.Frames[i].Name);
  }
  axis->SetCustomTickPositions(places, names);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(-0.6, static_cast<double>(report.Frames.size()) - 0.4);
  axis->SetTitle("");
  axis->SetGridVisible(false);
}

vtkSmartPointer<vtkChartXY> MakeChart(const StorageReport& report, StorageChart chart)
{
  const unsigned char colors[][3] = { { 140, 140, 140 }, { 33, 120, 181 }, { 227, 120, 33 }, { 77, 153, 74 } };
  const auto table = MakeTable(report, chart);
  auto made = vtkSmartPointer<vtkChartXY>::New();
  for (vtkIdType column = 1; column < table->GetNumberOfColumns(); ++column)
  {
    const unsigned char* color = colors[column - 1];
    vtkPlot* plot = made->AddPlot(vtkChart::BAR);
    plot->SetInputData(table, 0, column);
    plot->SetColor(color[0], color[1], color[2], 255);
  }
  made->SetTitle((chart == StorageChart::Bytes ? "Storage: " : "Accesses: ") + report.Title);
  made->GetTitleProperties()->SetFontSize(16);
  made->SetShowLegend(true);
  made->GetLegend()->SetLabelSize(14);
  made->GetLegend()->SetInline(false); // beside the bars: it would hide some
  made->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  NameFrames(report, made->GetAxis(vtkAxis::BOTTOM));
  vtkAxis* amount = made->GetAxis(vtkAxis::LEFT);
  amount->SetTitle(chart == StorageChart::Bytes ? "MiB a frame" : "millions of accesses a frame");
  amount->SetMinimumLimit(0);
  for (int axis : { vtkAxis::BOTTOM, vtkAxis::LEFT })
  {
    made->GetAxis(axis)->GetLabelProperties()->SetFontSize(14);
    made->GetAxis(axis)->GetTitleProperties()->SetFontSize(14);
  }
  return made;
}
}

//------------------------------------------------------------------------------
void DrawChart(
  const StorageReport& report, StorageChart chart, const std::filesystem::path& file, const std::string& name)
{
  vtkNew<vtkContextView> view;
  vtkRenderWindow* window = view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SwapBuffersOff();
  window->SetSize(ChartSize[0], ChartSize[1]);
  view->GetScene()->AddItem(MakeChart(report, chart));
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int back = 0;
  window->GetPixelData(0, 0, ChartSize[0] - 1, ChartSize[1] - 1, back, pixels);
  Messages::Get()->ThrowError("the chart can't be drawn");
  NewPicture(ChartSize[0], ChartSize[1], 3, pixels->GetPointer(0))->Write(file, name);
}
