// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * The namespace that VTK's own classes are in, if it was built with one: several VTKs can then be in one program.
 * VTK 9.1 has none.
 */
#ifndef vtkTranslucencyABINamespace_h
#define vtkTranslucencyABINamespace_h

#ifndef __VTK_WRAP__ // whose parser does not know the next line
#if __has_include("vtkABINamespace.h")
#include "vtkABINamespace.h" // IWYU pragma: export
#endif
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
