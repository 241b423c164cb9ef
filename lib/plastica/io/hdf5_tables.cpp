#include "plastica/io/hdf5_tables.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <set>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/base/listed.hpp"
#include "plastica/base/star_pattern.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/csv_number.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/hdf5_columns.hpp"
#include "plastica/io/hdf5_handle.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

/// Groups within groups that are looked through.
constexpr std::size_t kMostDepth = 32;

/// HDF5 is not reentrant, and is asked by whoever imports side by side. Results are read and
/// written before and after that.
class Hdf5Lock {
 public:
  Hdf5Lock() : lock_(mutex()) { h5::keep_quiet(); }

 private:
  static std::mutex& mutex() {
    static std::mutex of_all;
    return of_all;
  }
  std::scoped_lock<std::mutex> lock_;
};

/// A unit without blanks and brackets around it.
std::string bare_unit(const std::string& text) {
  std::string_view unit = csv_text::without_blanks(text);
  const bool is_in_brackets = unit.size() > 2 && ((unit.front() == '[' && unit.back() == ']') ||
                                                  (unit.front() == '(' && unit.back() == ')'));
  if (is_in_brackets) unit = csv_text::without_blanks(unit.substr(1, unit.size() - 2));
  return std::string(unit);
}

/// A column as a line of names has it. A unit that its name says, too, stands there once.
std::string header_of(const h5::Column& column, const h5::Place& place) {
  const std::string unit = bare_unit(column.unit);
  if (unit.empty()) return column.name;
  const std::string by_name = csv_text::name_and_unit(column.name).second;
  if (by_name == unit) return column.name;
  if (by_name.empty() || !csv_text::unit_cell(by_name).is_unit) {
    return column.name + " [" + unit + "]";
  }
  (place / column.name)
      .refuse("is in " + by_name + " by its name and in " + unit + " by its attribute");
}

void check_lengths(const std::vector<h5::Column>& columns, const h5::Place& place) {
  for (const h5::Column& column : columns) {
    if (column.size() == columns.front().size()) continue;
    place.refuse("has columns of unlike lengths: " + columns.front().name + " " +
                 std::to_string(columns.front().size()) + ", " + column.name + " " +
                 std::to_string(column.size()));
  }
}

std::vector<Hdf5TableColumn> with_headers(std::vector<h5::Column> columns, const h5::Place& place) {
  std::vector<Hdf5TableColumn> out;
  out.reserve(columns.size());
  for (h5::Column& column : columns) {
    out.push_back({header_of(column, place), std::move(column.numbers), std::move(column.texts)});
  }
  return out;
}

h5::Place place_of(const std::string& file, const std::string& name) {
  return {file, name == "/" ? name : "/" + name};
}

Hdf5Handle object_at(const Hdf5File& file, const h5::Place& place) {
  Hdf5Handle object(H5Oopen(file.identifier(), place.path.c_str(), H5P_DEFAULT));
  if (object.get() < 0) place.fail();
  return object;
}

/// Whether a file says what result it is.
bool has_schema(const Hdf5File& file) {
  const Hdf5Group& root = file.root();
  return root.has_attribute(".", "schema") &&
         root.attribute_kind(".", "schema") == Hdf5Kind::Text &&
         root.text_attribute(".", "schema").starts_with("plastica");
}

}  // namespace

Hdf5Origin hdf5_origin(const std::string& path) {
  if (!begins_as_result(path)) return Hdf5Origin::None;
  if (begins_with_digest(path)) return Hdf5Origin::Results;
  const Hdf5Lock lock;
  try {
    return has_schema(Hdf5File::open(path)) ? Hdf5Origin::Results : Hdf5Origin::Others;
  } catch (const InputError&) {  // whoever reads it says so
    return Hdf5Origin::Unknown;
  } catch (const StorageError&) {
    return Hdf5Origin::Unknown;
  }
}

/// What is open of a file.
struct Hdf5Tables::Opened {
  Hdf5File file;
  std::set<haddr_t> known{};  ///< groups that were looked into: a hard link may lead back
};

Hdf5Tables::Hdf5Tables(const std::string& path) : path_(path) {
  const Hdf5Lock lock;
  try {
    opened_ = std::make_unique<Opened>(Opened{Hdf5File::open(path)});
    if (has_schema(opened_->file)) {
      throw InputError({path_, 0}, "", "", "is a result file, no file of measured curves");
    }
    find_in("/", 0);
    if (names_.empty()) {
      throw InputError(
          {path_, 0}, "", "",
          "holds no table: no group with two columns of numbers, no dataset of records, "
          "none of two dimensions");
    }
  } catch (...) {
    opened_.reset();  // before the lock is
    throw;
  }
}

