#include "plastica/base/keep_freed_memory.hpp"

#include <cstdlib>  // which says whether the C library is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace plastica {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that it takes
#endif
}

}  // namespace plastica
