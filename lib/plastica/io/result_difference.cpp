#include "plastica/io/result_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/result_rows.hpp"

namespace plastica::io {
namespace {

/// Integers of either sign, exactly.
struct Integers {
  std::vector<std::uint64_t> bits;
  bool is_signed = true;

  double real(std::size_t i) const {
    return is_signed ? static_cast<double>(std::bit_cast<std::int64_t>(bits[i]))
                     : static_cast<double>(bits[i]);
  }
  std::string text(std::size_t i) const {
    return is_signed ? fmt::format("{}", std::bit_cast<std::int64_t>(bits[i]))
                     : fmt::format("{}", bits[i]);
  }
};

Integers integers_of(const Hdf5Group& root, const std::string& path,
                     const std::vector<std::size_t>& shape) {
  Integers all;
  try {
    for (const std::int64_t value : root.read_array<std::int64_t>(path, shape)) {
      all.bits.push_back(std::bit_cast<std::uint64_t>(value));
    }
  } catch (const InputError&) {
    all.bits = root.read_array<std::uint64_t>(path, shape);
    all.is_signed = false;
  }
  return all;
}

/// Texts of any shape.
std::vector<std::string> texts_of(const Hdf5Group& root, const std::string& path,
                                  const std::vector<std::size_t>& shape) {
  if (shape.empty()) return {root.read_text(path)};
  return root.read_texts(path);
}

/// The difference over the larger of the two; none of what is not finite.
std::optional<double> relative_of(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  const double size = std::max(std::fabs(a), std::fabs(b));
  if (size == 0.0) return 0.0;
  const double difference = std::fabs(a - b);
  return std::isfinite(difference) ? difference / size : std::fabs(a / size - b / size);
}

std::string extents_text(const std::vector<std::size_t>& shape) {
  return shape.empty() ? "one value" : fmt::format("extents {}", fmt::join(shape, " x "));
}

std::string kind_text(Hdf5Kind kind) {
  switch (kind) {
    case Hdf5Kind::None: return "nothing";
    case Hdf5Kind::Group: return "a group";
    case Hdf5Kind::Real: return "real numbers";
    case Hdf5Kind::Integer: return "integers";
    case Hdf5Kind::Text: return "texts";
    case Hdf5Kind::Other: break;
  }
  return "something else";
}

std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

/// Compares two open files.
class FileComparison {
 public:
  FileComparison(const Hdf5Group& first, const Hdf5Group& second, const DifferenceRule& rule)
      : first_(first), second_(second), rule_(rule), met_(rule.left_out.size(), false) {}

  ResultComparison compare() && {
    compare_groups("");
    for (std::size_t k = 0; k < met_.size(); ++k) {
      if (!met_[k]) throw InputError({}, "--ignore", rule_.left_out[k], "is in neither file");
    }
    return std::move(found_);
  }

 private:
  /// Whether a group or dataset, or an attribute ("/fits/cost @units"), is none of the result.
  bool is_left_out(const std::string& path) {
    bool left_out = path == "/" + std::string(kMetaGroup) || path == "/" + std::string(kVtkGroup) ||
                    path == " @" + std::string(kRunAttribute);
    for (std::size_t k = 0; k < met_.size(); ++k) {
      const bool named = path == rule_.left_out[k] || path == " " + rule_.left_out[k];
      if (named) met_[k] = true;
      left_out = left_out || named;
    }
    const auto& identities = rule_.identities;
    return left_out || std::find(identities.begin(), identities.end(), path) != identities.end();
  }

  void add(ResultDifference difference) {
    ++found_.differing;
    if (difference.relative) found_.largest = std::max(found_.largest, *difference.relative);
    if (found_.differences.size() < rule_.kept) found_.differences.push_back(std::move(difference));
  }

