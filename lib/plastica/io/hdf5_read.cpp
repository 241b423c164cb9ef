#include <algorithm>
#include <array>
#include <new>

#include "plastica/base/renamed.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_check.hpp"
#include "plastica/io/hdf5_handle.hpp"
#include "plastica/io/hdf5_strings.hpp"

namespace plastica::io {
namespace {

Hdf5Kind kind_of_type(const Hdf5Handle& type) {
  switch (H5Tget_class(type.get())) {
    case H5T_FLOAT: return Hdf5Kind::Real;
    case H5T_INTEGER: return Hdf5Kind::Integer;
    case H5T_STRING: return Hdf5Kind::Text;
    default: return Hdf5Kind::Other;
  }
}

}  // namespace

void Hdf5Group::refuse(std::string_view path, std::string_view rule) const {
  throw InputError({file_, 0}, full_path(path), "", rule);
}

bool Hdf5Group::has_links(const std::string& full) const {
  for (std::size_t slash = full.find('/', 1);; slash = full.find('/', slash + 1)) {
    const std::string upto = full.substr(0, slash);
    if (upto != "/") {
      const h5::Link link = h5::link_at(handle_, upto);
      if (link == h5::Link::None) return false;
      if (link == h5::Link::Elsewhere) refuse(upto, "is a link elsewhere: results have none");
    }
    if (slash == std::string::npos) return true;
  }
}

/// A path with the old name of each part that the file has only under that; empty if the file has
/// no such path.
std::string Hdf5Group::stored_path(const std::string& full) const {
  if (has_links(full)) return full;
  std::string path;
  for (std::size_t begin = 1; begin < full.size();) {
    const std::size_t end = std::min(full.find('/', begin), full.size());
    const std::string name = full.substr(begin, end - begin);
    const std::string before(old_name(kRenamedStored, name));
    path += '/';
    const bool is_old = !before.empty() && !has_links(path + name) && has_links(path + before);
    path += is_old ? before : name;
    begin = end + 1;
  }
  return has_links(path) ? path : std::string();
}

void Hdf5Group::fail_to_read(std::string_view path, const std::string& attribute) const {
  const std::string why = h5::innermost_error();
  // What the file says was read, and HDF5 can make nothing of it; only memory is the machine's.
  if (why.find("memory allocation") != std::string::npos) throw std::bad_alloc();
  refuse(path, (attribute.empty() ? "" : "attribute " + attribute + " ") + "is damaged: " + why);
}

Hdf5Kind Hdf5Group::kind(std::string_view path) const {
  const std::string full = stored_path(full_path(path));
  if (full.empty()) return Hdf5Kind::None;
  const Hdf5Handle object(H5Oopen(handle_.get(), full.c_str(), H5P_DEFAULT));
  if (object.get() < 0) fail_to_read(full);
  const H5I_type_t sort = H5Iget_type(object.get());
  if (sort == H5I_GROUP) return Hdf5Kind::Group;
  if (sort != H5I_DATASET) return Hdf5Kind::Other;
  return kind_of_type(Hdf5Handle(H5Dget_type(object.get())));
}

Hdf5Group Hdf5Group::open_group(std::string_view path) const {
  const std::string full = full_path(path);
  if (kind(full) != Hdf5Kind::Group) refuse(full, "is not a group of this file");
  Hdf5Handle opened(H5Gopen2(handle_.get(), stored_path(full).c_str(), H5P_DEFAULT));
  if (opened.get() < 0) fail_to_read(full);
  return {std::move(opened), file_, full};
}

Hdf5Handle Hdf5Group::open_object(std::string_view path) const {
  const std::string full = stored_path(full_path(path));
  if (full.empty()) refuse(path, "is not in this file");
  Hdf5Handle object(H5Oopen(handle_.get(), full.c_str(), H5P_DEFAULT));
  if (object.get() < 0) fail_to_read(full);
  return object;
}

Hdf5Handle Hdf5Group::open_dataset(std::string_view path) const {
  Hdf5Handle object = open_object(path);
  if (H5Iget_type(object.get()) != H5I_DATASET) refuse(path, "is not a dataset");
  if (const std::string why = h5::refusal_of_dataset(object); !why.empty()) refuse(path, why);
  return object;
}

std::vector<std::string> Hdf5Group::children() const {
  std::vector<std::string> names;
  if (!h5::read_link_names(handle_, names)) fail_to_read(path_);
  return names;
}

std::vector<std::size_t> Hdf5Group::shape(std::string_view path) const {
  const Hdf5Handle dataset = open_dataset(path);
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  const int rank = H5Sget_simple_extent_ndims(space.get());
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr);
  return {extents.begin(), extents.end()};
}

