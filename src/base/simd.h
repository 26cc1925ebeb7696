#pragma once

/// PLACE_RECOGNITION_CLONES before a function compiles it for several instruction sets; the loader
/// picks the best one of the machine it runs on. Other compilers and architectures compile it once,
/// for their baseline (SSE2, NEON). Sanitizers cannot run the loader's choice, so not there either.
///
/// Floating-point results are the same in every clone as long as the code fixes the order of sums
/// (products and sums are never fused: -ffp-contract=off).
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PLACE_RECOGNITION_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PLACE_RECOGNITION_CLONES
#endif
