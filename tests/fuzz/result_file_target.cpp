#include <algorithm>
#include <cstddef>
#include <string>

#include "plastica/io/content_digest.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/result_bases.hpp"
#include "tests/fuzz/result_reading.hpp"

namespace plastica::fuzz {
namespace {

/// A result file some of whose bytes are others, behind a digest that is right, so that HDF5 sees
/// them. The first byte chooses the file; then follow patches: the place in three bytes, the number
/// of bytes in one, these.
void read_patched(Bytes bytes) {
  ByteSource source(bytes);
  std::string file = result_bases()[source.byte() % result_bases().size()];
  while (!source.is_empty()) {
    const std::size_t room = file.size() - io::kContentOffset;
    const std::size_t place = io::kContentOffset + source.number(3) % room;
    const Bytes patch = source.piece(source.byte() % 32);
    const std::size_t size = std::min(patch.size(), file.size() - place);
    std::copy_n(patch.begin(), size, file.begin() + static_cast<std::ptrdiff_t>(place));
  }
  read_result(sealed_scratch_file(file));
}

const Registered kResultFile{"result_file", read_patched};

}  // namespace
}  // namespace plastica::fuzz
