// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CriticalSection/Spinlock.glsl: one lock a pixel, taken by compare-and-swap. The fragments of a pixel come in any
// order.
//
// CRITICAL_SECTION(pixel, statement) runs the statement while nobody else is at the pixel. CRITICAL_MEMORY qualifies
// the buffers that it changes. BEGIN_ and END_CRITICAL_SECTION stand in main around all of it, for sections that only
// main can have.
//
// Why a flag and not `while (locked)`: the lanes of a vector run in lockstep. If one lane has the lock and another of
// the same vector waits for it in a loop, the first never gets to the line behind the loop where it would give the lock
// back. Here each round of the loop takes the lock, works and gives it back, and only then are the lanes that failed
// tried again.
//
// Why two barriers: atomic operations order nothing but themselves. The first keeps the section's reads behind the
// taking of the lock, so that they see what the last owner wrote; the second keeps its writes before the giving back.
// Coherent memory makes both visible to other multiprocessors, whose caches would hold old values otherwise.
//
// Helper invocations, which only serve derivatives, write nothing and get undefined results from atomic operations:
// they must not wait, so where a driver does not tell them there is no spin lock
// (vtkTranslucencyCapabilities::MissingForRetries). Fragments that have been discarded do not come here
// (vtkTranslucencyShader::LeaveAtDiscards).
//
// Needs: pixelIndex (Common/Pixels.glsl), GL_ARB_ES3_1_compatibility.  Gives: CRITICAL_MEMORY, CRITICAL_SECTION,
// BEGIN_CRITICAL_SECTION, END_CRITICAL_SECTION.
#ifndef CriticalSection_glsl
#define CriticalSection_glsl
#ifndef GL_ARB_ES3_1_compatibility
#error "CriticalSection/Spinlock.glsl needs GL_ARB_ES3_1_compatibility, to know helper invocations"
#endif
#include "Common/Bindings.glsl"

layout(std430, binding = STORAGE_BINDING_COUNTERS) coherent buffer PixelLocks
{
  uint pixelLocks[]; // one a pixel: 0 free, 1 taken
};

#define CRITICAL_MEMORY coherent
#define CRITICAL_SECTION(pixel, statement) \
  { \
    uint lock = pixelIndex(pixel); \
    bool done = gl_HelperInvocation; \
    while (!done) \
    { \
      if (atomicCompSwap(pixelLocks[lock], 0u, 1u) == 0u) \
      { \
        memoryBarrier(); \
        statement; \
        memoryBarrier(); \
        atomicExchange(pixelLocks[lock], 0u); \
        done = true; \
      } \
    } \
  }
#define BEGIN_CRITICAL_SECTION
#define END_CRITICAL_SECTION

#endif
