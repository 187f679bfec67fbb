// Closest and any hit of a ray with the scene: one merged loop over the records of the BVH.
#ifndef VERNIER_TRAVERSE_BVH_GLSL
#define VERNIER_TRAVERSE_BVH_GLSL

#include "instance.glsl"
#include "intersect_box.glsl"
#include "intersect_triangle.glsl"
#include "loop_limit.glsl"
#include "search.glsl"

// The rest of a node's hit children: child base << 8 | count << 6 | up to three 2-bit slots, the next one lowest.
uint group_count(IN(uint) group) { return (group >> 6) & 3u; }

uint group_next(IN(uint) group) { return (group >> 8) + (group & 3u); }

uint without_next(IN(uint) group) {
  return (group & 0xffffff00u) | ((group_count(group) - 1u) << 6) | ((group >> 2) & 15u);
}

// All but the first of the sorted children of a node as a group.
uint group_of_rest(IN(ivec4) entries, IN(uint) child_base) {
  uint count = (entries.y != SLAB_MISS ? 1u : 0u) + (entries.z != SLAB_MISS ? 1u : 0u) + (entries.w != SLAB_MISS ? 1u : 0u);
  return child_base << 8 | count << 6 | uint(entries.y & 3) | uint(entries.z & 3) << 2 | uint(entries.w & 3) << 4;
}

// Where a traversal stands: the record to look at, its siblings still to come, the groups above.
struct Cursor {
  uint record;
  uint group;
  uint stack_count;
  bool running;
};

// Moves on from a record: down to the nearest child where `descend` and there is one, else to the next of the group, else up.
void advance(INOUT(Cursor) cursor, IN(bool) descend, IN(ivec4) entries, IN(uint) child_base) {
  bool down = descend && entries.x != SLAB_MISS;
  bool has_rest = group_count(cursor.group) > 0u;
  // What comes where nothing is below, asked for before that is known: rounds wait for the record that comes next.
  uint other = cursor.group;
  if (!has_rest) other = top_group(cursor.stack_count);
  cursor.running = cursor.running && (down || other != 0u);
  if (down && has_rest && !(mutated(MUTATION_SHORT_STACK) && cursor.stack_count >= 2u)) push_group(cursor.stack_count, cursor.group);
  if (!down && !has_rest) pop_group(cursor.stack_count);
  uint rest = group_of_rest(entries, child_base);
  cursor.record = down ? child_base + uint(entries.x & 3) : group_next(other);
  cursor.group = down ? rest : without_next(other);
}

// A ray as a tree sees it.
struct TreeRay {
  SlabRay slab;
  ShearedRay sheared;
};

TreeRay tree_ray(IN(Ray) ray) { return TreeRay(slab_ray(ray), sheared_ray(ray)); }

// Which tree a search is in: the scene's, or below an instance that of its mesh.
struct Tree {
  uint instance;        // INSTANCE_WORLD: the scene's
  uint first_triangle;  // number of its first triangle
  uint stack_floor;     // entries of the stack that belong to the scene's
  uint entered;         // an instance that was met and is to be gone into, or NONE
};

// 3 record. On llvmpipe by a shift that only the host knows: its compiler makes a product of what it knows, and the loads wait 8
// cycles longer for it.
#ifdef LOADS_TEXELS
uint first_texel(IN(uint) record) { return (record << steering_constants().one) + record; }
#else
uint first_texel(IN(uint) record) { return 3u * record; }
#endif

