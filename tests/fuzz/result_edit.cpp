#include "tests/fuzz/result_edit.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

namespace plastica::fuzz {
namespace {

using io::Hdf5Handle;

/// Bytes of a dataset that a change may make, so that none takes long.
constexpr std::size_t kMostElements = 1 << 12;

struct OpenDataset {
  Hdf5Handle dataset;
  Hdf5Handle type;
  Hdf5Handle space;
  std::vector<hsize_t> shape;

  std::size_t count() const {
    std::size_t product = 1;
    for (const hsize_t extent : shape) product *= static_cast<std::size_t>(extent);
    return product;
  }
  bool is_text() const { return H5Tis_variable_str(type.get()) > 0; }
  /// Of its values as they are read, as the file has them.
  std::size_t bytes() const { return count() * H5Tget_size(type.get()); }
};

/// Empty handles if there is no dataset.
OpenDataset opened(const Hdf5Handle& file, const std::string& path) {
  OpenDataset open{Hdf5Handle(H5Oopen(file.get(), path.c_str(), H5P_DEFAULT)), {}, {}, {}};
  if (open.dataset.get() < 0 || H5Iget_type(open.dataset.get()) != H5I_DATASET) return {};
  open.type = Hdf5Handle(H5Dget_type(open.dataset.get()));
  open.space = Hdf5Handle(H5Dget_space(open.dataset.get()));
  open.shape.resize(
      static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(open.space.get()), 0)));
  H5Sget_simple_extent_dims(open.space.get(), open.shape.data(), nullptr);
  if (open.count() > kMostElements) return {};
  return open;
}

bool is_open(const OpenDataset& open) { return open.dataset.get() >= 0; }

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), H5T_VARIABLE);
  return type;
}

/// The types that a dataset or an attribute is given.
Hdf5Handle type_at(std::size_t number) {
  switch (number % 8) {
    case 0: return Hdf5Handle(H5Tcopy(H5T_NATIVE_DOUBLE));
    case 1: return Hdf5Handle(H5Tcopy(H5T_NATIVE_INT64));
    case 2: return Hdf5Handle(H5Tcopy(H5T_NATIVE_UINT64));
    case 3: return Hdf5Handle(H5Tcopy(H5T_NATIVE_UINT8));
    case 4: return Hdf5Handle(H5Tcopy(H5T_NATIVE_INT32));
    case 5: return Hdf5Handle(H5Tcopy(H5T_NATIVE_FLOAT));
    case 6: return Hdf5Handle(H5Tcopy(H5T_STD_I32BE));
    default: return text_type();
  }
}

/// Puts an empty dataset of a type and shape where one is.
Hdf5Handle replaced(const Hdf5Handle& file, const std::string& path, const Hdf5Handle& type,
                    const std::vector<hsize_t>& shape) {
  H5Ldelete(file.get(), path.c_str(), H5P_DEFAULT);
  const Hdf5Handle space(
      shape.empty() ? H5Screate(H5S_SCALAR)
                    : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  return Hdf5Handle(H5Dcreate2(file.get(), path.c_str(), type.get(), space.get(), H5P_DEFAULT,
                               H5P_DEFAULT, H5P_DEFAULT));
}

/// Texts of a dataset while they are changed: HDF5 has made them, and takes them back.
template <typename Change>
void with_texts(const OpenDataset& open, const Change& change) {
  std::vector<char*> texts(open.count(), nullptr);
  if (H5Dread(open.dataset.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) <
      0) {
    return;
  }
  std::vector<const char*> changed(texts.begin(), texts.end());
  change(changed);
  H5Dvlen_reclaim(open.type.get(), open.space.get(), H5P_DEFAULT, texts.data());
}

}  // namespace

