#include "plastica/io/hdf5_check.hpp"

#include <algorithm>
#include <limits>

#include "plastica/io/hdf5_handle.hpp"

namespace plastica::io::h5 {
namespace {

/// Deflate makes at most 1032 bytes of one.
constexpr double kMaxDeflated = 1100.0;
/// What an attribute may take: more than any of ours, far less than a machine has.
constexpr double kMaxAttributeBytes = 1 << 20;

/// What is read of a dataset or attribute, as its header claims.
double claimed_bytes(const Hdf5Handle& space, const Hdf5Handle& type) {
  const hssize_t elements = H5Sget_simple_extent_npoints(space.get());
  return static_cast<double>(std::max<hssize_t>(elements, 0)) *
         static_cast<double>(H5Tget_size(type.get()));
}

std::string refusal_of_space(const Hdf5Handle& space) {
  const H5S_class_t sort = H5Sget_simple_extent_type(space.get());
  if (sort != H5S_SCALAR && sort != H5S_SIMPLE) return "has no extents";
  if (H5Sget_simple_extent_ndims(space.get()) > kMaxRank) {
    return "has more than " + std::to_string(kMaxRank) + " dimensions";
  }
  return {};
}

bool has_other_filters(const Hdf5Handle& creation) {
  const int filters = H5Pget_nfilters(creation.get());
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation.get(), static_cast<unsigned>(i), &flags,
                                               &values, nullptr, 0, nullptr, nullptr);
    const bool is_known = filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE ||
                          filter == H5Z_FILTER_FLETCHER32;
    if (!is_known) return true;
  }
  return false;
}

double bytes_of_file(const Hdf5Handle& object) {
  const Hdf5Handle file(H5Iget_file_id(object.get()));
  hsize_t bytes = 0;
  return H5Fget_filesize(file.get(), &bytes) < 0 ? 0.0 : static_cast<double>(bytes);
}

}  // namespace

Link link_at(const Hdf5Handle& location, const std::string& path) {
  H5L_info_t info{};
  if (H5Lget_info(location.get(), path.c_str(), &info, H5P_DEFAULT) < 0) {
    H5Eclear2(H5E_DEFAULT);
    return Link::None;
  }
  return info.type == H5L_TYPE_HARD ? Link::Here : Link::Elsewhere;
}

std::string refusal_of_dataset(const Hdf5Handle& dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset.get()));
  if (H5Pget_layout(creation.get()) == H5D_VIRTUAL || H5Pget_external_count(creation.get()) > 0) {
    return "has its values in another file, which is not followed";
  }
  if (has_other_filters(creation))
    return "is stored with another filter than deflate, shuffle and fletcher32";
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  if (std::string why = refusal_of_space(space); !why.empty()) return why;
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  const double bytes = claimed_bytes(space, type);
  const double stored =
      std::min(static_cast<double>(H5Dget_storage_size(dataset.get())), bytes_of_file(dataset));
  if (bytes > kMaxDeflated * stored) return "claims more values than the file has bytes for";
  return {};
}

std::string refusal_of_attribute(const Hdf5Handle& attribute) {
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  if (std::string why = refusal_of_space(space); !why.empty()) return why;
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  return claimed_bytes(space, type) > kMaxAttributeBytes ? "is larger than attributes of results"
                                                         : "";
}

std::string refusal_of_integers(const Hdf5Handle& type, std::size_t size, bool is_signed) {
  const bool fits =
      H5Tget_size(type.get()) <= size && (H5Tget_sign(type.get()) == H5T_SGN_2) == is_signed;
  if (fits) return {};
  return std::string("does not hold ") + (is_signed ? "signed" : "unsigned") + " integers of " +
         std::to_string(8 * size) + " bits";
}

}  // namespace plastica::io::h5
