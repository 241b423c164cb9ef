#include <cstddef>
#include <string>
#include <vector>

#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/result_bases.hpp"
#include "tests/fuzz/result_edit.hpp"
#include "tests/fuzz/result_reading.hpp"

namespace plastica::fuzz {
namespace {

/// A result file that HDF5 finds whole, in which some things are not as they should be. The first
/// byte chooses the file; then follow edits: the object in two bytes, the kind in one, the number
/// of bytes of its payload in one, these.
void read_edited(Bytes bytes) {
  ByteSource source(bytes);
  const auto [base, again] = result_choice(source.byte());
  const std::string path = scratch_file("edited.h5", base);
  {
    ResultEdit edit(path);
    while (!source.is_empty()) {
      const std::size_t object = source.number(2);
      const std::size_t kind = source.byte();
      edit.apply(object, kind, source.piece(source.byte()));
    }
  }
  read_result(sealed_scratch_file(content_of(path)), again);
}

const Registered kResultValues{"result_values", read_edited};

}  // namespace
}  // namespace plastica::fuzz