  /// @param path  of a group in both files: "", "/fits"
  void compare_groups(const std::string& path) {
    // Results have groups in groups in groups. A hard link to a group around it would have no end.
    constexpr std::ptrdiff_t kDeepest = 16;
    if (std::ranges::count(path, '/') > kDeepest) {
      throw InputError({first_.file(), 0}, path, "", "is nested deeper than any result");
    }
    compare_attributes(path);
    const std::string shown = path.empty() ? "/" : path;
    std::vector<std::string> names = first_.open_group(shown).children();
    for (const std::string& name : second_.open_group(shown).children()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const std::string& name : names) {
      const std::string at = fmt::format("{}/{}", path, name);
      if (is_left_out(at)) continue;
      const Hdf5Kind a = first_.kind(at);
      const Hdf5Kind b = second_.kind(at);
      if (a != b) {
        add({at, "", kind_text(a), kind_text(b)});
      } else if (a == Hdf5Kind::Group) {
        compare_groups(at);
      } else {
        compare_datasets(at, a);
      }
    }
  }

  void compare_datasets(const std::string& path, Hdf5Kind kind) {
    compare_attributes(path);
    const std::vector<std::size_t> shape = first_.shape(path);
    const std::vector<std::size_t> other = second_.shape(path);
    if (shape != other) {
      add({path, "", extents_text(shape), extents_text(other)});
      return;
    }
    switch (kind) {
      case Hdf5Kind::Real: compare_reals(path, shape); return;
      case Hdf5Kind::Integer: compare_integers(path, shape); return;
      case Hdf5Kind::Text: compare_texts(path, shape); return;
      default: throw InputError({first_.file(), 0}, path, "", "holds what no result has");
    }
  }

  void compare_reals(const std::string& path, const std::vector<std::size_t>& shape) {
    const std::vector<double> a = first_.read_array<double>(path, shape);
    const std::vector<double> b = second_.read_array<double>(path, shape);
    found_.numbers += a.size();
    double largest = 0.0;
    for (const std::vector<double>* values : {&a, &b}) {
      for (const double value : *values) {
        if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
      }
    }
    std::optional<ResultRows> rows;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (are_equal(a[i], b[i], rule_.floor * largest)) continue;
      add_numbers(path, shape, i, fmt::format("{}", a[i]), fmt::format("{}", b[i]),
                  relative_of(a[i], b[i]), rows);
    }
  }

  void compare_integers(const std::string& path, const std::vector<std::size_t>& shape) {
    const Integers a = integers_of(first_, path, shape);
    const Integers b = integers_of(second_, path, shape);
    found_.numbers += a.bits.size();
    std::optional<ResultRows> rows;
    for (std::size_t i = 0; i < a.bits.size(); ++i) {
      if (a.is_signed == b.is_signed && a.bits[i] == b.bits[i]) continue;
      const std::optional<double> relative = relative_of(a.real(i), b.real(i));
      if (rule_.within > 0.0 && *relative <= rule_.within) continue;
      add_numbers(path, shape, i, a.text(i), b.text(i), relative, rows);
    }
  }