// Follows `ray`, which is `above` in the scene's tree, to the end of the search, to an instance or to where the stack has to
// be moved.
void search_trees(IN(Search) search, IN(TreeRay) above, INOUT(TreeRay) ray, INOUT(Tree) tree, INOUT(Cursor) cursor, INOUT(Found) found) {
  // The end is tested for what is known before the triangle test, since the next round would wait for that: a search that stops
  // at a triangle has another round, in which it tests none.
  bool goes_on = true;
  for (;;) {
    if (!TEST_LAST && !goes_on) break;
    uint record = cursor.record;
    bool searching = cursor.running;
    uint first = first_texel(record);
    uvec4 a = load_record(first);
    uvec4 b = load_record(first + 1u);
    uvec4 c = load_record(first + 2u);
    bool is_triangle = (a.w & BVH_TRIANGLE) != 0u;
    ivec4 entries = intersect_children(ray.slab, a, b, c, search.t_min, found.hit.t);
    // The next record is chosen before the triangle is tested: a CPU that looks ahead then asks for it meanwhile.
    advance(cursor, !is_triangle, entries, c.z & BVH_CHILD_BASE_MASK);
    // Both kinds are worked out for every record: lanes in lockstep pay for both anyway, and selects are cheaper than a
    // branch.
    uint triangle = INSTANCED ? tree.first_triangle + c.w : c.w;
    bool accepted = intersect_if(is_triangle && searching, ray.sheared, uintBitsToFloat(uvec3(a.x, a.y, a.z)),
                                 uintBitsToFloat(uvec3(b.x, b.y, b.z)), uintBitsToFloat(uvec3(c.x, c.y, c.z)), triangle,
                                 record | (a.w & BVH_TRIANGLE_NOT_OPAQUE), search.t_min, search.after_triangle, found.hit);
    bool opaque = (a.w & BVH_TRIANGLE_NOT_OPAQUE) == 0u;
    if (COUNT_COST) {
      found.nodes += searching && !is_triangle ? 1u : 0u;
      found.triangles += searching && is_triangle ? 1u : 0u;
    }
    // Records are fewer than the limit, which compilers cannot know.
    goes_on = cursor.running && record < LOOP_ROUND_LIMIT && !top_is_full();
    cursor.running = cursor.running && !(search.stop_at_opaque && accepted && opaque);
    if (INSTANCED) {
      found.hit.instance = accepted ? tree.instance : found.hit.instance;
      // Mapping a ray takes half as long as a record, and llvmpipe would do it for every one: lanes wait here until no other
      // has anything else to do. The way back is only selects.
      bool enters = (a.w & BVH_INSTANCE) != 0u && entries.x != SLAB_MISS && searching;
      tree.entered = enters ? b.w >> BVH_INSTANCE_SHIFT : NONE;
      goes_on = goes_on && !enters;
      if (cursor.stack_count < tree.stack_floor) {
        ray = above;
        tree = Tree(INSTANCE_WORLD, 0u, 0u, tree.entered);
      }
    }
    if (TEST_LAST && !goes_on) break;
  }
}

// Goes into the instance that was met; false where none was.
bool enter_instance(IN(Ray) ray, INOUT(TreeRay) mapped, INOUT(Tree) tree, IN(Cursor) cursor) {
  bool enters = tree.entered != NONE;
  if (enters) {
    mapped = tree_ray(ray_in_instance(ray, tree.entered));
    tree = Tree(tree.entered, fetch_instance_words(tree.entered).x, cursor.stack_count, NONE);
  }
  return enters;
}

// Whether nothing passes the triangle that was hit, by what its record says until the search is over.
bool is_opaque_hit(IN(Hit) hit) { return hit.triangle != NONE && (hit.record & BVH_TRIANGLE_NOT_OPAQUE) == 0u; }

// Moves an entry of the stack down where the top is full, up where nothing else is left; false where neither is.
bool move_stack(INOUT(Cursor) cursor, IN(bool) stopped) {
  bool moved = cursor.running && top_is_full();
  if (moved) lower_group();
  if (!cursor.running && !stopped) {
    uint group = take_lower_group();
    if (group != 0u) {
      cursor.record = group_next(group);
      cursor.group = without_next(group);
      cursor.running = true;
      moved = true;
    }
  }
  return moved;
}

// The answer to `search`; no hit for a ray that is not valid.
Found traverse_bvh(IN(Search) search) {
  TreeRay above = tree_ray(search.ray);
  TreeRay ray = above;
  Tree tree = Tree(INSTANCE_WORLD, 0u, 0u, NONE);
  Found found = Found(no_hit(search.t_max), false, true, 0u, 0u);
  Cursor cursor = Cursor(0u, 0u, 0u, false);
  clear_stack();
  if (scene_has_triangles() && is_valid_ray(search.ray)) {
    cursor.running = true;
    if (INSTANCED || has_lower_groups()) {
      uint stops = 0u;
      bool done = false;
      for (;;) {
        if (!TEST_LAST && done) break;
        search_trees(search, above, ray, tree, cursor, found);
        bool moved = has_lower_groups() && move_stack(cursor, search.stop_at_opaque && is_opaque_hit(found.hit));
        bool entered = INSTANCED && enter_instance(search.ray, ray, tree, cursor);
        stops++;
        done = !(moved || entered) || stops >= LOOP_ROUND_LIMIT;
        if (TEST_LAST && done) break;
      }
    } else {
      search_trees(search, above, ray, tree, cursor, found);
    }
  }
  found.finished = !cursor.running;
  found.is_opaque = is_opaque_hit(found.hit);
  if (found.hit.triangle != NONE) found.hit.record &= ~BVH_TRIANGLE_NOT_OPAQUE;
  return found;
}

#endif
