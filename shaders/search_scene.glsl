// How rays find what they hit: in our tree or, with RAY_QUERIES, in the driver's.
#ifndef VERNIER_SEARCH_SCENE_GLSL
#define VERNIER_SEARCH_SCENE_GLSL

#ifdef RAY_QUERIES
#include "query_boxes.glsl"
Found search_scene(IN(Search) search) { return query_boxes(search); }
#else
#include "traverse_bvh.glsl"
Found search_scene(IN(Search) search) { return traverse_bvh(search); }
#endif

#endif
