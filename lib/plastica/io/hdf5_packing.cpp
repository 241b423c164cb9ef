#include "plastica/io/hdf5_packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plastica/io/hdf5_check.hpp"
#include "plastica/io/hdf5_strings.hpp"

namespace plastica::io::h5 {
namespace {

constexpr const char* kScale = "scale_factor";
constexpr const char* kOffset = "add_offset";
constexpr const char* kUnsigned = "_Unsigned";
constexpr const char* kRange = "valid_range";
constexpr const char* kLeast = "valid_min";
constexpr const char* kLargest = "valid_max";
constexpr std::array<const char*, 2> kMissing{"_FillValue", "missing_value"};
constexpr std::array<const char*, 8> kAll{kScale, kOffset,  kUnsigned,   kRange,
                                          kLeast, kLargest, kMissing[0], kMissing[1]};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Attributes of a dataset that say how its numbers are packed.
class Packing {
 public:
  Packing(const Hdf5Handle& dataset, const Place& place)
      : dataset_(dataset), place_(place), type_(H5Dget_type(dataset.get())) {}

  bool has(const char* name) const { return H5Aexists(dataset_.get(), name) > 0; }
  bool is_of_numbers() const { return is_number(type_); }
  /// Of whole numbers with a sign that stand for such without: how many there are; else 0.
  double unsigned_range() const {
    const bool has_sign =
        H5Tget_class(type_.get()) == H5T_INTEGER && H5Tget_sign(type_.get()) == H5T_SGN_2;
    if (!has_sign || !has(kUnsigned) || !is_true(kUnsigned)) return 0.0;
    return std::ldexp(1.0, static_cast<int>(8 * H5Tget_size(type_.get())));
  }
  double number(const char* name) const { return numbers(name, 1).front(); }
  /// As the dataset would store them.
  /// @param count  that there must be; 0: any
  std::vector<double> stored(const char* name, std::size_t count) const {
    std::vector<double> values = numbers(name, count);
    for (double& value : values) value = as_stored(value);
    return values;
  }
  [[noreturn]] void refuse(const char* name, const char* rule) const {
    (place_ / name).refuse(rule);
  }

 private:
  static bool is_number(const Hdf5Handle& type) {
    const H5T_class_t sort = H5Tget_class(type.get());
    return sort == H5T_FLOAT || sort == H5T_INTEGER;
  }
  std::vector<double> numbers(const char* name, std::size_t count) const {
    const Hdf5Handle attribute(H5Aopen(dataset_.get(), name, H5P_DEFAULT));
    if (attribute.get() < 0) (place_ / name).fail();
    const Hdf5Handle type(H5Aget_type(attribute.get()));
    const Hdf5Handle space(H5Aget_space(attribute.get()));
    const std::size_t found = count_of(space);
    if (!is_number(type) || !refusal_of_attribute(attribute).empty() ||
        (count != 0 && found != count)) {
      refuse(name, count == 1   ? "must be one number"
                   : count == 2 ? "must be two numbers"
                                : "must be numbers");
    }
    std::vector<double> values(found);
    if (found > 0 && H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, values.data()) < 0) {
      (place_ / name).fail();
    }
    return values;
  }
  /// A real number of the attribute's type may have other digits than one of the dataset's.
  double as_stored(double value) const {
    std::array<double, 2> buffer{value, 0.0};
    const hid_t own = type_.get();
    if (H5Tget_class(own) != H5T_FLOAT || H5Tget_size(own) > sizeof buffer) return value;
    if (H5Tconvert(H5T_NATIVE_DOUBLE, own, 1, buffer.data(), nullptr, H5P_DEFAULT) < 0 ||
        H5Tconvert(own, H5T_NATIVE_DOUBLE, 1, buffer.data(), nullptr, H5P_DEFAULT) < 0) {
      place_.fail();
    }
    return buffer[0];
  }
  bool is_true(const char* name) const {
    const std::vector<std::string> texts = texts_of_attribute(dataset_, name, place_);
    if (texts.size() != 1) refuse(name, "must be \"true\" or \"false\"");
    return texts.front() == "true";
  }

  const Hdf5Handle& dataset_;
  const Place& place_;
  Hdf5Handle type_;
};

/// Digits of whole numbers as numbers.
void make_numbers(Column& column) {
  if (column.texts.empty()) return;
  column.numbers.reserve(column.texts.size());
  for (const std::string& digits : column.texts) column.numbers.push_back(std::stod(digits));
  column.texts.clear();
}

void drop_missing(const Packing& packing, double unsigned_range, std::vector<double>& numbers) {
  const auto as_read = [&](double value) { return value < 0.0 ? value + unsigned_range : value; };
  for (const char* name : kMissing) {
    if (!packing.has(name)) continue;
    for (const double value : packing.stored(name, 0)) {
      const double missing = as_read(value);
      for (double& number : numbers) number = number == missing ? kNone : number;
    }
  }
  double least = -std::numeric_limits<double>::infinity(), largest = -least;
  if (packing.has(kRange)) {
    const std::vector<double> range = packing.stored(kRange, 2);
    least = as_read(range[0]);
    largest = as_read(range[1]);
  }
  if (packing.has(kLeast)) least = as_read(packing.stored(kLeast, 1).front());
  if (packing.has(kLargest)) largest = as_read(packing.stored(kLargest, 1).front());
  for (double& number : numbers) number = number < least || number > largest ? kNone : number;
}

}  // namespace

bool is_packed(const Hdf5Handle& dataset) {
  return std::ranges::any_of(kAll,
                             [&](const char* name) { return H5Aexists(dataset.get(), name) > 0; });
}

void unpack(const Hdf5Handle& dataset, const Place& place, Column& column) {
  if (!is_packed(dataset)) return;
  const Packing packing(dataset, place);
  if (!packing.is_of_numbers()) return;
  make_numbers(column);
  const double range = packing.unsigned_range();
  for (double& number : column.numbers) number = number < 0.0 ? number + range : number;
  drop_missing(packing, range, column.numbers);
  const double scale = packing.has(kScale) ? packing.number(kScale) : 1.0;
  const double offset = packing.has(kOffset) ? packing.number(kOffset) : 0.0;
  if (!std::isfinite(scale) || scale == 0.0) packing.refuse(kScale, "must be finite, and not 0");
  if (!std::isfinite(offset)) packing.refuse(kOffset, "must be finite");
  for (double& number : column.numbers) number = number * scale + offset;
}

}  // namespace plastica::io::h5
