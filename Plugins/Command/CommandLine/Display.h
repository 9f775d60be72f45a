// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK draws off-screen, but some builds of it need an X display to do so.
 */
#ifndef Display_h
#define Display_h

/**
 * Returns if VTK's windows can draw: by X, or, where VTK has a choice, by EGL or OSMesa, of which nothing is said.
 * Otherwise the process starts itself again under xvfb-run and does not return; without xvfb-run it throws a Failure
 * that says what to install.
 */
void EnsureDisplay(char** arguments);

#endif
