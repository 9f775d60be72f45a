// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CriticalSection/Interlock.glsl: the hardware lets the fragments of a pixel through one at a time, in the order of
// drawing (GL_ARB_fragment_shader_interlock, its ancestor of NVIDIA, or Intel's ordering).
//
// The extensions want the section's two ends in main, outside of any branch: that is where Core writes BEGIN_ and
// END_CRITICAL_SECTION. Between them, what an earlier fragment of the pixel wrote to coherent memory is seen by the
// later one: both ends are barriers for it, so no memoryBarrier is needed. Intel's section has no end: it lasts to the
// end of the shader. A fragment may have been discarded before, which the extensions allow; they don't allow a return,
// and here nobody tries again (vtkTranslucencyShader::LeaveAtDiscards).
//
// Needs: nothing.  Gives: CRITICAL_MEMORY, CRITICAL_SECTION, BEGIN_CRITICAL_SECTION, END_CRITICAL_SECTION
// (Spinlock.glsl says what they are), AFTER_DISCARD.
#ifndef CriticalSection_glsl
#define CriticalSection_glsl

#if defined(GL_ARB_fragment_shader_interlock)
layout(pixel_interlock_ordered) in;
#define BEGIN_CRITICAL_SECTION beginInvocationInterlockARB();
#define END_CRITICAL_SECTION endInvocationInterlockARB();
#elif defined(GL_NV_fragment_shader_interlock)
layout(pixel_interlock_ordered) in;
#define BEGIN_CRITICAL_SECTION beginInvocationInterlockNV();
#define END_CRITICAL_SECTION endInvocationInterlockNV();
#elif defined(GL_INTEL_fragment_shader_ordering)
#define BEGIN_CRITICAL_SECTION beginFragmentShaderOrderingINTEL();
#define END_CRITICAL_SECTION
#else
#error "CriticalSection/Interlock.glsl needs an extension that orders fragment shaders"
#endif

#define AFTER_DISCARD
#define CRITICAL_MEMORY coherent
#define CRITICAL_SECTION(pixel, statement) { statement; }

#endif
