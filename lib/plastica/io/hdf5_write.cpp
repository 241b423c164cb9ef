#include <algorithm>
#include <stdexcept>
#include <utility>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_chunks.hpp"
#include "plastica/io/hdf5_handle.hpp"

namespace plastica::io {
namespace {

/// HDF5 ends a string at its first zero byte; to cut it there in silence would lose text.
void check_text(const std::string& file, const std::string& path, std::string_view text) {
  if (text.find('\0') == std::string_view::npos) return;
  throw StorageError(file, "cannot write " + path + ": the text has a zero byte");
}

std::vector<const char*> pointers_to(std::span<const std::string> texts) {
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  return pointers;
}

/// The width in which texts are stored side by side, padded with zero bytes, so that they deflate;
/// 0: they are few, or one is far longer than the others, and each has its own place.
std::size_t width_of(std::span<const std::string> texts) {
  constexpr std::size_t kSmall = 4096;
  constexpr std::size_t kMostPadding = 8;  // bytes stored for one of text, before they are deflated
  std::size_t longest = 1;                 // the least that HDF5 has
  std::size_t sum = texts.size();
  for (const std::string& text : texts) {
    longest = std::max(longest, text.size());
    sum += text.size();
  }
  const std::size_t bytes = longest * texts.size();
  return bytes > kSmall && bytes / kMostPadding <= sum ? longest : 0;
}

std::vector<char> padded(std::span<const std::string> texts, std::size_t width) {
  std::vector<char> bytes(width * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::ranges::copy(texts[i], bytes.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  return bytes;
}

}  // namespace

void Hdf5Group::fail(std::string_view action, std::string_view path) const {
  throw StorageError(file_, "cannot " + std::string(action) + " " + full_path(path) + ": " +
                                h5::innermost_error());
}

std::string Hdf5Group::full_path(std::string_view path) const {
  if (path.starts_with('/')) return std::string(path);
  if (path.empty() || path == ".") return path_;
  return (path_ == "/" ? "/" : path_ + "/") + std::string(path);
}

Hdf5Group Hdf5Group::group(std::string_view path) {
  const std::string full = full_path(path);
  const Hdf5Kind there = kind(full);
  if (there == Hdf5Kind::Group) return open_group(full);
  if (there != Hdf5Kind::None) {
    throw StorageError(file_, "cannot create group " + full + ": there is a dataset");
  }
  make_parents(full);
  const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  Hdf5Handle made(
      H5Gcreate2(handle_.get(), full.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
  if (made.get() < 0) fail("create group", full);
  return {std::move(made), file_, full, threads_};
}

void Hdf5Group::make_parents(std::string_view path) {
  const std::string full = full_path(path);
  const std::size_t slash = full.rfind('/');
  if (slash == 0 || slash == std::string::npos) return;
  const std::string parent = full.substr(0, slash);
  if (kind(parent) != Hdf5Kind::Group) group(parent);
}

h5::NewDataset Hdf5Group::create_dataset(std::string_view path, std::int64_t type,
                                         std::span<const std::size_t> shape,
                                         const DatasetOptions& options) {
  const std::string full = full_path(path);
  if (exists(full)) throw StorageError(file_, "cannot write " + full + ": it exists already");
  make_parents(full);
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  const Hdf5Handle space(extents.empty() ? H5Screate(H5S_SCALAR)
                                         : H5Screate_simple(static_cast<int>(extents.size()),
                                                            extents.data(), nullptr));
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  const std::size_t element_bytes = H5Tget_size(type);
  constexpr std::size_t kSmall = 4096;
  const int level = std::min(options.deflate, 9);
  const bool deflates = level > 0 && !extents.empty() && count * element_bytes > kSmall;
  if (deflates) {
    h5::set_chunks(creation.get(), shape, element_bytes);
    H5Pset_shuffle(creation.get());
    H5Pset_deflate(creation.get(), static_cast<unsigned>(level));
  }
  h5::NewDataset made{Hdf5Handle(H5Dcreate2(handle_.get(), full.c_str(), type, space.get(),
                                            H5P_DEFAULT, creation.get(), H5P_DEFAULT)),
                      count,
                      {}};
  if (made.dataset.get() < 0) fail("create", full);
  if (!options.units.empty()) set_attribute(full, "units", options.units);
  if (deflates) {
    made.chunks.emplace(made.dataset.get(), creation.get(), shape, element_bytes, level, threads_);
  }
  return made;
}

void Hdf5Group::write_raw(std::string_view path, std::int64_t type, const void* values,
                          std::span<const std::size_t> shape, const DatasetOptions& options) {
  h5::NewDataset made = create_dataset(path, type, shape, options);
  if (made.count == 0) return;
  // Lives until an error is reported: closing anything clears what HDF5 says of it.
  const Hdf5Handle transfer(h5::new_transfer(made.count, type));
  bool written = false;
  if (made.chunks) {
    const std::size_t bytes = made.count * H5Tget_size(type);
    written = made.chunks->append({static_cast<const unsigned char*>(values), bytes}) &&
              made.chunks->finish();
  } else {
    written = H5Dwrite(made.dataset.get(), type, H5S_ALL, H5S_ALL, transfer.get(), values) >= 0;
  }
  if (!written) fail("write", full_path(path));
}

Hdf5Column Hdf5Group::column(std::string_view path, std::size_t count,
                             const DatasetOptions& options) {
  const std::size_t shape[] = {count};
  return column<double>(path, shape, options);
}

template <Hdf5Number T>
Hdf5Column Hdf5Group::column(std::string_view path, std::span<const std::size_t> shape,
                             const DatasetOptions& options) {
  const std::int64_t type = h5::memory_type<T>();
  auto made = std::make_unique<h5::NewDataset>(create_dataset(path, type, shape, options));
  return {std::move(made), type, file_, full_path(path)};
}

Hdf5Column::Hdf5Column(std::unique_ptr<h5::NewDataset> made, std::int64_t type, std::string file,
                       std::string path)
    : made_(std::move(made)), type_(type), file_(std::move(file)), path_(std::move(path)) {}
Hdf5Column::Hdf5Column(Hdf5Column&&) noexcept = default;
Hdf5Column::~Hdf5Column() = default;

template <Hdf5Number T>
void Hdf5Column::append_numbers(std::span<const T> values) {
  if (type_ != h5::memory_type<T>()) {
    throw std::logic_error("Hdf5Column::append: " + path_ + " is of another type");
  }
  if (values.size() > made_->count - taken_) {
    throw std::logic_error("Hdf5Column::append: " + path_ + " is full");
  }
  taken_ += values.size();
  const std::span<const unsigned char> bytes{reinterpret_cast<const unsigned char*>(values.data()),
                                             values.size_bytes()};
  if (made_->chunks) return check(made_->chunks->append(bytes));
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
}

void Hdf5Column::append(std::span<const double> values) { append_numbers(values); }
void Hdf5Column::append(std::span<const float> values) { append_numbers(values); }
void Hdf5Column::append(std::span<const std::int32_t> values) { append_numbers(values); }

void Hdf5Column::finish() {
  if (taken_ != made_->count) {
    throw std::logic_error("Hdf5Column::finish: " + path_ + " is not full");
  }
  if (made_->chunks) return check(made_->chunks->finish());
  if (waiting_.empty()) return;
  const Hdf5Handle transfer(h5::new_transfer(taken_, type_));
  check(H5Dwrite(made_->dataset.get(), type_, H5S_ALL, H5S_ALL, transfer.get(), waiting_.data()) >=
        0);
}

void Hdf5Column::check(bool written) const {
  if (written) return;
  throw StorageError(file_, "cannot write " + path_ + ": " + h5::innermost_error());
}

template <Hdf5Number T>
void Hdf5Group::write(std::string_view path, T value, const DatasetOptions& options) {
  write_raw(path, h5::memory_type<T>(), &value, {}, options);
}

template <Hdf5Number T>
void Hdf5Group::write(std::string_view path, std::span<const T> values,
                      const DatasetOptions& options) {
  const std::size_t shape[] = {values.size()};
  write_raw(path, h5::memory_type<T>(), values.data(), shape, options);
}

template <Hdf5Number T>
void Hdf5Group::write_table(std::string_view path, std::span<const T> values, std::size_t columns,
                            const DatasetOptions& options) {
  if (columns == 0 ? !values.empty() : values.size() % columns != 0) {
    throw std::logic_error("Hdf5Group::write_table: the values do not fill their rows");
  }
  const std::size_t shape[] = {columns == 0 ? 0 : values.size() / columns, columns};
  write_raw(path, h5::memory_type<T>(), values.data(), shape, options);
}

template <Hdf5Number T>
void Hdf5Group::write_array(std::string_view path, std::span<const T> values,
                            std::span<const std::size_t> shape, const DatasetOptions& options) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  if (count != values.size()) {
    throw std::logic_error("Hdf5Group::write_array: the values do not fill their shape");
  }
  write_raw(path, h5::memory_type<T>(), values.data(), shape, options);
}

template <Hdf5Number T>
void Hdf5Group::write_ragged(std::string_view path, const Ragged<T>& rows,
                             const DatasetOptions& options) {
  Hdf5Group into = group(path);
  into.write("values", rows.values, options);
  into.write("offsets", rows.offsets, {{}, options.deflate});
}

void Hdf5Group::write_text(std::string_view path, const std::string& text) {
  check_text(file_, full_path(path), text);
  const Hdf5Handle type(h5::new_text_type());
  const char* const pointer = text.c_str();
  write_raw(path, type.get(), &pointer, {}, {});
}

void Hdf5Group::write_texts(std::string_view path, std::span<const std::string> texts) {
  for (const std::string& text : texts) check_text(file_, full_path(path), text);
  const std::size_t shape[] = {texts.size()};
  if (const std::size_t width = width_of(texts); width > 0) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1));
    H5Tset_size(type.get(), width);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    write_raw(path, type.get(), padded(texts, width).data(), shape, {.units = {}, .deflate = 4});
    return;
  }
  const Hdf5Handle type(h5::new_text_type());
  write_raw(path, type.get(), pointers_to(texts).data(), shape, {});
}

void Hdf5Group::write_attribute(std::string_view path, const std::string& name, std::int64_t type,
                                const void* value, std::int64_t space) {
  const Hdf5Handle object = open_object(path);
  if (H5Aexists(object.get(), name.c_str()) > 0) H5Adelete(object.get(), name.c_str());
  const Hdf5Handle attribute(
      H5Acreate2(object.get(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
  if (attribute.get() < 0 || H5Awrite(attribute.get(), type, value) < 0) {
    fail("write attribute " + name + " of", path);
  }
}

void Hdf5Group::set_attribute(std::string_view path, const std::string& name,
                              std::string_view text) {
  check_text(file_, full_path(path) + "@" + name, text);
  const Hdf5Handle type(h5::new_text_type());
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  const std::string copy(text);
  const char* const pointer = copy.c_str();
  write_attribute(path, name, type.get(), &pointer, space.get());
}

void Hdf5Group::set_attribute(std::string_view path, const std::string& name, double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  write_attribute(path, name, H5T_NATIVE_DOUBLE, &value, space.get());
}

void Hdf5Group::set_attribute(std::string_view path, const std::string& name, std::int64_t value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  write_attribute(path, name, H5T_NATIVE_INT64, &value, space.get());
}

void Hdf5Group::set_attribute(std::string_view path, const std::string& name,
                              std::span<const std::string> texts) {
  for (const std::string& text : texts) check_text(file_, full_path(path) + "@" + name, text);
  const Hdf5Handle type(h5::new_text_type());
  const hsize_t count = texts.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr));
  write_attribute(path, name, type.get(), pointers_to(texts).data(), space.get());
}

void Hdf5Group::set_attribute(std::string_view path, const std::string& name,
                              std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr));
  write_attribute(path, name, H5T_NATIVE_INT64, values.data(), space.get());
}

