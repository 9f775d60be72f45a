// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * Occlusion queries.
 */
#ifndef vtkTranslucencyQuery_h
#define vtkTranslucencyQuery_h

#include "vtkTranslucencyABINamespace.h"
#include "vtkTranslucencyVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
/// Whether anything passes the tests of what a function draws. Waits for it. Queries can't be nested.
template <typename Function>
bool vtkTranslucencyAnySamplesPass(const Function& draw)
{
  GLuint query = 0;
  GLuint passed = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
  draw();
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  glDeleteQueries(1, &query);
  return passed != 0;
}

/// Draws; any becomes true if anything passes. Where any is null nobody asks, and nothing is waited for.
template <typename Function>
void vtkTranslucencyDrawAndAsk(bool* any, const Function& draw)
{
  if (any)
  {
    *any = vtkTranslucencyAnySamplesPass(draw) || *any;
  }
  else
  {
    draw();
  }
}
VTK_ABI_NAMESPACE_END

#endif
