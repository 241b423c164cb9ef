#pragma once

namespace plastica {

/// For a program that runs batches: memory that is freed stays with it, up to 64 MB a thread, to be
/// taken anew. By default glibc hands back what is beyond 128 kB, and each group of a batch's
/// scenarios would find its pages empty again. Does nothing with another C library.
void keep_freed_memory();

}  // namespace plastica