void Hdf5Group::set_ascii_attribute(std::string_view path, const std::string& name,
                                    const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), text.size());
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  write_attribute(path, name, type.get(), text.data(), space.get());
}

#define PLASTICA_INSTANTIATE(T)                                                                   \
  template void Hdf5Group::write<T>(std::string_view, T, const DatasetOptions&);                  \
  template void Hdf5Group::write<T>(std::string_view, std::span<const T>, const DatasetOptions&); \
  template void Hdf5Group::write_table<T>(std::string_view, std::span<const T>, std::size_t,      \
                                          const DatasetOptions&);                                 \
  template void Hdf5Group::write_array<T>(std::string_view, std::span<const T>,                   \
                                          std::span<const std::size_t>, const DatasetOptions&);   \
  template void Hdf5Group::write_ragged<T>(std::string_view, const Ragged<T>&,                    \
                                           const DatasetOptions&);                                \
  template Hdf5Column Hdf5Group::column<T>(std::string_view, std::span<const std::size_t>,        \
                                           const DatasetOptions&)
PLASTICA_INSTANTIATE(double);
PLASTICA_INSTANTIATE(float);
PLASTICA_INSTANTIATE(std::int32_t);
PLASTICA_INSTANTIATE(std::int64_t);
PLASTICA_INSTANTIATE(std::uint64_t);
PLASTICA_INSTANTIATE(std::uint8_t);
#undef PLASTICA_INSTANTIATE

}  // namespace plastica::io
