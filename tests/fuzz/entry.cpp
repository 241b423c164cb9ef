#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_target.hpp"

/// What libFuzzer calls, of the one target that the program is linked of. An exception that leaves
/// it ends the program, which libFuzzer reports with the bytes.
extern "C" int LLVMFuzzerTestOneInput(  // NOLINT(readability-identifier-naming): its name
    const std::uint8_t* data, std::size_t size) {
  plastica::fuzz::targets().front().run({data, size});
  return 0;
}
