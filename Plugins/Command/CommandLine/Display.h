// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK draws off-screen, but VTK built for X needs a display to do so.
 */
#ifndef Display_h
#define Display_h

/**
 * Returns if VTK's windows can be opened. Without an X display the process starts itself again under xvfb-run and
 * does not return; without xvfb-run it throws a Failure that says what to install.
 */
void EnsureDisplay(char** arguments);

#endif
