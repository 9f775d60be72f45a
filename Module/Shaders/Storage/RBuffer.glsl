// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// RBuffer.glsl: a first-in first-out buffer of fragments with their pixel: the R-buffer. Reading them takes passes over
// all of it, Storage/Retrieve.glsl, which makes a list of each pixel in the end.
//
// Where a driver keeps the order of drawing, RBufferInOrder.glsl is used instead.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage.
#ifndef RBuffer_glsl
#define RBuffer_glsl
#define READS_COUNT 0 // of its lists: Storage/Retrieve.glsl has counted
#define TABLE_COUNTS 0
#define READ_GROUP 1
#define UNIT_LENGTH 1
#include "Storage/Nodes.glsl"
#include "Storage/Queue.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  queueFragment(pixel, fragment);
}

#endif