Hdf5Tables::~Hdf5Tables() {
  const Hdf5Lock lock;
  opened_.reset();
}

void Hdf5Tables::find_in(const std::string& name, std::size_t depth) {
  const h5::Place place = place_of(path_, name);
  const Hdf5Handle group(H5Gopen2(opened_->file.identifier(), place.path.c_str(), H5P_DEFAULT));
  H5O_info_t info{};
  if (group.get() < 0 || H5Oget_info(group.get(), &info) < 0) place.fail();
  if (!opened_->known.insert(info.addr).second) return;
  if (depth > kMostDepth) {
    place.refuse("lies within more than " + std::to_string(kMostDepth) + " groups");
  }
  std::size_t columns = 0;
  std::vector<std::pair<std::string, bool>> others;  // groups, and tables by themselves
  for (const std::string& child : h5::names_in(group, place)) {
    const Hdf5Handle object = h5::opened(group, child, place);
    const bool is_group = h5::is_group(object);
    if (is_group || h5::is_table(object)) others.emplace_back(child, is_group);
    if (h5::is_column_of_numbers(object)) ++columns;
    if (!is_utf8(child)) place.refuse("holds a name that is not UTF-8 text");
  }
  if (columns >= 2) names_.push_back(name);
  for (const auto& [child, is_group] : others) {
    std::string whole = name == "/" ? "" : name + '/';
    whole += child;
    if (is_group) {
      find_in(whole, depth + 1);
    } else {
      names_.push_back(whole);
    }
  }
}

std::vector<std::string> Hdf5Tables::matching(const std::optional<std::string>& pattern) const {
  if (!pattern) return names_;
  std::vector<std::string> found;
  std::ranges::copy_if(names_, std::back_inserter(found), [&](const std::string& name) {
    return matches_stars(*pattern, name) || (name != "/" && matches_stars(*pattern, "/" + name));
  });
  if (!found.empty()) return found;
  throw InputError({path_, 0}, "path", *pattern,
                   "matches none of its tables: " + listed(names_, 8));
}

std::vector<Hdf5TableColumn> Hdf5Tables::columns(const std::string& name) const {
  const h5::Place place = place_of(path_, name);
  std::vector<h5::Column> columns;
  {
    const Hdf5Lock lock;
    columns = h5::columns_of(object_at(opened_->file, place), place);
  }
  check_lengths(columns, place);
  return with_headers(std::move(columns), place);
}

Hdf5Tables::Text Hdf5Tables::text_of(const std::vector<Hdf5TableColumn>& columns) {
  Text text;
  const auto add_row = [&](const auto& cell_of) {
    for (const Hdf5TableColumn& column : columns) {
      if (&column != columns.data()) text.text += '\t';
      text.text += cell_of(column);
    }
    text.text += '\n';
  };
  text.has_header = std::ranges::any_of(
      columns, [](const Hdf5TableColumn& column) { return !column.header.empty(); });
  if (text.has_header) {
    add_row([](const Hdf5TableColumn& column) { return csv_text::tabbed_cell(column.header); });
  }
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    add_row([&](const Hdf5TableColumn& column) {
      return column.has_texts() ? csv_text::tabbed_cell(column.texts[row])
                                : csv_text::number_text(column.numbers[row]);
    });
  }
  return text;
}

std::vector<Hdf5TableColumn> Hdf5Tables::properties(const std::string& name) const {
  std::vector<h5::Column> properties;
  const Hdf5Lock lock;
  // From the table up to the file.
  for (h5::Place place = place_of(path_, name);; place = place.above()) {
    for (h5::Column& property : h5::properties_of(object_at(opened_->file, place), place)) {
      const auto is_same = [&](const h5::Column& other) {
        return csv_text::name_and_unit(other.name).first ==
               csv_text::name_and_unit(property.name).first;
      };
      if (std::ranges::none_of(properties, is_same)) properties.push_back(std::move(property));
    }
    if (place.path == "/") break;
  }
  return with_headers(std::move(properties), place_of(path_, name));
}

}  // namespace plastica::io
