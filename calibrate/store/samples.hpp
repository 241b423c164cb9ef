#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/store/columns.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/base/parallel_for.hpp"

/// Curves of a result file: columns of samples, those of one row behind those of the other, and
/// `offsets` where each row begins; not installed. Which columns says a function that calls
///   columns(NAME, UNITS, MEMBER)         a list that has a number for each sample of its row;
///   columns.maybe(NAME, UNITS, MEMBER)   the same, a pointer to it: null where a row has none;
///   columns.table(NAME, MEMBER, WIDTH)   so many numbers for each sample.
namespace plastica::calibrate::store {

/// The curve of a row.
using CurveOfRow = std::function<Curve(std::size_t row)>;

template <typename Row>
class SampleWriter {
 public:
  /// @param remade  of curves that are counted alone; empty: there are none
  SampleWriter(io::Hdf5Group group, const std::vector<const Row*>& rows, CurveOfRow remade = {})
      : group_(std::move(group)), rows_(rows), remade_(std::move(remade)) {}

  template <typename Member>
  void operator()(const std::string& name, std::string_view units, const Member& member) {
    if (offsets_.empty()) {
      offsets_ = {0};
      for (const Row* row : rows_) offsets_.push_back(offsets_.back() + samples_of(*row, member));
    }
    columns_.push_back({name, group_.column(name, offsets_.back(), {units, kDeflate}),
                        [member](const Row& row) { return std::span<const double>(member(row)); }});
  }

  template <typename Member>
  void maybe(const std::string& name, std::string_view units, const Member& member) {
    std::vector<double> all(offsets_.back(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::vector<double>* own = member(*rows_[i]);
      if (own == nullptr) continue;
      if (own->size() != offsets_[i + 1] - offsets_[i]) refuse(name);
      std::ranges::copy(*own, all.begin() + static_cast<std::ptrdiff_t>(offsets_[i]));
    }
    group_.write(name, all, {units, kDeflate});
  }

  /// A row that is narrower than another leaves the last columns empty.
  template <typename Member, typename Width>
  void table(const std::string& name, const Member& member, const Width& width_of) {
    std::size_t width = 0;
    for (const Row* row : rows_) width = std::max(width, width_of(*row));
    std::vector<double> all(offsets_.back() * width, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::vector<double>& own = member(*rows_[i]);
      const std::size_t n = width_of(*rows_[i]);
      const std::size_t samples = offsets_[i + 1] - offsets_[i];
      if (own.size() != samples * n) refuse(name);
      for (std::size_t k = 0; k < samples; ++k) {
        std::copy_n(own.data() + k * n, n, all.data() + (offsets_[i] + k) * width);
      }
    }
    group_.write_table<double>(name, all, width, {{}, kDeflate});
  }

  /// Writes the lists of numbers and the offsets: to be called last.
  void finish() {
    // Of those that lie aside so many together that all threads read, and no more.
    constexpr std::size_t kTogether = 1U << 20U;  // samples
    std::vector<Row> read;
    for (std::size_t first = 0, end = 0; first < rows_.size(); first = end) {
      end = first + 1;
      while (end < rows_.size() && offsets_[end + 1] - offsets_[first] <= kTogether) ++end;
      read_aside(first, end - first, read);
      for (Column& column : columns_) {
        for (std::size_t i = first; i < end; ++i) {
          const std::span<const double> own =
              column.of(is_aside(*rows_[i]) ? read[i - first] : *rows_[i]);
          if (own.size() != offsets_[i + 1] - offsets_[i]) refuse(column.name);
          column.made.append(own);
        }
      }
    }
    for (Column& column : columns_) column.made.finish();
    group_.write("offsets", offsets_, {{}, kDeflate});
  }

 private:
  struct Column {
    std::string name;
    io::Hdf5Column made;
    std::function<std::span<const double>(const Row&)> of;
  };

  static bool is_aside(const Row& row) {
    if constexpr (std::is_same_v<Row, Curve>) return row.is_aside();
    return false;
  }
  /// Rows with the samples of those that do not lie in memory.
  void read_aside(std::size_t first, std::size_t count, std::vector<Row>& read) const {
    if constexpr (std::is_same_v<Row, Curve>) {
      read.assign(count, Row());
      parallel_for(count, {group_.threads(), nullptr}, [&](std::size_t i, int) {
        const Row& row = *rows_[first + i];
        if (!is_aside(row)) return;
        read[i] = row.spool || !remade_ ? with_samples(row) : remade_(first + i);
      });
    }
  }

  template <typename Member>
  static std::size_t samples_of(const Row& row, const Member& member) {
    if constexpr (std::is_same_v<Row, Curve>) {
      return row.samples();
    } else {
      return member(row).size();
    }
  }
  [[noreturn]] void refuse(const std::string& name) const {
    throw std::logic_error(group_.path() + "/" + name + ": a row does not have a number a sample");
  }

  io::Hdf5Group group_;
  const std::vector<const Row*>& rows_;
  std::vector<std::uint64_t> offsets_;
  std::vector<Column> columns_;
  CurveOfRow remade_;
};

inline void count_samples(Curve& curve, std::size_t samples) { curve.aside.samples = samples; }
inline void count_samples(FitResult& result, std::size_t evaluations) {
  result.trace.unread = evaluations;
}

template <typename Row>
class SampleReader {
 public:
  SampleReader(io::Hdf5Group group, const std::vector<Row*>& rows,
               std::span<const io::ValueRule> rules)
      : group_(std::move(group)),
        rows_(rows),
        rules_(rules),
        offsets_(group_.read<std::uint64_t>("offsets")) {}

