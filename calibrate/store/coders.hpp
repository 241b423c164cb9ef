#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "plastica/io/bytes.hpp"

/// How structures become bytes and come back; not installed.
namespace plastica::calibrate::store {

/// Each structure is coded by one function, `code`, for both directions, so that reading cannot
/// forget a field that writing has: a coder puts the field, or gets it.
class Putter {
 public:
  explicit Putter(io::ByteWriter& writer) : writer_(writer) {}

  template <typename... T>
  void operator()(const T&... values) {
    (writer_.put(values), ...);
  }
  template <typename T, typename Code>
  void each(const std::vector<T>& items, const Code& code_item) {
    writer_.put(std::uint64_t{items.size()});
    for (const T& item : items) code_item(*this, item);
  }
  template <typename T, typename Code>
  void maybe(const std::optional<T>& item, const Code& code_item) {
    writer_.put(item.has_value());
    if (item) code_item(*this, *item);
  }

 private:
  io::ByteWriter& writer_;
};

class Getter {
 public:
  explicit Getter(io::ByteReader& reader) : reader_(reader) {}

  template <typename... T>
  void operator()(T&... values) {
    ((values = reader_.get<T>()), ...);
  }
  template <typename T, typename Code>
  void each(std::vector<T>& items, const Code& code_item) {
    const auto count = reader_.get<std::uint64_t>();
    items.clear();
    // No reserve: a count that is wrong must run into the record's end, not ask for all memory.
    for (std::uint64_t i = 0; i < count; ++i) code_item(*this, items.emplace_back());
  }
  template <typename T, typename Code>
  void maybe(std::optional<T>& item, const Code& code_item) {
    item.reset();
    if (reader_.get<bool>()) code_item(*this, item.emplace());
  }

 private:
  io::ByteReader& reader_;
};

/// A structure as a coder wants it: constant for writing.
template <typename T, typename Wanted>
concept A = std::same_as<std::remove_const_t<T>, Wanted>;

}  // namespace plastica::calibrate::store
