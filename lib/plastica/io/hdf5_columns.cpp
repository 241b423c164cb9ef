#include "plastica/io/hdf5_columns.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "plastica/io/hdf5_check.hpp"
#include "plastica/io/hdf5_packing.hpp"
#include "plastica/io/hdf5_strings.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io::h5 {
namespace {

enum class Sort { Number, Text, Records, Other };

Sort sort_of(const Hdf5Handle& type) {
  switch (H5Tget_class(type.get())) {
    case H5T_FLOAT:
    case H5T_INTEGER: return Sort::Number;
    case H5T_STRING: return Sort::Text;
    case H5T_COMPOUND: return Sort::Records;
    default: return Sort::Other;
  }
}

bool is_dataset(const Hdf5Handle& object) {
  return object.get() >= 0 && H5Iget_type(object.get()) == H5I_DATASET;
}

std::vector<hsize_t> extents_of(const Hdf5Handle& dataset) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  const int rank = std::max(H5Sget_simple_extent_ndims(space.get()), 0);
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  if (rank > 0) H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr);
  return extents;
}

/// Attribute of the names of columns.
constexpr const char* kColumns = "columns";
/// Attributes of their units, whichever is there.
constexpr std::array<const char*, 4> kUnits{"units", "unit", "Units", "Unit"};

/// Units that an object says of its columns, one for each; empty where it says none.
std::vector<std::string> units_of(const Hdf5Handle& object, std::size_t columns,
                                  const Place& place) {
  for (const char* name : kUnits) {
    std::vector<std::string> units = texts_of_attribute(object, name, place);
    if (units.empty()) continue;
    if (units.size() == columns) return units;
    (place / name)
        .refuse("has " + std::to_string(units.size()) + " units, of " + std::to_string(columns) +
                (columns == 1 ? " column" : " columns"));
  }
  return std::vector<std::string>(columns);
}

/// Most columns of a table of two dimensions that does not name them: more are an image.
constexpr hsize_t kMostUnnamed = 16;
/// Most columns of a table.
constexpr hsize_t kMostColumns = 10'000;

/// Whether all values of a dataset were written, or at least all of its chunks.
bool is_written(const Hdf5Handle& dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset.get()));
  if (H5Pget_layout(creation.get()) != H5D_CHUNKED) {
    H5D_space_status_t status{};
    return H5Dget_space_status(dataset.get(), &status) >= 0 && status == H5D_SPACE_STATUS_ALLOCATED;
  }
  const std::vector<hsize_t> extents = extents_of(dataset);
  std::vector<hsize_t> chunk(extents.size());
  hsize_t wanted = 1, found = 0;
  if (H5Pget_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data()) < 0) return false;
  for (std::size_t i = 0; i < chunk.size(); ++i) wanted *= (extents[i] + chunk[i] - 1) / chunk[i];
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  return H5Dget_num_chunks(dataset.get(), space.get(), &found) >= 0 && found == wanted;
}

/// @throws InputError for what is not to be read: not in this file, never written, or too large
Hdf5Handle checked(Hdf5Handle dataset, const Place& place) {
  if (const std::string why = refusal_of_dataset(dataset); !why.empty()) place.refuse(why);
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  // As text, a number takes some 20 bytes.
  constexpr std::size_t kMostValues = kMaxTableBytes / 20;
  if (count_of(space) > kMostValues) {
    place.refuse("has more than " + std::to_string(kMostValues) + " values");
  }
  if (count_of(space) > 0 && !is_written(dataset)) {
    place.refuse("has values that were never written");
  }
  return dataset;
}

/// Reads all elements. The buffer of a conversion holds whole elements of the file, records too.
/// @throws InputError
void read_all(const Hdf5Handle& dataset, hid_t memory, void* out, const Place& place) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  const Hdf5Handle stored(H5Dget_type(dataset.get()));
  const bool is_larger = H5Tget_size(stored.get()) > H5Tget_size(memory);
  const Hdf5Handle transfer(new_transfer(count_of(space), is_larger ? stored.get() : memory));
  if (H5Dread(dataset.get(), memory, H5S_ALL, H5S_ALL, transfer.get(), out) < 0) place.fail();
}

