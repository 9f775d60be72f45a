// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The command's own libraries, that it loads only where it needs them.
 */
#ifndef Libraries_h
#define Libraries_h

#include <string>

/// Where the library of that name is: in the installation that the command is a part of, whichever place that was moved
/// to. Throws Failure if it is not there; purpose is what the message says of it: "programs are run with".
std::string FindLibrary(const std::string& name, const std::string& purpose);

#endif
