// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * What draws in the place of a technique that the driver can't run, or that has failed. Core does not know which
 * technique that is: vtkTranslucencyFactory.cxx says so.
 */
#ifndef vtkTranslucencyFallback_h
#define vtkTranslucencyFallback_h

#include "vtkTranslucencyABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyPass;

/// A new pass of an exact technique that needs targets, and nothing else. storage: whether the driver has storage
/// buffers, which it does not use.
vtkTranslucencyPass* vtkTranslucencyNewFallback(bool storage);
VTK_ABI_NAMESPACE_END

#endif