/// @param as_memory  makes of the type of one value what is asked for in memory
template <typename Number, typename AsMemory>
std::vector<Number> numbers_of(const Hdf5Handle& dataset, const AsMemory& as_memory,
                               const Place& place) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  const Hdf5Handle memory = as_memory(memory_type<Number>());
  std::vector<Number> values(count_of(space));
  if (!values.empty()) read_all(dataset, memory.get(), values.data(), place);
  return values;
}

template <typename AsMemory>
std::vector<std::string> texts_of(const Hdf5Handle& dataset, const Hdf5Handle& type,
                                  const AsMemory& as_memory, const Place& place) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t text, void* out) {
    const Hdf5Handle memory = as_memory(text);
    read_all(dataset, memory.get(), out, place);
    return true;
  };
  read_strings(type, space, read, texts);
  return texts;
}

/// Whole numbers as their digits: a real number has no more than 16, and others stand for keys.
template <typename Integer>
std::vector<std::string> digits_of(const std::vector<Integer>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const Integer value : values) texts.push_back(std::to_string(value));
  return texts;
}

/// All values of a dataset, or of a field of its records.
/// @param type  of one value, in the file
template <typename AsMemory>
void fill(const Hdf5Handle& dataset, const Hdf5Handle& type, const AsMemory& as_memory,
          const Place& place, Column& column) {
  if (sort_of(type) == Sort::Text) {
    column.texts = texts_of(dataset, type, as_memory, place);
  } else if (H5Tget_class(type.get()) == H5T_FLOAT) {
    column.numbers = numbers_of<double>(dataset, as_memory, place);
  } else if (H5Tget_sign(type.get()) == H5T_SGN_NONE) {
    column.texts = digits_of(numbers_of<std::uint64_t>(dataset, as_memory, place));
  } else {
    column.texts = digits_of(numbers_of<std::int64_t>(dataset, as_memory, place));
  }
}

/// The type of records in memory that have one field alone.
Hdf5Handle record_of(const std::string& field, hid_t type) {
  Hdf5Handle record(H5Tcreate(H5T_COMPOUND, H5Tget_size(type)));
  H5Tinsert(record.get(), field.c_str(), 0, type);
  return record;
}

/// All values of a dataset.
Column column_of(const Hdf5Handle& dataset, const std::string& name, const Place& place) {
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  Column column{name, units_of(dataset, 1, place).front(), {}, {}};
  fill(
      dataset, type, [](hid_t value) { return Hdf5Handle(H5Tcopy(value)); }, place, column);
  unpack(dataset, place, column);
  return column;
}

/// A dataset of one value beside longer ones is none of the columns.
std::vector<Column> columns_of_group(const Hdf5Handle& group, const Place& place) {
  std::vector<Column> columns;
  for (const std::string& name : names_in(group, place)) {
    Hdf5Handle object = opened(group, name, place);
    if (!is_column(object)) continue;
    const Place at = place / name;
    columns.push_back(column_of(checked(std::move(object), at), name, at));
  }
  const auto is_one = [](const Column& column) { return column.size() == 1; };
  if (!std::ranges::all_of(columns, is_one)) std::erase_if(columns, is_one);
  return columns;
}

/// Indices of the fields of records that are numbers or texts.
std::vector<unsigned> fields_of(const Hdf5Handle& type) {
  std::vector<unsigned> fields;
  for (int i = 0; i < H5Tget_nmembers(type.get()); ++i) {
    const auto index = static_cast<unsigned>(i);
    const Sort sort = sort_of(Hdf5Handle(H5Tget_member_type(type.get(), index)));
    if (sort == Sort::Number || sort == Sort::Text) fields.push_back(index);
  }
  return fields;
}

