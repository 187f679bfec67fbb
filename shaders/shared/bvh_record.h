// The record of the traversal array: 12 words (three RGBA32UI texels), a node, an instance or a triangle. Read by C++
// and GLSL alike.
//
// words   node (bit 31 of word 3 clear)                      triangle (bit 31 of word 3 set)
// 0-2     origin of the quantisation grid, float             v0, float
// 3       exponent bytes ex | ey << 8 | ez << 16:            flags; the bits below: number of vertex 0
//         cell size 2^(e-127), that is float bits e << 23
// 4-7     lo.x, hi.x, lo.y, hi.y, a byte per child           v1, float; word 7: from vertex 0 to vertex 1, and above 16
// bits
//                                                            to vertex 2, signed; where vertices have no texels the
//                                                            material
// 8-11    lo.z, hi.z, child base, child count                v2, float; word 11: global triangle id, below an instance
// the
//                                                            number within the mesh
//
// An empty child slot has lo = 255 and hi = 0. Siblings lie next to each other: child i is record `child base + i`.
// An instance is a node whose one child is the root of the tree of its mesh, in the mesh's own space; bits 8 to 31 of
// word 4, bytes of slots that it has not, are the number of the instance (instance_layout.h).
#ifndef VERNIER_SHARED_BVH_RECORD_H
#define VERNIER_SHARED_BVH_RECORD_H

#define BVH_RECORD_WORDS 12
#define BVH_RECORD_TEXELS 3
#define BVH_TRIANGLE 0x80000000u
// Of a node: it is an instance. Bit 29: nodes have bits 24 to 30 free, triangles have this one clear.
#define BVH_INSTANCE 0x20000000u
#define BVH_INSTANCE_SHIFT 8u
// The triangle may let light or rays pass (alpha mask, blend, transmission): any-hit rays may not stop at it.
#define BVH_TRIANGLE_NOT_OPAQUE 0x40000000u
// Of a triangle: the number of vertex 0.
#define BVH_VERTEX_MASK 0x1fffffffu
// A stack entry holds child base << 8 | count << 6 | three 2-bit slots.
#define BVH_MAX_RECORDS (1u << 24)

#endif
