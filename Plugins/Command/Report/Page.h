// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The page that a comparison ends in: pictures, differences and costs, for someone who has never heard of any of it.
 */
#ifndef Page_h
#define Page_h

#include "Report.h"

#include <map>
#include <string>

/// HTML in one file. pictures: the contents of each PNG that the report names.
std::string ToPage(const Report& report, const std::map<std::string, std::string>& pictures);

#endif
