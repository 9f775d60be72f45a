// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What "translucency list" prints.
 */
#ifndef TechniqueList_h
#define TechniqueList_h

#include <string>

/// The techniques, their options, and whether the driver can run them.
std::string TechniqueListText(bool json);

#endif
