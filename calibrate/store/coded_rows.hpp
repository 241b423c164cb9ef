#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/result/words.hpp"
#include "calibrate/target/curve.hpp"
#include "plastica/io/bytes.hpp"
#include "plastica/io/storage_error.hpp"

/// How what is described becomes bytes of a journal and comes back; not installed.
namespace plastica::calibrate::store {

/// One function codes a structure in both directions, so that reading cannot forget a field that
/// writing has: a coder puts the field, or gets it.
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
    (get(values), ...);
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
  template <typename T>
  void get(T& value) {
    value = reader_.get<T>();
    if constexpr (std::is_enum_v<T>) check(value);
  }
  template <typename T>
  void get(std::optional<T>& value) {
    value = reader_.get<std::optional<T>>();
    if constexpr (std::is_enum_v<T>) {
      if (value) check(*value);
    }
  }
  /// Reports look for its word. @throws io::StorageError if it has none
  template <typename Enum>
  static void check(Enum value) {
    if (static_cast<std::size_t>(value) < words_of<Enum>().size()) return;
    throw io::StorageError("a record of a fit", "has a number that stands for no word");
  }

  io::ByteReader& reader_;
};

/// A structure as a coder wants it: constant for writing.
template <typename T, typename Wanted>
concept A = std::same_as<std::remove_const_t<T>, Wanted>;

/// Codes what a description (result/describe.hpp) says of a record.
template <typename Coder, typename Row>
class DescribedCoder {
 public:
  DescribedCoder(Coder& coder, Row& row) : coder_(coder), row_(row) {}

  template <typename Member>
  void operator()(std::string_view, std::string_view, const Member& member, std::string_view = {}) {
    coder_(member(row_));
  }
  template <typename Function>
  void derived(std::string_view, std::string_view, const Function&, std::string_view = {}) {}
  template <typename Columns>
  void since(int, const Columns& columns) {
    columns(*this);
  }
  template <typename Condition, typename Columns>
  void only(const Condition& condition, const Columns& columns) {
    if (condition(row_)) columns(*this);
  }
  template <typename Member, typename Columns>
  void optional(std::string_view, const Member& member, const Columns& columns) {
    coder_.maybe(member(row_), [&](auto& to, auto& each) {
      DescribedCoder<std::remove_reference_t<decltype(to)>, std::remove_reference_t<decltype(each)>>
          of_inner(to, each);
      columns(of_inner);
    });
  }

 private:
  Coder& coder_;
  Row& row_;
};

void code_described(auto& coder, auto& row, const auto& description) {
  DescribedCoder described(coder, row);
  description(described);
}

/// Rows of a layout (see tables.hpp) in a journal, which has no paths, units and older versions.
template <typename Coder, typename Row>
class CodedRows {
 public:
  CodedRows(Coder& coder, std::vector<Row*> rows) : coder_(coder), rows_(std::move(rows)) {}

  template <typename Description>
  void columns(std::string_view, const Description& description) {
    for (Row* row : rows_) code_described(coder_, *row, description);
  }
  template <typename Member>
  void numbers(std::string_view, std::string_view, const Member& member) {
    for (Row* row : rows_) coder_(member(*row));
  }
  /// Of curves, how many samples they have: the fitted ones can be made again.
  template <typename Columns>
  void samples(std::string_view, const Columns& columns) {
    if constexpr (std::is_same_v<std::remove_const_t<Row>, Curve>) {
      for (Row* row : rows_) {
        std::uint64_t count = row->samples();
        coder_(count);
        if constexpr (!std::is_const_v<Row>) row->aside.samples = count;
      }
    } else {
      SampleCoder coder{*this};
      columns(coder);
    }
  }
  template <typename Member, typename Description>
  auto list(std::string_view, const Member& member, const Description& description) {
    using Item = std::remove_reference_t<decltype(*member(*rows_[0]).begin())>;
    std::vector<Item*> items;
    for (Row* row : rows_) {
      auto& list = member(*row);
      coder_.each(list, [&](auto& to, auto& item) { code_described(to, item, description); });
      for (Item& item : list) items.push_back(&item);
    }
    return CodedRows<Coder, Item>(coder_, std::move(items));
  }
  template <typename Member>
  auto part(const Member& member) const {
    using Part = std::remove_reference_t<decltype(member(*rows_[0]))>;
    std::vector<Part*> parts;
    for (Row* row : rows_) parts.push_back(&member(*row));
    return CodedRows<Coder, Part>(coder_, std::move(parts));
  }
  /// Whether a row has it is part of its columns.
  template <typename Member>
  auto maybe(const Member& member) const {
    using Part = std::remove_reference_t<decltype(*member(*rows_[0]))>;
    std::vector<Part*> parts;
    for (Row* row : rows_) {
      if (member(*row)) parts.push_back(&*member(*row));
    }
    return CodedRows<Coder, Part>(coder_, std::move(parts));
  }
  template <typename Layout>
  void since(int, const Layout& layout) {
    layout(*this);
  }

 private:
  struct SampleCoder {
    CodedRows& rows;

    template <typename Member>
    void operator()(std::string_view, std::string_view, const Member& member) {
      rows.numbers({}, {}, member);
    }
    template <typename Member, typename Width>
    void table(std::string_view, const Member& member, const Width&) {
      rows.numbers({}, {}, member);
    }
  };

  Coder& coder_;
  std::vector<Row*> rows_;
};

}  // namespace plastica::calibrate::store
