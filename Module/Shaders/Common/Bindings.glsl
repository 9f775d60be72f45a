// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Bindings.glsl: the numbers of the buffer bindings, shared by the shaders and the C++ that fills the buffers.
#ifndef Bindings_glsl
#define Bindings_glsl

#define STORAGE_BINDING_STATISTICS 0 // written by the resolve, see Statistics.glsl
#define STORAGE_BINDING_COUNTERS 1   // fragment storage: what was allocated; locks of pixels
#define STORAGE_BINDING_TABLE 2      // fragment storage: one entry a pixel; counts of records
#define STORAGE_BINDING_FRAGMENTS 3  // fragment storage: the fragments; records of pixels
#define STORAGE_BINDING_SAMPLES 4    // see SampleColors.glsl
#define STORAGE_BINDING_NEXT 5       // fragment storage: next sections; the pixels of a queue
#define STORAGE_BINDING_LINKS 6      // fragment storage: links of fragments that have been moved; second depths
#define STORAGE_BINDING_READ_BACK 7  // what the application reads, see Storage/CountAccesses.glsl, Trace/Resolve.glsl
#define STORAGE_BINDINGS 8

#define RESOLVE_SQUARE 16 // pixels, see Statistics.glsl
// Words of the statistics before those of squares, see Statistics.glsl: of the whole frame, then of a tile's storage,
// then of its resolves.
#define STATISTICS_TILE 2
#define STATISTICS_RESOLVES 6
#define STATISTICS_WORDS 8
#define LEVEL_SAMPLES 31  // pixels whose samples differ and wait in SampleColors.glsl
#define LEVEL_EACH_SAMPLE 30 // pixels whose samples differ and are resolved one by one, see Samples.glsl

#define PIXEL_BLOCK_WIDTH 8 // see Pixels.glsl
#define PIXEL_BLOCK_HEIGHT 4

#define EMPTY_NUMBER 1e30f // behind every depth: see PixelTargets.glsl

#define UNIFORM_BINDING_STORAGE 0 // fragment storage: its layout
#define UNIFORM_BINDINGS 1

#endif