  void compare_texts(const std::string& path, const std::vector<std::size_t>& shape) {
    const std::vector<std::string> a = texts_of(first_, path, shape);
    const std::vector<std::string> b = texts_of(second_, path, shape);
    found_.texts += a.size();
    std::optional<ResultRows> rows;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == b[i]) continue;
      add_numbers(path, shape, i, in_quotes(a[i]), in_quotes(b[i]), std::nullopt, rows);
    }
  }

  bool are_equal(double a, double b, double negligible) const {
    if (a == b || (std::isnan(a) && std::isnan(b))) return true;
    const std::optional<double> relative = relative_of(a, b);
    if (!relative) return false;
    if (std::max(std::fabs(a), std::fabs(b)) <= negligible) return true;
    return rule_.within > 0.0 && *relative <= rule_.within;
  }

  /// @param rows  names of the rows, found once they are needed
  void add_numbers(const std::string& path, const std::vector<std::size_t>& shape, std::size_t at,
                   std::string first, std::string second, std::optional<double> relative,
                   std::optional<ResultRows>& rows) {
    const bool listed = found_.differences.size() < rule_.kept;
    if (listed && !rows) rows.emplace(first_, path);
    add({path, listed ? rows->name(at, shape) : "", std::move(first), std::move(second), relative});
  }

  void compare_attributes(const std::string& path) {
    const std::string at = path.empty() ? "/" : path;
    std::vector<std::string> names = first_.attribute_names(at);
    for (const std::string& name : second_.attribute_names(at)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const std::string& name : names) {
      const std::string place = fmt::format("{} @{}", path, name);
      if (!is_left_out(place)) compare_attribute(at, name, place);
    }
  }

  void compare_attribute(const std::string& at, const std::string& name, const std::string& place) {
    const auto there = [&](const Hdf5Group& root) { return root.has_attribute(at, name); };
    const std::string shown = at == "/" ? "/" + place : place;
    if (!there(first_) || !there(second_)) {
      const auto text = [&](const Hdf5Group& root) {
        return there(root) ? std::string("there") : kind_text(Hdf5Kind::None);
      };
      add({shown, "", text(first_), text(second_)});
      return;
    }
    const Hdf5Kind kind = first_.attribute_kind(at, name);
    const Hdf5Kind other = second_.attribute_kind(at, name);
    if (kind != other) {
      add({shown, "", kind_text(kind), kind_text(other)});
    } else if (kind == Hdf5Kind::Text) {
      ++found_.texts;
      const auto a = first_.texts_attribute(at, name);
      const auto b = second_.texts_attribute(at, name);
      if (a != b) {
        add({shown, "", in_quotes(fmt::format("{}", fmt::join(a, ", "))),
             in_quotes(fmt::format("{}", fmt::join(b, ", ")))});
      }
    } else if (kind == Hdf5Kind::Integer) {
      ++found_.numbers;
      const std::int64_t a = first_.integer_attribute(at, name);
      const std::int64_t b = second_.integer_attribute(at, name);
      if (a != b) add({shown, "", fmt::format("{}", a), fmt::format("{}", b)});
    } else {
      ++found_.numbers;
      const double a = first_.real_attribute(at, name);
      const double b = second_.real_attribute(at, name);
      if (!are_equal(a, b, 0.0)) {
        add({shown, "", fmt::format("{}", a), fmt::format("{}", b), relative_of(a, b)});
      }
    }
  }

  const Hdf5Group& first_;
  const Hdf5Group& second_;
  const DifferenceRule& rule_;
  std::vector<bool> met_;  ///< whether each of what is left out was met
  ResultComparison found_;
};

/// What of /meta may change digits: versions, and the instruction set.
std::vector<std::string> notes_of(const RunMeta& a, const RunMeta& b) {
  std::vector<std::string> notes;
  for (const auto& [name, version] : a.versions) {
    for (const auto& [other, of_other] : b.versions) {
      if (name != other || version == of_other) continue;
      notes.push_back(fmt::format("{} {} and {}", name, version, of_other));
    }
  }
  if (a.instruction_set != b.instruction_set) {
    notes.push_back(
        fmt::format("instruction sets {} and {}", a.instruction_set, b.instruction_set));
  }
  return notes;
}

}  // namespace

ResultComparison compare_results(const std::string& first, const std::string& second,
                                 const DifferenceRule& rule) {
  const std::string schema = schema_of(first);
  const std::string other = schema_of(second);
  if (schema != other) {
    throw InputError({second, 0}, "schema", other, "must be " + schema + ", as of " + first);
  }
  const Hdf5File a = Hdf5File::open(first);
  const Hdf5File b = Hdf5File::open(second);
  ResultComparison found = FileComparison(a.root(), b.root(), rule).compare();
  found.notes = notes_of(read_meta(a.root()), read_meta(b.root()));
  return found;
}

}  // namespace plastica::io
