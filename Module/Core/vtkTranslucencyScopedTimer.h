// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyScopedTimer
 *
 * Adds the time of its scope to a sum, if asked to. Waits for the GPU at both ends: timer queries are not kept in order
 * with the drawing by every driver.
 */
#ifndef vtkTranslucencyScopedTimer_h
#define vtkTranslucencyScopedTimer_h

#include "vtkTranslucencyABINamespace.h"
#include "vtkTranslucencyVTKVersion.h"

#include <algorithm>
#include <chrono>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyScopedTimer
{
public:
  vtkTranslucencyScopedTimer(bool wanted, double& milliseconds)
    : Milliseconds(wanted ? &milliseconds : nullptr)
  {
    if (this->Milliseconds)
    {
      glFinish();
      this->Start = Clock::now();
    }
  }
  ~vtkTranslucencyScopedTimer()
  {
    if (this->Milliseconds)
    {
      glFinish();
      const std::chrono::duration<double, std::milli> passed = Clock::now() - this->Start;
      *this->Milliseconds = std::max(0.0, *this->Milliseconds) + passed.count();
    }
  }
  vtkTranslucencyScopedTimer(const vtkTranslucencyScopedTimer&) = delete;
  vtkTranslucencyScopedTimer& operator=(const vtkTranslucencyScopedTimer&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double* Milliseconds;
  Clock::time_point Start;
};
VTK_ABI_NAMESPACE_END

#endif
