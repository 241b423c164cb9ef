#include <algorithm>
#include <stdexcept>
#include <utility>

#include "plastica/base/parallel_for.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_handle.hpp"

namespace plastica::io {
namespace {

/// The system's words, where an error of HDF5 has them among addresses and times.
std::string words_of_system(const std::string& message) {
  constexpr std::string_view kBefore = "error message = '";
  const std::size_t at = message.find(kBefore);
  if (at == std::string::npos) return message;
  const std::size_t begin = at + kBefore.size();
  return message.substr(begin, message.find('\'', begin) - begin);
}

Hdf5Handle opened_root(const Hdf5Handle& file, const std::string& path) {
  Hdf5Handle root(H5Gopen2(file.get(), "/", H5P_DEFAULT));
  if (root.get() < 0) throw StorageError(path, "cannot open /: " + h5::innermost_error());
  return root;
}

}  // namespace

std::string hdf5_version() {
  h5::keep_quiet();  // also this call would start HDF5, as it is by default
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  if (H5get_libversion(&major, &minor, &release) < 0) {
    throw StorageError("HDF5", "does not say its version: " + h5::innermost_error());
  }
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(release);
}

Hdf5Handle::~Hdf5Handle() {
  if (id_ >= 0) H5Idec_ref(id_);
}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  if (this != &other) {
    if (id_ >= 0) H5Idec_ref(id_);
    id_ = other.release();
  }
  return *this;
}

Hdf5File::Hdf5File(Hdf5Handle file, Hdf5Group root, std::optional<OutputFile> output)
    : output_(std::move(output)), file_(std::move(file)), root_(std::move(root)) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : output_(std::exchange(other.output_, std::nullopt)),
      file_(std::move(other.file_)),
      root_(std::move(other.root_)) {}

Hdf5File Hdf5File::create(const std::string& path, Overwrite overwrite, int threads) {
  h5::keep_quiet();
  OutputFile output(path, overwrite);

  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_userblock(creation.get(), kContentOffset);
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
  // Closing the file closes all that is open in it, so that commit leaves nothing half written.
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  Hdf5Handle file(H5Fcreate(output.part().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()));
  if (file.get() < 0) throw StorageError(path, "cannot be written: " + h5::innermost_error());
  // Where a result is written that was read, the number is that of another machine.
  const int used = std::min(resolved_threads(threads), resolved_threads(0));
  Hdf5Group root(opened_root(file, path), path, "/", used);
  return {std::move(file), std::move(root), std::move(output)};
}

Hdf5File Hdf5File::open(const std::string& path) {
  h5::keep_quiet();
  check_content_digest(path);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
  if (file.get() < 0) {
    throw InputError({path, 0}, "", "", "is damaged: " + h5::innermost_error());
  }
  Hdf5Group root(opened_root(file, path), path, "/");
  return {std::move(file), std::move(root), std::nullopt};
}

Hdf5File::~Hdf5File() {
  root_.handle_ = {};
  file_ = {};
}

void Hdf5File::commit() {
  if (!output_) throw std::logic_error("Hdf5File::commit: nothing to commit");
  OutputFile output = *std::exchange(output_, std::nullopt);
  root_.handle_ = {};
  if (H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) < 0 || H5Fclose(file_.release()) < 0) {
    const std::string reason = "cannot be written: " + h5::innermost_error();
    file_ = {};
    throw StorageError(output.path(), reason);
  }
  write_content_digest(output.descriptor(), output.path());
  output.commit();
}

namespace h5 {

void keep_quiet() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string innermost_error() {
  std::string message;
  const auto take_first = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    *static_cast<std::string*>(out) = error->desc != nullptr ? error->desc : "";
    return 1;  // stops the iteration
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &message);
  H5Eclear2(H5E_DEFAULT);
  return message.empty() ? "HDF5 gives no reason" : words_of_system(message);
}

hid_t new_text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

hid_t new_transfer(std::size_t count, hid_t type) {
  constexpr std::size_t kDefaultBytes = std::size_t{1} << 20U;
  // In the file a text of variable length is its length, an address of 8 bytes and an index: more
  // than any number takes.
  constexpr std::size_t kStoredTextBytes = 16;
  const std::size_t bytes = std::max(H5Tget_size(type), kStoredTextBytes);
  const hid_t transfer = H5Pcreate(H5P_DATASET_XFER);
  if (count > 0 && count < kDefaultBytes / bytes)
    H5Pset_buffer(transfer, count * bytes, nullptr, nullptr);
  return transfer;
}

}  // namespace h5
}  // namespace plastica::io
