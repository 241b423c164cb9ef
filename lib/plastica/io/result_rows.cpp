#include "plastica/io/result_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plastica::io {
namespace {

bool is_column(const Hdf5Group& root, const std::string& path, Hdf5Kind kind, std::size_t rows) {
  return root.kind(path) == kind && root.shape(path) == std::vector{rows};
}

std::string parent_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == 0 || slash == std::string::npos ? "" : path.substr(0, slash);
}

}  // namespace

ResultRows::ResultRows(const Hdf5Group& root, const std::string& path) {
  const std::string group = parent_of(path);
  const std::vector<std::size_t> shape = root.shape(path);
  if (shape.empty()) return;
  const std::string offsets = group + "/offsets";
  const bool ragged = path != offsets && root.kind(offsets) == Hdf5Kind::Integer;
  if (ragged) offsets_ = root.read<std::uint64_t>(offsets);
  find_names(root, group, ragged && !offsets_.empty() ? offsets_.size() - 1 : shape.front());
}

void ResultRows::find_names(const Hdf5Group& root, const std::string& group, std::size_t rows) {
  for (std::string at = group; names_.empty(); at = parent_of(at)) {
    take_names(root, at, rows);
    if (names_.empty()) take_axes(root, at, rows);
    if (names_.empty()) take_fits(root, at, rows);
    if (at.empty()) break;
  }
  // Tables of all fits, which have no names of their own.
  for (const char* of_fits : {"/parameters/", "/characteristics", "/correlation", "/curves",
                              "/evaluations", "/held_out", "/free"}) {
    if (names_.empty() && group.starts_with(of_fits)) take_names(root, "/fits", rows);
  }
}

void ResultRows::take_names(const Hdf5Group& root, const std::string& group, std::size_t rows) {
  if (!is_column(root, group + "/name", Hdf5Kind::Text, rows)) return;
  names_ = root.read_texts(group + "/name");
  if (!is_column(root, group + "/law", Hdf5Kind::Text, rows)) return;
  const std::vector<std::string> laws = root.read_texts(group + "/law");
  const bool compared = std::adjacent_find(names_.begin(), names_.end()) != names_.end();
  for (std::size_t i = 0; compared && i < rows; ++i) names_[i] += ":" + laws[i];
}

void ResultRows::take_axes(const Hdf5Group& root, const std::string& group, std::size_t rows) {
  const std::string axes = group + "/axes";
  if (root.kind(axes) != Hdf5Kind::Group) return;
  std::vector<std::string> names(rows);
  for (const std::string& axis : root.open_group(axes).children()) {
    const std::string path = fmt::format("{}/{}", axes, axis);
    const bool words = is_column(root, path, Hdf5Kind::Text, rows);
    if (!words && !is_column(root, path, Hdf5Kind::Real, rows)) return;
    const auto texts = words ? root.read_texts(path) : std::vector<std::string>{};
    const auto values = words ? std::vector<double>{} : root.read<double>(path);
    for (std::size_t i = 0; i < rows; ++i) {
      names[i] += fmt::format("{}{} = {}", names[i].empty() ? "" : ", ", axis,
                              words ? texts[i] : fmt::format("{:.6g}", values[i]));
    }
  }
  names_ = std::move(names);
}

void ResultRows::take_fits(const Hdf5Group& root, const std::string& group, std::size_t rows) {
  const bool names_fits = is_column(root, group + "/fit", Hdf5Kind::Integer, rows) &&
                          root.kind("/fits/name") == Hdf5Kind::Text;
  if (!names_fits) return;
  const std::vector<std::string> fits = root.read_texts("/fits/name");
  const std::vector<double> fit = root.read<double>(group + "/fit");
  for (std::size_t i = 0; i < rows; ++i) {
    const bool known = fit[i] >= 0.0 && fit[i] < static_cast<double>(fits.size());
    names_.push_back(
        fmt::format("{} [{}]", known ? fits[static_cast<std::size_t>(fit[i])] : "?", i));
  }
}

std::string ResultRows::name(std::size_t at, const std::vector<std::size_t>& shape) const {
  if (shape.empty()) return "";
  std::vector<std::size_t> index(shape.size());
  for (std::size_t k = shape.size(); k-- > 0;) {
    index[k] = at % shape[k];
    at /= shape[k];
  }
  std::size_t row = index.front();
  bool within = false;  // a list of its own
  if (!offsets_.empty()) {
    const auto after = std::upper_bound(offsets_.begin(), offsets_.end(), index.front());
    if (after != offsets_.begin() && after != offsets_.end()) {
      row = static_cast<std::size_t>(after - offsets_.begin()) - 1;
      index.front() -= offsets_[row];
      within = true;
    }
  }
  if (row >= names_.size()) {
    if (within) return fmt::format("row {} [{}]", row, fmt::join(index, ", "));
    return fmt::format("[{}]", fmt::join(index, ", "));
  }
  if (!within) index.erase(index.begin());
  return index.empty() ? names_[row] : fmt::format("{} [{}]", names_[row], fmt::join(index, ", "));
}

}  // namespace plastica::io
