// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CriticalSection/None.glsl: no protection, for drivers that shade the fragments of a pixel one after the other.
//
// Software rasterizers do: one thread draws a tile of the picture, a primitive at a time, and the lanes of its vectors
// are different pixels. Anywhere else fragments get lost.
//
// Needs: nothing.  Gives: CRITICAL_MEMORY, CRITICAL_SECTION, BEGIN_CRITICAL_SECTION, END_CRITICAL_SECTION
// (Spinlock.glsl says what they are).
#ifndef CriticalSection_glsl
#define CriticalSection_glsl

#define CRITICAL_MEMORY
#define CRITICAL_SECTION(pixel, statement) { statement; }
#define BEGIN_CRITICAL_SECTION
#define END_CRITICAL_SECTION

#endif
