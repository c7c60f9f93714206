// What bench/rays.comp reads beside the tree, and what it writes; read by GLSL and C++.
#define BINDING_READY_RAYS 100       // bench/ready_rays.h
#define BINDING_FOUND 101            // of the nearest hit the distance, or 1 where nothing is in the way; else -1
#define BINDING_FOUND_TRIANGLES 102  // of nearest hits, in the tree's order; -1: none
#define SPEC_NEAREST 100             // bool: the nearest hit, else whether anything is in the way of a ray and of the next
