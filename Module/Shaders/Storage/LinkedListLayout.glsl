// LinkedListLayout.glsl: the numbers of a linked list's layout, shared by the shaders and vtkLinkedListStorage.
#ifndef LinkedListLayout_glsl
#define LinkedListLayout_glsl

#define LIST_SMALLEST_CELL_SHIFT 4 // cells of 16 x 16 pixels, or larger where there would be more than
#define LIST_MOST_CELLS 8192
#define LIST_COUNTER_STRIDE 16u // words between counters: each has a cache line of its own

#endif
