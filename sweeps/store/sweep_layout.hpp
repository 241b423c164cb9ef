#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "plastica/base/renamed.hpp"
#include "plastica/io/hdf5.hpp"
#include "sweeps/store/sweep_record.hpp"

/// Parts of a sweep's file; not installed. Documented in docs/hdf5.md.
namespace plastica::sweeps {

/// How hard numbers are deflated: more costs much time and saves little.
inline constexpr int kDeflate = 1;

template <class Enum, std::size_t n>
std::string_view word_at(const std::array<std::string_view, n>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

/// An old word is read as the new one. @throws InputError if the word is none of them
template <class Enum, std::size_t n>
Enum enumerator_at(const std::array<std::string_view, n>& words, const std::string& word,
                   const std::string& file) {
  const std::string_view now = new_name(kRenamedWords, word);
  for (std::size_t i = 0; i < n; ++i) {
    if (words[i] == now) return static_cast<Enum>(i);
  }
  throw InputError({file, 0}, "", word, "is no word of this file");
}

/// The columns of /cases that say what came out, and the curves.
void write_results(io::Hdf5Group& root, const SweepRecord& record);
/// @throws InputError if a column is missing or of another length than the ids
void read_results(const io::Hdf5Group& root, SweepRecord& record);

/// /meta/case_seconds: times differ between two runs of the same.
void write_case_seconds(io::Hdf5Group& root, const SweepRecord& record);

}  // namespace plastica::sweeps
