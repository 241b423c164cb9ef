#pragma once

/// For operators that a compiler would call from a large function instead. Where the build is
/// sanitized or not optimized they stay calls: a file that repeats all their checks at each use
/// takes a minute to compile.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PLASTICA_ALWAYS_INLINE __attribute__((always_inline))
#else
#define PLASTICA_ALWAYS_INLINE
#endif
