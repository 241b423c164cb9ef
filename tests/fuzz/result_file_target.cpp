#include <string>

#include "plastica/io/content_digest.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/result_bases.hpp"
#include "tests/fuzz/result_reading.hpp"

namespace plastica::fuzz {
namespace {

/// A result file some of whose bytes are others, behind a digest that is right, so that HDF5 sees
/// them. The first byte chooses the file; then follow patches.
void read_patched(Bytes bytes) {
  ByteSource source(bytes);
  const auto [base, again] = result_choice(source.byte());
  read_result(sealed_scratch_file(patched(base, io::kContentOffset, source)), again);
}

const Registered kResultFile{"result_file", read_patched};

}  // namespace
}  // namespace plastica::fuzz
