// Ids of the specialization constants, read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_SPECIALIZATION_IDS_H
#define VERNIER_SHARED_SPECIALIZATION_IDS_H

#define SPECIALIZATION_EFFECTS 0          // OR of EFFECT_*
#define SPECIALIZATION_TRAVERSAL_STACK 1  // entries of the traversal stack: at least the depth of the BVH
#define SPECIALIZATION_SHIFT_STACK 2      // traversal stack in shifted registers (llvmpipe) instead of an indexed array
#define SPECIALIZATION_PATH_STACK 3       // rays of the ray tree that can wait
#define SPECIALIZATION_COUNT_COST 4       // count node visits and triangle tests per pixel
#define SPECIALIZATION_LEVELS 5           // numeric level of each spot, shared/accuracy.h
#define SPECIALIZATION_MUTATION 6         // MUTATION_*: a seeded fault
#define SPECIALIZATION_FUNCTION 7         // verify_*.comp: which function is called
#define SPECIALIZATION_COUNT_EFFECTS 8    // count how often each effect runs, and rays by depth
#define SPECIALIZATION_LISTED_PIXELS 9    // the dispatch has a list of its pixels instead of the whole tile
#define SPECIALIZATION_INSTANCED 10       // the BVH has instances (bvh_record.h)
#define SPECIALIZATION_WORKFLOWS 11       // OR of 1 << WORKFLOW_*: those that materials of the scene have
#define SPECIALIZATION_COARSE 12          // rays pad the boxes of the BVH by one bound each (src/bvh/coarse.h)
#define SPECIALIZATION_TEST_LAST 13       // loops test for their end behind their body (loop_limit.glsl)

// Entries that the shifted stack has at most (traversal_stack.glsl).
#define SHIFT_STACK_MAX_SIZE 31u

#endif
