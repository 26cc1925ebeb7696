#pragma once

/// The widest vectors that are used on x86-64: 512, 256 or 128 bits, for AVX-512, AVX2 and plain
/// x86-64. Compile with a smaller value to measure on one processor what an older one can do.
#if !defined(PLACE_RECOGNITION_VECTOR_BITS)
#define PLACE_RECOGNITION_VECTOR_BITS 512
#endif

/// PLACE_RECOGNITION_TARGET_CLONES before a function compiles it once per useful instruction set
/// and selects the best at run time, so that one binary runs everywhere. Put it on functions of
/// plain loops that the compiler vectorizes; the functions they call must be inlined into them.
/// Every clone gives the same bits: products and sums are never fused (-ffp-contract=off), and sums
/// are never reordered. Sanitizers start too late for the selection at run time, so they are
/// compiled without clones.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) &&                           \
    PLACE_RECOGNITION_VECTOR_BITS >= 256
#if PLACE_RECOGNITION_VECTOR_BITS >= 512
#define PLACE_RECOGNITION_TARGET_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PLACE_RECOGNITION_TARGET_CLONES __attribute__((target_clones("avx2", "default")))
#endif
#else
#define PLACE_RECOGNITION_TARGET_CLONES
#endif

/// For the small functions that those functions call.
#define PLACE_RECOGNITION_INLINE inline __attribute__((always_inline))

/// Before a loop over the parts of a sum: the loop is not unrolled, so that the vectorizer
/// recognizes it.
#if defined(__clang__)
#define PLACE_RECOGNITION_LANES
#else
#define PLACE_RECOGNITION_LANES _Pragma("GCC unroll 1")
#endif

/// Before a loop: no iteration reads what another writes.
#if defined(__clang__)
#define PLACE_RECOGNITION_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define PLACE_RECOGNITION_INDEPENDENT _Pragma("GCC ivdep")
#endif
