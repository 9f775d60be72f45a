// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The manual page, from what the command line declares.
 */
#ifndef Manual_h
#define Manual_h

#include <string>

namespace CLI
{
class App;
}

/// The page in the language of man(7).
std::string ManualText(const CLI::App& app);

#endif
