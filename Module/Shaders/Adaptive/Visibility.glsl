// Visibility.glsl: the visibility function of adaptive transparency (Salvi 2011, sections 3.1 and 3.3).
//
// vis(z), the transmittance between the viewer and depth z, is a step function of NODE_COUNT nodes in front-to-back order:
// behind depth z[k] it is t[k]. Before z[0] it is 1: that node is implicit. There is one node more than NODE_COUNT, for the
// fragment that has just come in. A node that is not in use lies at NODE_EMPTY and holds the total transmittance.
//
// Needs: NODE_COUNT, NODE_REMOVAL.  Gives: Visibility, clearVisibility, insertFragment, transmittanceBefore,
// passNode.
#ifndef Visibility_glsl
#define Visibility_glsl
#include "Adaptive/RemoveNode.glsl"

void clearBlock(INOUT(Visibility) v, int block)
{
  for (int i = 1; i <= NODE_BLOCK; ++i)
  {
    int k = block + i;
    if (k <= NODE_COUNT)
    {
      v.z[k] = NODE_EMPTY;
      v.t[k] = 1.0f;
    }
  }
}

void clearVisibility(OUT(Visibility) v)
{
  v.z[0] = NODE_EMPTY;
  v.t[0] = 1.0f;
#define CLEAR(block) clearBlock(v, block);
  EACH_BLOCK(CLEAR)
  v.tied = false;
}

void insertIntoBlock(INOUT(Visibility) v, float depth, float passes, int block)
{
  for (int i = NODE_BLOCK; i > 0; --i)
  {
    int k = block + i;
    if (k <= NODE_COUNT)
    {
      v.tied = v.tied || v.z[k] == depth;
      v.t[k] = v.z[k] <= depth ? v.t[k] : passes * v.t[k - 1];
      v.z[k] = min(v.z[k], max(v.z[k - 1], depth));
    }
  }
}

// Multiplies vis(z) with the step of a fragment (Eq. 5). Of equal depths, the fragment that comes later is put behind.
// count fragments were inserted before this one.
void insertFragment(INOUT(Visibility) v, float depth, float alpha, int count)
{
  float passes = 1.0f - alpha;
#define INSERT(block) insertIntoBlock(v, depth, passes, block);
  EACH_BLOCK_BACKWARDS(INSERT)
  v.tied = v.tied || v.z[0] == depth;
  v.t[0] = v.z[0] <= depth ? v.t[0] : passes;
  v.z[0] = min(v.z[0], depth);
  if (count >= NODE_COUNT)
  {
    removeNode(v);
  }
}

void passNodeOfBlock(INOUT(Visibility) v, float depth, float nearer, INOUT(bool) passed, int block)
{
  for (int i = 0; i < NODE_BLOCK; ++i)
  {
    int k = block + i;
    if (k < NODE_COUNT)
    {
      bool first = !passed && v.z[k] == depth;
      v.z[k] = first ? nearer : v.z[k];
      passed = passed || first;
    }
  }
}

// Moves the first node at this depth just in front of it: a fragment there has asked for its transmittance, and those of
// equal depth that come after it lie behind it. Fragments have to ask in the order in which they were inserted. With no more
// fragments than nodes that is exact; where nodes of that depth were removed, as many fragments hide each other as there are
// nodes left.
void passNode(INOUT(Visibility) v, float depth)
{
  float nearer = depth > 0.0f ? uintBitsToFloat(floatBitsToUint(depth) - 1u) : -1.0f;
  bool passed = false;
#define PASS_NODE(block) passNodeOfBlock(v, depth, nearer, passed, block);
  EACH_BLOCK(PASS_NODE)
}

void findBefore(INOUT(Visibility) v, float depth, INOUT(float) before, int block)
{
  for (int i = 0; i < NODE_BLOCK; ++i)
  {
    int k = block + i;
    if (k < NODE_COUNT)
    {
      before = v.z[k] < depth ? v.t[k] : before;
    }
  }
}

// vis at a depth (Eq. 6). Where fragments of equal depth have come in (v.tied), passNode follows.
float transmittanceBefore(INOUT(Visibility) v, float depth)
{
  float before = 1.0f;
#define FIND_BEFORE(block) findBefore(v, depth, before, block);
  EACH_BLOCK(FIND_BEFORE)
  return before;
}

#endif
