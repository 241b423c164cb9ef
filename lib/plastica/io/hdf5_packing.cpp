#include "plastica/io/hdf5_packing.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "plastica/io/hdf5_check.hpp"

namespace plastica::io::h5 {
namespace {

constexpr const char* kScale = "scale_factor";
constexpr const char* kOffset = "add_offset";
constexpr std::array<const char*, 2> kMissing{"_FillValue", "missing_value"};

bool has(const Hdf5Handle& dataset, const char* name) { return H5Aexists(dataset.get(), name) > 0; }

/// The number that an attribute is.
double number_of(const Hdf5Handle& dataset, const char* name, const Place& place) {
  const Hdf5Handle attribute(H5Aopen(dataset.get(), name, H5P_DEFAULT));
  if (attribute.get() < 0) (place / name).fail();
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  const H5T_class_t sort = H5Tget_class(type.get());
  const bool is_number = sort == H5T_FLOAT || sort == H5T_INTEGER;
  if (!is_number || count_of(space) != 1 || !refusal_of_attribute(attribute).empty()) {
    (place / name).refuse("must be one number");
  }
  double value = 0.0;
  if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0) (place / name).fail();
  return value;
}

/// Digits of whole numbers as numbers.
void make_numbers(Column& column) {
  if (column.texts.empty()) return;
  column.numbers.reserve(column.texts.size());
  for (const std::string& digits : column.texts) column.numbers.push_back(std::stod(digits));
  column.texts.clear();
}

}  // namespace

bool is_packed(const Hdf5Handle& dataset) {
  const auto there = [&](const char* name) { return has(dataset, name); };
  return there(kScale) || there(kOffset) || std::ranges::any_of(kMissing, there);
}

void unpack(const Hdf5Handle& dataset, const Place& place, Column& column) {
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  if (H5Tget_class(type.get()) == H5T_STRING || !is_packed(dataset)) return;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  make_numbers(column);
  for (const char* name : kMissing) {
    if (!has(dataset, name)) continue;
    const double missing = number_of(dataset, name, place);
    for (double& number : column.numbers) number = number == missing ? kNone : number;
  }
  const double scale = has(dataset, kScale) ? number_of(dataset, kScale, place) : 1.0;
  const double offset = has(dataset, kOffset) ? number_of(dataset, kOffset, place) : 0.0;
  if (!std::isfinite(scale) || scale == 0.0) (place / kScale).refuse("must not be 0, and finite");
  if (!std::isfinite(offset)) (place / kOffset).refuse("must be finite");
  for (double& number : column.numbers) number = number * scale + offset;
}

}  // namespace plastica::io::h5