  template <typename Member>
  void operator()(const std::string& name, std::string_view units, const Member& member) {
    maybe(name, units, [&](Row& row) { return &member(row); });
  }

  /// Only counts the samples of each row: whether each column has so many is looked at, its numbers
  /// are not read.
  template <typename Columns>
  void count(const Columns& columns) {
    Extents extents{*this};
    columns(extents);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      count_samples(*rows_[i], offsets_[i + 1] - offsets_[i]);
    }
  }

  template <typename Member>
  void maybe(const std::string& name, std::string_view /*units*/, const Member& member) {
    const auto all = io::read_numbers<double>(group_, name, rules_);
    check_offsets(name, all.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      std::vector<double>* own = member(*rows_[i]);
      if (own == nullptr) continue;
      own->assign(all.begin() + static_cast<std::ptrdiff_t>(offsets_[i]),
                  all.begin() + static_cast<std::ptrdiff_t>(offsets_[i + 1]));
    }
  }

  template <typename Member, typename Width>
  void table(const std::string& name, const Member& member, const Width& width_of) {
    const std::size_t samples = offsets_.empty() ? 0 : offsets_.back();
    const std::size_t shape[] = {samples, io::Hdf5Group::kAnyExtent};
    const auto all = group_.read_array<double>(name, shape);
    check_offsets(name, samples);
    io::check_values(group_, name, all, io::rule_of(rules_, io::path_from_root(group_, name)));
    const std::size_t width = group_.shape(name)[1];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::size_t n = width_of(*rows_[i]);
      if (n > width) {
        io::refuse_value(group_, name, "", "has fewer columns than a fit has free parameters");
      }
      for (std::size_t k = offsets_[i]; k < offsets_[i + 1]; ++k) {
        const auto row = all.begin() + static_cast<std::ptrdiff_t>(k * width);
        member(*rows_[i]).insert(member(*rows_[i]).end(), row,
                                 row + static_cast<std::ptrdiff_t>(n));
      }
    }
  }

 private:
  /// Checks the extents of columns.
  struct Extents {
    SampleReader& reader;

    template <typename Member>
    void operator()(const std::string& name, std::string_view /*units*/, const Member&) {
      check(name, 1);
    }
    template <typename Member, typename Width>
    void table(const std::string& name, const Member&, const Width&) {
      check(name, 2);
    }
    void check(const std::string& name, std::size_t dimensions) const {
      const std::vector<std::size_t> shape = reader.group_.shape(name);
      if (shape.size() != dimensions) {
        io::refuse_value(reader.group_, name, "", "has another number of dimensions");
      }
      reader.check_offsets(name, shape[0]);
    }
  };

  void check_offsets(const std::string& name, std::size_t size) const {
    const bool fits = offsets_.size() == rows_.size() + 1 && offsets_.front() == 0 &&
                      offsets_.back() == size && std::ranges::is_sorted(offsets_);
    if (!fits) io::refuse_value(group_, name, "", "has offsets that do not fit its values");
  }

  io::Hdf5Group group_;
  const std::vector<Row*>& rows_;
  std::span<const io::ValueRule> rules_;
  std::vector<std::uint64_t> offsets_;
};

}  // namespace plastica::calibrate::store
