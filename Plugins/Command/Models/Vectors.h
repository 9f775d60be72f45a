// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's vectors with their operators, which have a header of their own up to release 9.5.
 */
#ifndef Vectors_h
#define Vectors_h

#include "vtkVector.h"
#if __has_include("vtkVectorOperators.h")
#include "vtkVectorOperators.h"
#endif

#endif
