// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKBufferPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkKBufferPass);
