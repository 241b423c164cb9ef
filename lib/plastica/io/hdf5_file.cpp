#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "plastica/io/durable_file.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_handle.hpp"

namespace plastica::io {
namespace {

std::string system_error(std::string_view action) {
  return std::string(action) + ": " + std::strerror(errno);
}

/// HDF5 prints its errors by itself unless told otherwise. At the program's end it closes once more
/// what is open, and crashes on a file that a full disk kept it from closing; ours are closed by
/// then.
void keep_quiet() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

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
  keep_quiet();  // also this call would start HDF5, as it is by default
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

Hdf5File::Hdf5File(Hdf5Handle file, Hdf5Group root, std::string path, std::string part)
    : file_(std::move(file)),
      root_(std::move(root)),
      path_(std::move(path)),
      part_(std::move(part)) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : file_(std::move(other.file_)),
      root_(std::move(other.root_)),
      path_(std::move(other.path_)),
      part_(std::exchange(other.part_, {})) {}

Hdf5File Hdf5File::create(const std::string& path) {
  keep_quiet();
  const std::string part = path + ".part";
  // The system's words for a folder that is missing or closed are plainer than HDF5's.
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw StorageError(path, system_error("cannot be written"));
  ::close(descriptor);

  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
  // Closing the file closes all that is open in it, so that commit leaves nothing half written.
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  Hdf5Handle file(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()));
  if (file.get() < 0) {
    const std::string reason = "cannot be written: " + h5::innermost_error();
    ::unlink(part.c_str());
    throw StorageError(path, reason);
  }
  Hdf5Group root(opened_root(file, path), path, "/");
  return {std::move(file), std::move(root), path, part};
}

Hdf5File Hdf5File::open(const std::string& path) {
  keep_quiet();
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw InputError({path, 0}, "", "", system_error("cannot be read"));
  ::close(descriptor);
  if (H5Fis_hdf5(path.c_str()) <= 0) throw InputError({path, 0}, "", "", "is not an HDF5 file");
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
  if (file.get() < 0) {
    throw InputError({path, 0}, "", "", "is damaged: " + h5::innermost_error());
  }
  Hdf5Group root(opened_root(file, path), path, "/");
  return {std::move(file), std::move(root), path, {}};
}

Hdf5File::~Hdf5File() {
  root_.handle_ = {};
  file_ = {};
  discard();
}

void Hdf5File::discard() noexcept {
  if (!part_.empty()) ::unlink(part_.c_str());
  part_.clear();
}

void Hdf5File::commit() {
  if (part_.empty()) throw std::logic_error("Hdf5File::commit: nothing to commit");
  root_.handle_ = {};
  if (H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) < 0 || H5Fclose(file_.release()) < 0) {
    const std::string reason = "cannot be written: " + h5::innermost_error();
    file_ = {};
    discard();
    throw StorageError(path_, reason);
  }
  try {
    sync_to_disk(part_);
    move_into_place(part_, path_);
  } catch (...) {
    discard();
    throw;
  }
  part_.clear();
}

namespace h5 {

std::string innermost_error() {
  std::string message;
  const auto take_first = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    *static_cast<std::string*>(out) = error->desc != nullptr ? error->desc : "";
    return 1;  // stops the walk
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

}  // namespace h5
}  // namespace plastica::io
