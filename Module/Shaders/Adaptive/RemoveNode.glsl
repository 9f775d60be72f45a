// RemoveNode.glsl: makes room in a full visibility function (Salvi 2011, section 3.2).
//
// Dropping node j loses the area of a rectangle under the step function (Eq. 7): its height is the step t[j-1] - t[j], its
// width the distance over which the step moves.
// - NODE_REMOVAL_UNDERESTIMATE moves the step to the nearer neighbour, z[j] - z[j-1] away, whose transmittance becomes t[j].
//   The last node may go, and the total transmittance stays exact. The first may not: before it lies the implicit node,
//   whose transmittance is 1.
// - NODE_REMOVAL_OVERESTIMATE moves it to the farther neighbour, z[j+1] - z[j] away. The first node may go. The last may not:
//   behind it lies infinity.
// - NODE_REMOVAL_MIXED takes the cheaper of the two, node by node.
//
// Needs: NODE_COUNT, NODE_REMOVAL.  Gives: Visibility, removeNode.
#ifndef RemoveNode_glsl
#define RemoveNode_glsl
#include "Common/Language.glsl"
#ifndef NODE_COUNT
#error "RemoveNode.glsl needs NODE_COUNT"
#endif
#ifndef NODE_REMOVAL
#error "RemoveNode.glsl needs NODE_REMOVAL"
#endif

#define NODE_REMOVAL_UNDERESTIMATE 0
#define NODE_REMOVAL_OVERESTIMATE 1
#define NODE_REMOVAL_MIXED 2
#define NODE_EMPTY 2.0f // behind every window depth
#define NODE_BLOCK 16

struct Visibility
{
  float z[NODE_COUNT + 1];
  float t[NODE_COUNT + 1];
  bool tied; // fragments of equal depth have come in
};

// Node j's depth goes, and one transmittance: that of node j - 1 (underestimate) or of node j (overestimate). Those behind
// move up.
void dropNode(INOUT(Visibility) v, int droppedDepth, int droppedTransmittance)
{
  for (int block = 0; block < NODE_COUNT; block += NODE_BLOCK)
  {
    for (int i = 0; i < NODE_BLOCK; ++i)
    {
      int k = block + i;
      if (k < NODE_COUNT)
      {
        v.z[k] = k < droppedDepth ? v.z[k] : v.z[k + 1];
        v.t[k] = k < droppedTransmittance ? v.t[k] : v.t[k + 1];
      }
    }
  }
  v.z[NODE_COUNT] = NODE_EMPTY;
}

void removeNode(INOUT(Visibility) v)
{
  float least = 1e30f;
  int depth = 0;
  int transmittance = 0;
#if NODE_REMOVAL != NODE_REMOVAL_UNDERESTIMATE
  least = (1.0f - v.t[0]) * (v.z[1] - v.z[0]);
#endif
  for (int block = 1; block <= NODE_COUNT; block += NODE_BLOCK)
  {
    for (int i = 0; i < NODE_BLOCK; ++i)
    {
      int k = block + i;
      if (k <= NODE_COUNT)
      {
        float step = v.t[k - 1] - v.t[k];
#if NODE_REMOVAL != NODE_REMOVAL_OVERESTIMATE
        float under = step * (v.z[k] - v.z[k - 1]);
        depth = under < least ? k : depth;
        transmittance = under < least ? k - 1 : transmittance;
        least = min(under, least);
#endif
#if NODE_REMOVAL != NODE_REMOVAL_UNDERESTIMATE
        if (k < NODE_COUNT)
        {
          float over = step * (v.z[k + 1] - v.z[k]);
          depth = over < least ? k : depth;
          transmittance = over < least ? k : transmittance;
          least = min(over, least);
        }
#endif
      }
    }
  }
  dropNode(v, depth, transmittance);
}

#endif
