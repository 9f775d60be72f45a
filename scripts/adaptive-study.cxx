// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What adaptive transparency does with the fragments of pixels, by the shaders' own text: scripts/document-adaptive
// compiles this file as a library, once for each number of nodes and rule of removal, with NODE_COUNT and NODE_REMOVAL,
// and REMOVAL_LOSS and REMOVAL_WIDER for rules that the shaders don't have.
#include <glm/glm.hpp>

#include <cstddef>

namespace
{
using namespace glm;
#define ALPHA_CORRECTION 1
#define TRANSMITTANCE_CHANNELS 1
#include "Adaptive/Weigh.glsl"
#include "Common/AlphaCorrection.glsl"
}

/// Of pixels with so many fragments each, in the order of insertion, what their functions say of each fragment: the
/// visibility that the paper gives it, and the one that the shaders weigh it with, both before a pixel's weights are
/// scaled; the transmittances before and behind the node in front of it, or at it (1 and 1 before the first), that
/// node's number, -1 before the first, and how far it lies from that to the next one or to the farthest fragment, from
/// 0, its own node, to 1. scales are what the pixels' weights are scaled by in the end.
extern "C" void weighPixels(int pixels, int fragments, const float* depths, const float* opacities, float* paper,
  float* weighed, float* before, float* behind, int* nodes, float* distances, float* scales)
{
  for (int pixel = 0; pixel < pixels; ++pixel)
  {
    const std::size_t first = static_cast<std::size_t>(pixel) * static_cast<std::size_t>(fragments);
    Visibility visibility;
    clearVisibility(visibility);
    float transmittance = 1;
    float farthest = 0;
    for (int i = 0; i < fragments; ++i)
    {
      insertFragment(visibility, depths[first + i], opacities[first + i], i);
      transmittance *= 1 - opacities[first + i];
      farthest = max(farthest, depths[first + i]);
    }
    const bool removed = fragments > NODE_COUNT;
    WeightedSums sums;
    clearWeights(sums);
    for (std::size_t i = first; i < first + fragments; ++i)
    {
      const float depth = depths[i];
      paper[i] = transmittanceBefore(visibility, depth);
      weighed[i] = visibilityAt(visibility, depth, opacities[i], removed);
      addWeighted(sums, vec3(1.0f), opacities[i], weighed[i]);
      int node = -1;
      for (int k = 0; k < NODE_COUNT; ++k)
      {
        node = visibility.z[k] <= depth ? k : node;
      }
      const float next =
        node + 1 < NODE_COUNT && visibility.z[node + 1] < NODE_EMPTY ? visibility.z[node + 1] : farthest;
      nodes[i] = node;
      before[i] = node > 0 ? visibility.t[node - 1] : 1;
      behind[i] = node >= 0 ? visibility.t[node] : 1;
      distances[i] =
        node >= 0 && next > visibility.z[node] ? (depth - visibility.z[node]) / (next - visibility.z[node]) : 0;
    }
    scales[pixel] = removed ? correctionOf(sums.weights, transmittance) : 1;
  }
}
