// The record of the traversal array: 12 words (three RGBA32UI texels), a node, an instance or a triangle. Read by C++
// and GLSL alike.
//
// words   node (bit 31 of word 3 clear)                      triangle (bit 31 of word 3 set)
// 0-2     origin of the quantisation grid, float             v0, float
// 3       exponent bytes ex | ey << 8 | ez << 16:            flags; the bits below: number of vertex 0, seven bits to a
//         cell size 2^(e-127), that is float bits e << 23    byte, whose highest is 1 (BVH_VERTEX_BITS)
// 4-7     lo.x, hi.x, lo.y, hi.y, a byte per child           v1, float; word 7: from vertex 0 to vertex 1, and above
//                                                            16 bits to vertex 2, signed; where vertices have no
//                                                            texels the material
// 8-11    lo.z, hi.z, child base, child count                v2, float; word 11: global triangle id, below an instance
//                                                            the number within the mesh
//
// An empty child slot has lo = 255 and hi = 1. Siblings lie next to each other: child i is record `child base + i`.
// An instance is a node whose one child is the root of the tree of its mesh, in the mesh's own space; bits 8 to 31 of
// word 7, bytes of slots that it has not, are the number of the instance (instance_layout.h).
//
// Both tests are worked out for every record, so each kind is read as the other too. Denormals are kept out of what is
// read so, since a product of one takes some 120 cycles on Intel's processors: a node's bytes are 1 or more, its
// child base has the bits of a float above 2, and a triangle's exponent bytes are 128 or more. (Where the fourth
// child's byte is 128 the word may still be one.)
#ifndef VERNIER_SHARED_BVH_RECORD_H
#define VERNIER_SHARED_BVH_RECORD_H

#define BVH_RECORD_TEXELS 3
// Words by number: flags with exponents or a vertex, where its other vertices lie, child base, and id or child count.
#define BVH_WORD_FLAGS 3
#define BVH_WORD_PLACE 7
#define BVH_WORD_CHILD_BASE 10
#define BVH_WORD_NUMBER 11
#define BVH_TRIANGLE 0x80000000u
// Of a node: it is an instance. Bit 29: nodes have bits 24 to 30 free, triangles have this one clear.
#define BVH_INSTANCE 0x20000000u
#define BVH_INSTANCE_SHIFT 8u
// The triangle may let light or rays pass (alpha mask, blend, transmission): any-hit rays may not stop at it.
#define BVH_TRIANGLE_NOT_OPAQUE 0x40000000u
// Of a node: set beside its child base.
#define BVH_CHILD_BASE_TAG 0x40000000u
#define BVH_CHILD_BASE_MASK 0x00ffffffu
// Of a triangle: the number of vertex 0, below 2^26, and back.
#define BVH_VERTEX_BITS(number) \
  (0x808080u | ((number)&0x7fu) | ((number)&0x3f80u) << 1 | ((number)&0x1fc000u) << 2 | ((number)&0x3e00000u) << 3)
#define BVH_VERTEX_NUMBER(word) \
  (((word)&0x7fu) | ((word) >> 1 & 0x3f80u) | ((word) >> 2 & 0x1fc000u) | ((word) >> 3 & 0x3e00000u))
#define BVH_VERTEX_LIMIT (1u << 26)
// A stack entry holds child base << 8 | count << 6 | three 2-bit slots.
#define BVH_MAX_RECORDS (1u << 24)

#endif