void Hdf5Group::require_shape(std::string_view path, std::span<const std::size_t> wanted) const {
  const std::vector<std::size_t> extents = shape(path);
  const auto fits = [](std::size_t extent, std::size_t want) {
    return want == kAnyExtent || extent == want;
  };
  if (std::ranges::equal(extents, wanted, fits)) return;
  if (wanted.empty()) refuse(path, "is not a single value");
  std::string words;
  for (const std::size_t extent : wanted) {
    words += words.empty() ? "" : " x ";
    words += extent == kAnyExtent ? "n" : std::to_string(extent);
  }
  refuse(path, "must have the extents " + words);
}

template <Hdf5Number T>
std::vector<T> Hdf5Group::read_array(std::string_view path,
                                     std::span<const std::size_t> shape) const {
  const Hdf5Handle dataset = open_dataset(path);
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  const H5T_class_t sort = H5Tget_class(type.get());
  if (sort != H5T_INTEGER && sort != H5T_FLOAT) refuse(path, "does not hold numbers");
  if constexpr (std::is_integral_v<T>) {
    if (sort == H5T_FLOAT) refuse(path, "does not hold integers");
    const std::string why = h5::refusal_of_integers(type, sizeof(T), std::is_signed_v<T>);
    if (!why.empty()) refuse(path, why);
  }
  require_shape(path, shape);
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  std::vector<T> values(h5::count_of(space));
  if (values.empty()) return values;
  const hid_t memory = h5::memory_type<T>();
  const Hdf5Handle transfer(h5::new_transfer(values.size(), memory));
  if (H5Dread(dataset.get(), memory, H5S_ALL, H5S_ALL, transfer.get(), values.data()) < 0) {
    fail_to_read(path);
  }
  return values;
}

template <Hdf5Number T>
std::vector<T> Hdf5Group::read(std::string_view path) const {
  return read_array<T>(path, std::array{kAnyExtent});
}

template <Hdf5Number T>
T Hdf5Group::read_scalar(std::string_view path) const {
  return read_array<T>(path, {}).at(0);
}

template <Hdf5Number T>
Ragged<T> Hdf5Group::read_ragged(std::string_view path) const {
  const Hdf5Group from = open_group(path);
  Ragged<T> rows;
  rows.values = from.read<T>("values");
  rows.offsets = from.read<std::uint64_t>("offsets");
  const bool fits = !rows.offsets.empty() && rows.offsets.front() == 0 &&
                    rows.offsets.back() == rows.values.size() &&
                    std::is_sorted(rows.offsets.begin(), rows.offsets.end());
  if (!fits) refuse(path, "has offsets that do not fit its values");
  return rows;
}

std::vector<std::string> Hdf5Group::read_text_array(std::string_view path,
                                                    std::span<const std::size_t> shape) const {
  const Hdf5Handle dataset = open_dataset(path);
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  if (H5Tget_class(type.get()) != H5T_STRING) refuse(path, "does not hold text");
  require_shape(path, shape);
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* out) {
    const Hdf5Handle transfer(h5::new_transfer(h5::count_of(space), memory));
    return H5Dread(dataset.get(), memory, H5S_ALL, H5S_ALL, transfer.get(), out) >= 0;
  };
  if (!h5::read_strings(type, space, read, texts)) fail_to_read(path);
  return texts;
}

