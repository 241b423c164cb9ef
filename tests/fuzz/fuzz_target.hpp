#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/storage_error.hpp"

/// Readers that are given any bytes. A reader keeps its contract if it reads them, or refuses them
/// by an InputError or StorageError of one line; all else is a defect.
namespace plastica::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A reader as it is fuzzed.
struct Target {
  std::string_view name;  ///< of its folder in corpus/ and reproducers/
  void (*run)(Bytes);     ///< throws whatever breaks the contract
};

/// All that the program was linked of: one in a fuzzer, all in the unit test.
std::vector<Target>& targets();

/// Puts a target into the list: `const Registered kCsv{"csv", read_csv};`.
struct Registered {
  Registered(std::string_view name, void (*run)(Bytes)) { targets().push_back({name, run}); }
};

/// The contract is broken.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& what) {
  if (!holds) throw Broken(what);
}

/// @throws Broken unless an error is one line of printable text and not empty
void check_refusal(std::string_view what);

/// Calls a reader. @return whether it read; false if it refused as it should
template <typename Call>
bool read_or_refused(const Call& call) {
  try {
    call();
    return true;
  } catch (const InputError& error) {
    check_refusal(error.what());
  } catch (const io::StorageError& error) {
    check_refusal(error.what());
  }
  return false;
}

/// The same of a reader with a result; empty if it refused.
template <typename Call>
auto result_or_refused(const Call& call) {
  std::optional<std::invoke_result_t<Call>> result;
  read_or_refused([&] { result.emplace(call()); });
  return result;
}

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A path in the process's scratch folder, which has copies of all that is in inputs/: the files
/// that seeds name.
std::string scratch_path(const std::string& name);

/// Writes a file there. @return its path
std::string scratch_file(const std::string& name, std::string_view content);

/// The whole of a file.
std::string content_of(const std::string& path);

}  // namespace plastica::fuzz
