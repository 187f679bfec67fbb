// What a ray is asked, and the answer.
#ifndef VERNIER_SEARCH_GLSL
#define VERNIER_SEARCH_GLSL

#include "ray.glsl"

struct Search {
  Ray ray;
  float t_min;          // hits come after (t_min, after_triangle)
  uint after_triangle;
  float t_max;          // and have t < t_max, at most LARGEST_FLOAT
  bool stop_at_opaque;  // any hit ends the search whose triangle lets nothing pass (it need not be the closest)
};

// What a search found, and what it took.
struct Found {
  Hit hit;         // the closest, or no_hit(t_max); while searching its record says too whether it lets something pass
  bool is_opaque;  // its triangle lets nothing pass
  bool finished;   // false: cut off by a loop limit, the answer may not be used
  uint nodes;      // visited, with COUNT_COST
  uint triangles;  // tested, with COUNT_COST
};

#endif
