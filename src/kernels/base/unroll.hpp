#pragma once
// Loops over the directions of a velocity set must be unrolled before the loop over nodes around them can vectorise,
// and for the tables of directions to fold to constants: else each round writes its table to the stack.

#if defined(__CUDACC__) || defined(__HIPCC__)
#define VUG_UNROLL _Pragma("unroll")
#elif defined(__clang__)
#define VUG_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define VUG_UNROLL _Pragma("GCC unroll 9")
#else
#define VUG_UNROLL
#endif
