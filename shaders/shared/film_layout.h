// Words per pixel of the film and the AOV buffer, of a sample and a saved path. Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_FILM_LAYOUT_H
#define VERNIER_SHARED_FILM_LAYOUT_H

// Colour sums are 96-bit fixed point with FILM_FRACTION_BITS after the point: integer addition, so the sum has the same
// bits in any order. One sample counts up to 2^32 (52 integer bits less 2^20 samples), in steps of 2^-44.
#define FILM_FRACTION_BITS 44u
#define FILM_SAMPLE_MAX_EXPONENT 32u
#define FILM_PLAIN_SUM 0xffffffffu  // high word of a sum of the fast level; the middle one is 0, the low one a float
#define FILM_RED 0u         // three words each, low word first
#define FILM_GREEN 3u
#define FILM_BLUE 6u
#define FILM_HITS 9u        // samples whose primary ray hit something
#define FILM_SAMPLES 10u    // samples added
#define FILM_NON_FINITE 11u  // samples that were not finite; they are in FILM_SAMPLES, not in the sums
#define FILM_FIRST_NON_FINITE 12u  // number of the first of them, plus 1; 0 for none
#define FILM_RAYS 13u       // cost of the samples; nodes and triangles only where they are counted
#define FILM_NODES 14u
#define FILM_TRIANGLES 15u
#define FILM_WORDS 16u
#define FILM_BLOCKS 4u  // the same in blocks of four words

#define AOV_DEPTH 0u
#define AOV_POSITION 1u
#define AOV_NORMAL 4u
#define AOV_SHADING_NORMAL 7u
#define AOV_UV 10u
#define AOV_ALBEDO 12u
#define AOV_OBJECT_ID 15u
#define AOV_MATERIAL_ID 16u
#define AOV_PRIMITIVE_ID 17u
#define AOV_TRIANGLE 18u  // global triangle number
#define AOV_WORDS 19u

#define COUNTER_UNFINISHED 0u      // invocations that saved a path
#define COUNTER_PRIMARY 1u         // rays begun, by kind
#define COUNTER_SHADOW 2u
#define COUNTER_REFLECTION 3u
#define COUNTER_REFRACTION 4u
#define COUNTER_STACK_OVERFLOWS 5u  // rays dropped because the path stack was full
#define COUNTER_STUCK 6u            // invocations that could not finish even one search of their budget
#define COUNTER_NEXT_JOB 7u         // the first job that nobody has taken yet; kept from dispatch to dispatch
#define COUNTER_COUNT 8u

// With COUNT_EFFECTS the counters go on.
#define COUNTER_EFFECT_RUNS 8u      // searches in which an effect ran, by its bit
#define COUNTER_PATH_RAYS 40u       // reflected and refracted rays begun, by depth
#define COUNTER_SHADOW_RAYS 72u     // shadow rays begun, by the depth of the hit they leave
#define COUNTED_DEPTHS 32u          // the last counts all that are deeper
#define COUNTER_COUNT_WITH_RUNS 104u

// Jobs count the pixels of a tile in blocks of so many squared: neighbours in both directions come one after the other.
#define JOB_BLOCK_SIDE 8u

// A traced sample, in blocks of four words: radiance 3, rays | SAMPLE_HIT; with costs counted: nodes, triangles.
#define SAMPLE_HIT 0x80000000u  // the primary ray hit something
#define SAMPLE_BLOCKS(count_cost) ((count_cost) ? 2u : 1u)

// A path between two dispatches, in blocks of four words (path.glsl): its own state, the current ray, the rays that wait.
#define PATH_RAY_BLOCKS 4u
#define PATH_HEAD_BLOCKS 8u
#define PATH_BLOCKS(stack_size) (PATH_HEAD_BLOCKS + PATH_RAY_BLOCKS * (1u + (stack_size)))

#endif
