// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene for effects: lights, lines, and translucent surfaces of which the order matters or does not.
 */
#ifndef Room_h
#define Room_h

#include "RenderTest.h"

#include <vtkActor.h>

/// An opaque wall with a ball and a wireframe before it, and two translucent quads that hide a part of each, side by
/// side. Others, behind and before them, can be shown, with which the order matters.
class Room
{
public:
  /// In a renderer that is given, or a new one.
  explicit Room(int samples, const vtkSmartPointer<vtkRenderer>& renderer = vtkSmartPointer<vtkRenderer>::New());

  void ShowTranslucent(bool shown);
  void ShowOthers(bool shown);
  Picture Render();

  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;

private:
  vtkActor* AddQuad(double x, double y, double z, double size);

  std::vector<vtkActor*> Quads; // side by side
  std::vector<vtkActor*> Others;
};

/// Whether a technique blends a single surface over what is behind it as VTK does, but for rounding.
bool BlendsOneSurface(const std::string& technique);

#endif
