// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * That a technique is drawing, for as long as one of these lives. The passes that it draws the props with are VTK's
 * then, and not to be replaced by a technique.
 */
#ifndef vtkTranslucencyDrawing_h
#define vtkTranslucencyDrawing_h

class vtkTranslucencyDrawing
{
public:
  vtkTranslucencyDrawing() { ++Depth(); }
  ~vtkTranslucencyDrawing() { --Depth(); }
  vtkTranslucencyDrawing(const vtkTranslucencyDrawing&) = delete;
  vtkTranslucencyDrawing& operator=(const vtkTranslucencyDrawing&) = delete;

  static bool IsOn() { return Depth() > 0; }

private:
  static int& Depth()
  {
    thread_local int depth = 0;
    return depth;
  }
};

#endif