std::string name_of_field(const Hdf5Handle& type, unsigned index) {
  char* name = H5Tget_member_name(type.get(), index);
  std::string copy = name == nullptr ? "" : name;
  H5free_memory(name);
  return copy;
}

/// Whether records are complex numbers, as h5py writes them.
bool is_complex(const Hdf5Handle& type) {
  return H5Tget_nmembers(type.get()) == 2 && name_of_field(type, 0) == "r" &&
         name_of_field(type, 1) == "i";
}

std::vector<Column> columns_of_records(const Hdf5Handle& dataset, const Place& place) {
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  const auto members = static_cast<std::size_t>(std::max(H5Tget_nmembers(type.get()), 0));
  const std::vector<std::string> units = units_of(dataset, members, place);
  if (is_packed(dataset)) {
    place.refuse(
        "has records and an attribute of packed numbers (scale_factor, _FillValue, valid_range, "
        "…): "
        "of which field is not said");
  }
  std::vector<Column> columns;
  for (const unsigned index : fields_of(type)) {
    Column column{name_of_field(type, index), units[index], {}, {}};
    const Hdf5Handle field(H5Tget_member_type(type.get(), index));
    fill(
        dataset, field, [&](hid_t value) { return record_of(column.name, value); }, place, column);
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<Column> columns_of_matrix(const Hdf5Handle& dataset, const Place& place) {
  const auto width = static_cast<std::size_t>(extents_of(dataset)[1]);
  if (width > kMostColumns) {
    place.refuse("has more than " + std::to_string(kMostColumns) + " columns");
  }
  const std::vector<double> values = numbers_of<double>(
      dataset, [](hid_t value) { return Hdf5Handle(H5Tcopy(value)); }, place);
  const std::vector<std::string> names = texts_of_attribute(dataset, kColumns, place);
  const std::vector<std::string> units = units_of(dataset, width, place);
  if (!names.empty() && names.size() != width) {
    place.refuse("names " + std::to_string(names.size()) +
                 " columns by its attribute columns, of " + std::to_string(width));
  }
  std::vector<Column> columns(width);
  for (std::size_t k = 0; k < width; ++k) {
    if (!names.empty()) columns[k].name = names[k];
    columns[k].unit = units[k];
    columns[k].numbers.reserve(values.size() / width);
    for (std::size_t i = k; i < values.size(); i += width) columns[k].numbers.push_back(values[i]);
    unpack(dataset, place, columns[k]);
  }
  return columns;
}

/// Names of an object's attributes, but for those that say what its columns are.
std::vector<std::string> attributes_of(const Hdf5Handle& object, const Place& place) {
  std::vector<std::string> names;
  if (!read_attribute_names(object, names)) place.fail();
  std::erase_if(names, [](const std::string& name) {
    return name == kColumns || std::ranges::find(kUnits, name) != kUnits.end();
  });
  return names;
}

/// An attribute of one number or text; nothing if it holds something else.
std::optional<Column> attribute_of(const Hdf5Handle& object, const std::string& name,
                                   const Place& place) {
  std::vector<std::string> texts = texts_of_attribute(object, name.c_str(), place);
  if (texts.size() == 1) return Column{name, "", {}, std::move(texts)};
  const Hdf5Handle attribute(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT));
  if (attribute.get() < 0) (place / name).fail();
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  if (sort_of(type) != Sort::Number || count_of(space) != 1) return {};
  const auto read = [&](auto& value) {
    const hid_t memory = memory_type<std::remove_reference_t<decltype(value)>>();
    if (H5Aread(attribute.get(), memory, &value) < 0) (place / name).fail();
  };
  if (H5Tget_class(type.get()) == H5T_FLOAT) {
    double value = 0.0;
    read(value);
    return Column{name, "", {value}, {}};
  }
  const auto digits = [&](auto value) {
    read(value);
    return Column{name, "", {}, {std::to_string(value)}};
  };
  return H5Tget_sign(type.get()) == H5T_SGN_NONE ? digits(std::uint64_t{}) : digits(std::int64_t{});
}

std::size_t count_in(const Hdf5Handle& dataset) {
  return count_of(Hdf5Handle(H5Dget_space(dataset.get())));
}

bool is_number_or_text(const Hdf5Handle& dataset) {
  const Sort sort = sort_of(Hdf5Handle(H5Dget_type(dataset.get())));
  return sort == Sort::Number || sort == Sort::Text;
}

/// Whether an object is a dataset of one number or text.
bool is_value(const Hdf5Handle& object) {
  return is_dataset(object) && is_number_or_text(object) && count_in(object) == 1;
}

}  // namespace

