#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

static_assert(std::endian::native == std::endian::little,
              "records are little-endian and are copied as they are");

/// Numbers, truth values and enumerators: what a record holds as it is in memory.
template <typename T>
concept PlainValue = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Builds a record: little-endian, no padding, lengths as 64-bit integers.
class ByteWriter {
 public:
  template <PlainValue T>
  ByteWriter& put(T value) {
    return append(&value, sizeof value);
  }
  ByteWriter& put(std::string_view text) {
    put(std::uint64_t{text.size()});
    return append(text.data(), text.size());
  }
  ByteWriter& put(const std::string& text) { return put(std::string_view(text)); }
  ByteWriter& put(const char* text) { return put(std::string_view(text)); }
  template <PlainValue T>
  requires(!std::same_as<T, bool>) ByteWriter& put(const std::vector<T>& values) {
    put(std::uint64_t{values.size()});
    return append(values.data(), values.size() * sizeof(T));
  }
  ByteWriter& put(const std::vector<std::string>& texts) {
    put(std::uint64_t{texts.size()});
    for (const std::string& text : texts) put(text);
    return *this;
  }
  template <typename T>
  ByteWriter& put(const std::optional<T>& value) {
    put(value.has_value());
    return value ? put(*value) : *this;
  }

  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  ByteWriter& append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
    return *this;
  }

  std::vector<std::byte> bytes_;
};

/// Takes a record apart, in the order in which it was built.
/// Each `get` throws StorageError if the record ends before the value does.
class ByteReader {
 public:
  /// @param bytes   must outlive the reader
  /// @param source  named in errors
  explicit ByteReader(std::span<const std::byte> bytes, std::string source = "record")
      : bytes_(bytes), source_(std::move(source)) {}

  template <PlainValue T>
  T get() {
    if constexpr (std::same_as<T, bool>) {
      return get<std::uint8_t>() != 0;  // any other byte in a bool is undefined behaviour
    } else {
      T value;
      std::memcpy(&value, next(sizeof value).data(), sizeof value);
      return value;
    }
  }
  template <std::same_as<std::string> T>
  T get() {
    const std::span<const std::byte> text = next(length(1));
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }
  template <typename T>
  requires std::same_as<T, std::vector<typename T::value_type>> T get() {
    using Element = typename T::value_type;
    if constexpr (PlainValue<Element>) {
      T values(length(sizeof(Element)));
      const std::span<const std::byte> data = next(values.size() * sizeof(Element));
      if (!values.empty()) std::memcpy(values.data(), data.data(), data.size());
      return values;
    } else {
      T values(length(sizeof(std::uint64_t)));
      for (Element& value : values) value = get<Element>();
      return values;
    }
  }
  template <typename T>
  requires std::same_as<T, std::optional<typename T::value_type>> T get() {
    if (!get<bool>()) return std::nullopt;
    return get<typename T::value_type>();
  }

  std::size_t remaining() const { return bytes_.size(); }
  /// @throws StorageError if something is left: the record was built by another version
  void expect_end() const {
    if (!bytes_.empty()) {
      throw StorageError(source_, "has " + std::to_string(bytes_.size()) + " bytes too many");
    }
  }

 private:
  std::span<const std::byte> next(std::size_t size) {
    if (size > bytes_.size()) throw StorageError(source_, "ends in the middle of a value");
    const std::span<const std::byte> taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }
  /// A number of elements that can be there, so that a wrong one cannot ask for all memory.
  std::size_t length(std::size_t element_bytes) {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size() / element_bytes) {
      throw StorageError(source_, "ends in the middle of a value");
    }
    return static_cast<std::size_t>(count);
  }

  std::span<const std::byte> bytes_;
  std::string source_;
};

}  // namespace plastica::io
