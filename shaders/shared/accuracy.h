// Numeric levels, the spots at which a level picks the method, and the faults that `vernier verify --mutate` seeds.
// Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_ACCURACY_H
#define VERNIER_SHARED_ACCURACY_H

#define LEVEL_FAST 0u    // what most renderers do
#define LEVEL_ROBUST 1u  // bounded errors in float32
#define LEVEL_EXACT 2u   // edge decisions as if in exact arithmetic, results from twice the precision

#define SPOT_BOX 0u       // ray against the boxes of the BVH
#define SPOT_TRIANGLE 1u  // ray against triangle: the decision, t and the weights
#define SPOT_POSITION 2u  // place of a hit
#define SPOT_SPAWN 3u     // origin of a secondary ray
#define SPOT_FRESNEL 4u   // Fresnel terms and the refracted direction
#define SPOT_SPECULAR 5u  // highlight
#define SPOT_SUM 6u       // accumulation of samples
#define SPOT_COUNT 7u

// Levels of all spots in one word, two bits each; the same level everywhere.
#define LEVELS_OF(level) ((level) * 0x1555u)

// Faults for mutation tests; a renderer always has none. Others (a textbook formula, no padding) are a spot set to
// LEVEL_FAST where more is expected.
#define MUTATION_NONE 0u
#define MUTATION_CONTRACTED_EDGE 1u    // one product of each edge value is not rounded, as by an fma
#define MUTATION_ZERO_DIRECTION 2u     // components of 0 replaced by 1e-18 without their sign
#define MUTATION_NO_LOWER_BOUND 3u     // hits with t > 0 are taken, whatever the error of t
#define MUTATION_SIGN_IN_FRAME 4u      // sign(), which is 0 at 0, chooses the side of a shading normal
#define MUTATION_UNCLAMPED_FRACT 5u    // x - floor(x), which is 1 for -1e-10, addresses a texture
#define MUTATION_SHORT_STACK 6u        // a traversal stack of 2 entries
#define MUTATION_NARROW_SUM 7u         // the carry into the film's high word is lost
#define MUTATION_METRE_OFFSET 8u       // secondary rays start 1e-4 m off, however large the scene
#define MUTATION_TOTAL_LOST 9u         // total reflection is taken for a ray that ends
#define MUTATION_MEDIUM_KEPT 10u       // a ray that leaves a body takes its medium along
#define MUTATION_SHORT_FLOATS 11u      // weights of rays and texture coordinates keep the digits of a half float
#define MUTATION_TILE_PATTERN 12u      // samples lie by the place in the tile, not in the image
#define MUTATION_TIES_SKIPPED 13u      // a ray that goes on behind a hit leaves out what lies at the same t
#define MUTATION_WORLD_ORIGIN 14u      // secondary rays start where world coordinates are rounded to float
#define MUTATION_POINT_NORMAL 15u      // normals of shared meshes are mapped as points are, not by the inverse transpose
#define MUTATION_FACET_TERMINATOR 16u  // no light reaches a triangle that faces away, whatever its vertex normals
#define MUTATION_COUNT 17u

#endif
