#include "plastica/io/hdf5_columns.hpp"

#include <array>
#include <optional>
#include <utility>

#include "plastica/io/hdf5_check.hpp"
#include "plastica/io/hdf5_strings.hpp"

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

/// Texts of an attribute; none if there is no such attribute, or it holds something else.
std::vector<std::string> texts_of_attribute(const Hdf5Handle& object, const char* name,
                                            const Place& place) {
  if (H5Aexists(object.get(), name) <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(object.get(), name, H5P_DEFAULT));
  if (attribute.get() < 0) (place / name).fail();
  const Hdf5Handle type(H5Aget_type(attribute.get()));
  if (sort_of(type) != Sort::Text) return {};
  if (const std::string why = refusal_of_attribute(attribute); !why.empty()) {
    (place / name).refuse(why);
  }
  const Hdf5Handle space(H5Aget_space(attribute.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* out) {
    return H5Aread(attribute.get(), memory, out) >= 0;
  };
  if (!read_strings(type, space, read, texts)) (place / name).fail();
  return texts;
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

Hdf5Handle checked(Hdf5Handle dataset, const Place& place) {
  if (const std::string why = refusal_of_dataset(dataset); !why.empty()) place.refuse(why);
  return dataset;
}

std::vector<double> numbers_of(const Hdf5Handle& dataset, hid_t memory, const Place& place) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  std::vector<double> values(count_of(space));
  if (values.empty()) return values;
  const Hdf5Handle transfer(new_transfer(values.size(), memory));
  if (H5Dread(dataset.get(), memory, H5S_ALL, H5S_ALL, transfer.get(), values.data()) < 0) {
    place.fail();
  }
  return values;
}

/// @param as_memory  makes of the type of a text what is asked for in memory
template <typename AsMemory>
std::vector<std::string> texts_of(const Hdf5Handle& dataset, const Hdf5Handle& type,
                                  const AsMemory& as_memory, const Place& place) {
  const Hdf5Handle space(H5Dget_space(dataset.get()));
  std::vector<std::string> texts;
  const auto read = [&](hid_t text, void* out) {
    const Hdf5Handle memory(as_memory(text));
    const Hdf5Handle transfer(new_transfer(count_of(space), memory.get()));
    return H5Dread(dataset.get(), memory.get(), H5S_ALL, H5S_ALL, transfer.get(), out) >= 0;
  };
  if (!read_strings(type, space, read, texts)) place.fail();
  return texts;
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
  if (sort_of(type) == Sort::Number) {
    column.numbers = numbers_of(dataset, H5T_NATIVE_DOUBLE, place);
  } else {
    column.texts = texts_of(
        dataset, type, [](hid_t text) { return Hdf5Handle(H5Tcopy(text)); }, place);
  }
  return column;
}

std::vector<Column> columns_of_group(const Hdf5Handle& group, const Place& place) {
  std::vector<Column> columns;
  for (const std::string& name : names_in(group, place)) {
    Hdf5Handle object = opened(group, name, place);
    if (!is_column(object)) continue;
    const Place at = place / name;
    columns.push_back(column_of(checked(std::move(object), at), name, at));
  }
  return columns;
}

/// Names and sorts of the fields of records that are numbers or texts.
std::vector<std::pair<std::string, Sort>> fields_of(const Hdf5Handle& type) {
  std::vector<std::pair<std::string, Sort>> fields;
  for (int i = 0; i < H5Tget_nmembers(type.get()); ++i) {
    const auto index = static_cast<unsigned>(i);
    const Sort sort = sort_of(Hdf5Handle(H5Tget_member_type(type.get(), index)));
    if (sort != Sort::Number && sort != Sort::Text) continue;
    char* name = H5Tget_member_name(type.get(), index);
    fields.emplace_back(name == nullptr ? "" : name, sort);
    H5free_memory(name);
  }
  return fields;
}

std::vector<Column> columns_of_records(const Hdf5Handle& dataset, const Place& place) {
  const Hdf5Handle type(H5Dget_type(dataset.get()));
  const auto fields = fields_of(type);
  const std::vector<std::string> units = units_of(dataset, fields.size(), place);
  std::vector<Column> columns;
  for (const auto& [name, sort] : fields) {
    Column column{name, units[columns.size()], {}, {}};
    if (sort == Sort::Number) {
      const Hdf5Handle memory = record_of(name, H5T_NATIVE_DOUBLE);
      column.numbers = numbers_of(dataset, memory.get(), place);
    } else {
      const int index = H5Tget_member_index(type.get(), name.c_str());
      const Hdf5Handle field(H5Tget_member_type(type.get(), static_cast<unsigned>(index)));
      const std::string& of = name;
      column.texts = texts_of(
          dataset, field, [&of](hid_t text) { return record_of(of, text); }, place);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<Column> columns_of_matrix(const Hdf5Handle& dataset, const Place& place) {
  const auto width = static_cast<std::size_t>(extents_of(dataset)[1]);
  const std::vector<double> values = numbers_of(dataset, H5T_NATIVE_DOUBLE, place);
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
    for (std::size_t i = k; i < values.size(); i += width) columns[k].numbers.push_back(values[i]);
  }
  return columns;
}

/// Names of an object's attributes, but for those that say what its columns are.
std::vector<std::string> attributes_of(const Hdf5Handle& object, const Place& place) {
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  if (H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names) < 0) {
    place.fail();
  }
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
  double value = 0.0;
  if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0) (place / name).fail();
  return Column{name, "", {value}, {}};
}

/// Whether an object is a dataset of one number or text.
bool is_value(const Hdf5Handle& object) {
  if (!is_dataset(object) || !extents_of(object).empty()) return false;
  const Sort sort = sort_of(Hdf5Handle(H5Dget_type(object.get())));
  const Hdf5Handle space(H5Dget_space(object.get()));
  return (sort == Sort::Number || sort == Sort::Text) && count_of(space) == 1;
}

}  // namespace

std::vector<std::string> names_in(const Hdf5Handle& group, const Place& place) {
  const Hdf5Handle creation(H5Gget_create_plist(group.get()));
  unsigned order = 0;
  H5Pget_link_creation_order(creation.get(), &order);
  const bool is_known = (order & H5P_CRT_ORDER_INDEXED) != 0U;
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  const H5_index_t index = is_known ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  if (H5Literate(group.get(), index, H5_ITER_INC, nullptr, take, &names) < 0) place.fail();
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
  if (!is_dataset(object)) return false;
  const Sort sort = sort_of(Hdf5Handle(H5Dget_type(object.get())));
  return (sort == Sort::Number || sort == Sort::Text) && extents_of(object).size() == 1;
}

bool is_table(const Hdf5Handle& object) {
  if (!is_dataset(object)) return false;
  const std::vector<hsize_t> extents = extents_of(object);
  const Hdf5Handle type(H5Dget_type(object.get()));
  if (sort_of(type) == Sort::Number) return extents.size() == 2 && extents[1] >= 2;
  return sort_of(type) == Sort::Records && extents.size() == 1 && fields_of(type).size() >= 2;
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