std::vector<std::string> texts_of_attribute(const Hdf5Handle& object, const char* name,
                                            const Place& place) {
  if (H5Aexists(object.get(), name) <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(object.get(), name, H5P_DEFAULT));
  if (attribute.get() < 0) (place / name).fail();
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  if (sort_of(type) != Sort::Text || !refusal_of_attribute(attribute).empty()) return {};
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* out) {
    return H5Aread(attribute.get(), memory, out) >= 0;
  };
  if (!read_strings(type, space, read, texts)) (place / name).fail();
  return texts;
}

std::vector<std::string> names_in(const Hdf5Handle& group, const Place& place) {
  std::vector<std::string> names;
  if (!read_link_names(group, names)) place.fail();
  return names;
}

Hdf5Handle opened(const Hdf5Handle& group, const std::string& name, const Place& place) {
  if (link_at(group, name) != Link::Here) return {};
  Hdf5Handle object(H5Oopen(group.get(), name.c_str(), H5P_DEFAULT));
  if (object.get() < 0) (place / name).fail();
  return object;
}

bool is_group(const Hdf5Handle& object) {
  return object.get() >= 0 && H5Iget_type(object.get()) == H5I_GROUP;
}
bool is_column(const Hdf5Handle& object) {
  if (!is_dataset(object) || !is_number_or_text(object)) return false;
  const std::vector<hsize_t> extents = extents_of(object);
  const auto is_along = [](hsize_t extent) { return extent != 1; };
  return !extents.empty() && std::ranges::count_if(extents, is_along) <= 1;
}

bool is_column_of_numbers(const Hdf5Handle& object) {
  return is_column(object) && count_in(object) != 1 &&
         sort_of(Hdf5Handle(H5Dget_type(object.get()))) == Sort::Number;
}

bool is_table(const Hdf5Handle& object) {
  if (!is_dataset(object)) return false;
  const std::vector<hsize_t> extents = extents_of(object);
  const Hdf5Handle type(H5Dget_type(object.get()));
  if (sort_of(type) == Sort::Number) {
    if (extents.size() != 2 || extents[0] < 2 || extents[1] < 2) return false;
    return extents[1] <= kMostUnnamed || H5Aexists(object.get(), kColumns) > 0;
  }
  return sort_of(type) == Sort::Records && extents.size() == 1 && fields_of(type).size() >= 2 &&
         !is_complex(type);
}

std::vector<Column> columns_of(Hdf5Handle object, const Place& place) {
  if (is_group(object)) return columns_of_group(object, place);
  const Hdf5Handle dataset = checked(std::move(object), place);
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  return sort_of(type) == Sort::Records ? columns_of_records(dataset, place)
                                        : columns_of_matrix(dataset, place);
}

std::vector<Column> properties_of(const Hdf5Handle& object, const Place& place) {
  std::vector<Column> properties;
  for (const std::string& name : attributes_of(object, place)) {
    std::optional<Column> property = attribute_of(object, name, place);
    if (property) properties.push_back(std::move(*property));
  }
  if (!is_group(object)) return properties;
  for (const std::string& name : names_in(object, place)) {
    Hdf5Handle child = opened(object, name, place);
    if (!is_value(child)) continue;
    properties.push_back(column_of(checked(std::move(child), place / name), name, place / name));
  }
  return properties;
}

}  // namespace plastica::io::h5