std::vector<std::string> Hdf5Group::read_texts(std::string_view path) const {
  return read_text_array(path, std::array{kAnyExtent});
}

std::string Hdf5Group::read_text(std::string_view path) const {
  return std::move(read_text_array(path, {}).at(0));
}

bool Hdf5Group::has_attribute(std::string_view path, const std::string& name) const {
  const Hdf5Handle object = open_object(path);
  return H5Aexists(object.get(), name.c_str()) > 0;
}

std::vector<std::string> Hdf5Group::attribute_names(std::string_view path) const {
  const Hdf5Handle object = open_object(path);
  std::vector<std::string> names;
  if (!h5::read_attribute_names(object, names)) fail_to_read(path);
  return names;
}

Hdf5Kind Hdf5Group::attribute_kind(std::string_view path, const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(path, name);
  return kind_of_type(Hdf5Handle(H5Aget_type(attribute.get())));
}

Hdf5Handle Hdf5Group::open_attribute(std::string_view path, const std::string& name) const {
  const Hdf5Handle object = open_object(path);
  if (H5Aexists(object.get(), name.c_str()) <= 0) refuse(path, "has no attribute " + name);
  Hdf5Handle attribute(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT));
  if (attribute.get() < 0) fail_to_read(path, name);
  if (const std::string why = h5::refusal_of_attribute(attribute); !why.empty()) {
    refuse(path, "attribute " + name + " " + why);
  }
  return attribute;
}

std::vector<std::string> Hdf5Group::texts_attribute(std::string_view path,
                                                    const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(path, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  if (H5Tget_class(type.get()) != H5T_STRING) refuse(path, "attribute " + name + " is not text");
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* out) {
    return H5Aread(attribute.get(), memory, out) >= 0;
  };
  if (!h5::read_strings(type, space, read, texts)) fail_to_read(path, name);
  return texts;
}

std::string Hdf5Group::text_attribute(std::string_view path, const std::string& name) const {
  std::vector<std::string> texts = texts_attribute(path, name);
  if (texts.size() != 1) refuse(path, "attribute " + name + " is not a single text");
  return std::move(texts[0]);
}

double Hdf5Group::real_attribute(std::string_view path, const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(path, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  const H5T_class_t sort = H5Tget_class(type.get());
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  double value = 0.0;
  if ((sort != H5T_FLOAT && sort != H5T_INTEGER) || h5::count_of(space) != 1) {
    refuse(path, "attribute " + name + " is not a single number");
  }
  if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0) {
    fail_to_read(path, name);
  }
  return value;
}

std::int64_t Hdf5Group::integer_attribute(std::string_view path, const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(path, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  std::int64_t value = 0;
  if (H5Tget_class(type.get()) != H5T_INTEGER || h5::count_of(space) != 1) {
    refuse(path, "attribute " + name + " is not a single integer");
  }
  if (const std::string why = h5::refusal_of_integers(type, sizeof(value), true); !why.empty()) {
    refuse(path, "attribute " + name + " " + why);
  }
  if (H5Aread(attribute.get(), H5T_NATIVE_INT64, &value) < 0) {
    fail_to_read(path, name);
  }
  return value;
}

#define PLASTICA_INSTANTIATE(T)                                                                    \
  template T Hdf5Group::read_scalar<T>(std::string_view) const;                                    \
  template std::vector<T> Hdf5Group::read<T>(std::string_view) const;                              \
  template std::vector<T> Hdf5Group::read_array<T>(std::string_view, std::span<const std::size_t>) \
      const;                                                                                       \
  template Ragged<T> Hdf5Group::read_ragged<T>(std::string_view) const
PLASTICA_INSTANTIATE(double);
PLASTICA_INSTANTIATE(float);
PLASTICA_INSTANTIATE(std::int32_t);
PLASTICA_INSTANTIATE(std::int64_t);
PLASTICA_INSTANTIATE(std::uint64_t);
PLASTICA_INSTANTIATE(std::uint8_t);
#undef PLASTICA_INSTANTIATE

}  // namespace plastica::io
