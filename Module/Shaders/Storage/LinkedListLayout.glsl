// LinkedListLayout.glsl: the numbers of a linked list's layout, shared by the shaders and vtkLinkedListStorage.
#ifndef LinkedListLayout_glsl
#define LinkedListLayout_glsl

#define LIST_SMALLEST_CELL_SHIFT 4 // cells of 16 x 16 pixels, or larger where there would be more than
#define LIST_MOST_CELLS 8192
#define LIST_COUNTER_STRIDE 16u // words between counters: each has a cache line of its own
#define LIST_HEAD_BITS 29       // of a node's number, in a head
#define LIST_HEAD_MASK 0x1fffffffu
#define LIST_DISTANCE_BITS 24u  // from node to node, in a link; nodes of a pixel lie in the range of its cell
#define LIST_DISTANCE_MASK 0xffffffu
#define LIST_MOST_NODES_OF_CELL 7456540 // with the eighth more that is given to a cell, they are not farther apart

#endif
