// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the command's subcommands do.
 */
#ifndef Commands_h
#define Commands_h

struct Arguments;

/// Does what was asked; throws Failure.
void RunCommand(const Arguments& arguments);

#endif