ResultEdit::ResultEdit(const std::string& path) {
  io::hdf5_version();  // from here on HDF5 keeps its errors to itself
  file_ = io::Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
  require(file_.get() >= 0, "a base that HDF5 does not open");
  const auto take = [](hid_t, const char* name, const H5O_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  H5Ovisit(file_.get(), H5_INDEX_NAME, H5_ITER_INC, take, &paths_);
}

void ResultEdit::apply(std::size_t object, std::size_t kind, Bytes payload) {
  const std::string path = "/" + paths_[object % paths_.size()];
  const ByteSource source(payload);
  switch (kind % 8) {
    case 0:
    case 1: set_values(path, source); break;
    case 2: set_text(path, source); break;
    case 3: set_extent(path, source); break;
    case 4: set_type(path, source); break;
    case 5: set_attribute(path, source); break;
    case 6: link_to_another(path, source); break;
    default: remove(path);
  }
}

/// From a place on, in two bytes, numbers are the bytes that follow.
void ResultEdit::set_values(const std::string& path, ByteSource payload) {
  const OpenDataset open = opened(file_, path);
  if (!is_open(open) || open.is_text() || open.bytes() == 0) return;
  std::vector<std::uint8_t> values(open.bytes());
  const auto transfer = [&](const auto& call) {
    return call(open.dataset.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  };
  if (transfer(H5Dread) < 0) return;
  const std::size_t place = payload.number(2) % values.size();
  const Bytes patch = payload.piece(values.size() - place);
  std::ranges::copy(patch, values.begin() + static_cast<std::ptrdiff_t>(place));
  transfer(H5Dwrite);
}

/// One of the texts, by its number in a byte, is the rest.
void ResultEdit::set_text(const std::string& path, ByteSource payload) {
  const OpenDataset open = opened(file_, path);
  if (!is_open(open) || !open.is_text() || open.count() == 0) return;
  const std::size_t number = payload.byte() % open.count();
  const std::string text(text_of(payload.piece(~std::size_t{0})));
  with_texts(open, [&](std::vector<const char*>& texts) {
    texts[number] = text.c_str();
    H5Dwrite(open.dataset.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data());
  });
}

/// Extents are the bytes that follow, as many as there are; values repeat.
void ResultEdit::set_extent(const std::string& path, ByteSource payload) {
  const OpenDataset open = opened(file_, path);
  if (!is_open(open)) return;
  std::vector<hsize_t> shape;
  while (!payload.is_empty() && shape.size() < 3) shape.push_back(payload.byte() % 20);
  OpenDataset other{{}, {}, {}, shape};
  const std::size_t count = other.count();
  const std::size_t size = H5Tget_size(open.type.get());
  if (open.is_text()) {
    with_texts(open, [&](std::vector<const char*>& texts) {
      std::vector<const char*> repeated(count, "");
      for (std::size_t i = 0; i < count && !texts.empty(); ++i)
        repeated[i] = texts[i % texts.size()];
      const Hdf5Handle made = replaced(file_, path, open.type, shape);
      H5Dwrite(made.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, repeated.data());
    });
    return;
  }
  std::vector<std::uint8_t> values(open.bytes());
  if (values.empty() || H5Dread(open.dataset.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                values.data()) < 0) {
    return;
  }
  std::vector<std::uint8_t> repeated(count * size);
  for (std::size_t i = 0; i < repeated.size(); ++i) repeated[i] = values[i % values.size()];
  const Hdf5Handle made = replaced(file_, path, open.type, shape);
  H5Dwrite(made.get(), open.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, repeated.data());
}

/// Another type, by its number in a byte; numbers stay what they are as far as it can hold them.
void ResultEdit::set_type(const std::string& path, ByteSource payload) {
  const OpenDataset open = opened(file_, path);
  if (!is_open(open)) return;
  const Hdf5Handle type = type_at(payload.byte());
  const bool to_text = H5Tis_variable_str(type.get()) > 0;
  std::vector<std::uint8_t> values(std::max<std::size_t>(open.count(), 1) * sizeof(double));
  const bool kept =
      !open.is_text() && !to_text &&
      H5Dread(open.dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
  const Hdf5Handle made = replaced(file_, path, type, open.shape);
  if (kept) {
    H5Dwrite(made.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
}

/// An attribute, by its number in a byte, gets another type, in one; and its value is the rest, or
/// it is gone.
void ResultEdit::set_attribute(const std::string& path, ByteSource payload) {
  const Hdf5Handle object(H5Oopen(file_.get(), path.c_str(), H5P_DEFAULT));
  H5O_info_t info{};
  if (object.get() < 0 || H5Oget_info2(object.get(), &info, H5O_INFO_NUM_ATTRS) < 0 ||
      info.num_attrs == 0) {
    return;
  }
  std::array<char, 64> name{};
  H5Aget_name_by_idx(object.get(), ".", H5_INDEX_NAME, H5_ITER_INC, payload.byte() % info.num_attrs,
                     name.data(), name.size(), H5P_DEFAULT);
  const std::size_t sort = payload.byte();
  H5Adelete(object.get(), name.data());
  if (sort % 9 == 8) return;
  const Hdf5Handle type = type_at(sort % 9);
  // A single value, a list of one, or, of numbers, of several.
  const hsize_t count = sort >= 128 ? 2 : 1;
  const Hdf5Handle space(sort >= 64 ? H5Screate_simple(1, &count, nullptr) : H5Screate(H5S_SCALAR));
  const Hdf5Handle made(
      H5Acreate2(object.get(), name.data(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  const std::string text(text_of(payload.piece(~std::size_t{0})));
  std::array<std::uint8_t, 2 * sizeof(double)> values{};
  std::copy_n(text.begin(), std::min(text.size(), values.size()), values.begin());
  const std::array<const char*, 2> texts{text.c_str(), text.c_str()};
  const bool is_text = H5Tis_variable_str(type.get()) > 0;
  H5Awrite(made.get(), type.get(),
           is_text ? static_cast<const void*>(texts.data()) : values.data());
}

/// Its name leads to another object, by that one's number in two bytes: of another kind, or a group
/// that it is in.
void ResultEdit::link_to_another(const std::string& path, ByteSource payload) {
  const std::string other = "/" + paths_[payload.number(2) % paths_.size()];
  if (path == "/." || other == path || other.starts_with(path + "/")) return;
  H5Ldelete(file_.get(), path.c_str(), H5P_DEFAULT);
  H5Lcreate_hard(file_.get(), other.c_str(), file_.get(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
}

void ResultEdit::remove(const std::string& path) {
  if (path != "/.") H5Ldelete(file_.get(), path.c_str(), H5P_DEFAULT);
}

}  // namespace plastica::fuzz
