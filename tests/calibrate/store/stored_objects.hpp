#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "plastica/io/hdf5.hpp"

namespace plastica::calibrate {

/// Calls with an empty value of the integers that a dataset holds.
template <typename Use>
void with_integer_type(const io::Hdf5Group& group, const std::string& name, const Use& use) {
  const auto holds = [&](auto none) {
    try {
      group.read_array<decltype(none)>(name, group.shape(name));
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  if (holds(std::uint8_t{})) return use(std::uint8_t{});
  if (holds(std::uint64_t{})) return use(std::uint64_t{});
  use(std::int64_t{});
}

/// Everything in a group but /meta: path → kind, shape, units and values, as text.
inline void describe(const io::Hdf5Group& group, std::map<std::string, std::string>& objects) {
  for (const std::string& name : group.children()) {
    const std::string path = (group.path() == "/" ? "/" : group.path() + "/") + name;
    if (path == "/meta") continue;
    std::string& text = objects[path];
    if (group.has_attribute(name, "units")) text += group.text_attribute(name, "units") + ";";
    if (group.kind(name) == io::Hdf5Kind::Group) {
      describe(group.open_group(name), objects);
      continue;
    }
    for (const std::size_t extent : group.shape(name)) text += std::to_string(extent) + ",";
    if (group.kind(name) == io::Hdf5Kind::Text) {
      if (group.shape(name).empty()) {
        text += group.read_text(name);
        continue;
      }
      for (const std::string& value : group.read_texts(name)) text += value + "|";
    } else if (group.kind(name) == io::Hdf5Kind::Real) {
      const auto values = group.read_array<double>(name, group.shape(name));
      text.append(reinterpret_cast<const char*>(values.data()), 8 * values.size());
    } else {
      with_integer_type(group, name, [&](auto none) {
        for (const auto value : group.read_array<decltype(none)>(name, group.shape(name))) {
          text += std::to_string(value) + "|";
        }
      });
    }
  }
}

/// The same of a whole file.
inline std::map<std::string, std::string> objects_of(const std::string& path) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  std::map<std::string, std::string> objects;
  describe(file.root(), objects);
  return objects;
}

/// Copies all datasets of a group but one.
inline void copy_but(const io::Hdf5Group& from, io::Hdf5Group& to, const std::string& left_out,
                     const std::string& below = {}) {
  for (const std::string& name : from.children()) {
    const std::string path = below.empty() ? name : below + "/" + name;
    if (path == left_out) continue;
    switch (from.kind(name)) {
      case io::Hdf5Kind::Group: {
        io::Hdf5Group group = to.group(name);
        copy_but(from.open_group(name), group, left_out, path);
        if (from.has_attribute(name, "path")) {
          to.set_attribute(name, "path", from.text_attribute(name, "path"));
        }
        break;
      }
      case io::Hdf5Kind::Text:
        if (from.shape(name).empty()) {
          to.write_text(name, from.read_text(name));
        } else {
          to.write_texts(name, from.read_texts(name));
        }
        break;
      case io::Hdf5Kind::Real:
        if (from.shape(name).empty()) {
          to.write(name, from.read_scalar<double>(name));
        } else {
          to.write(name, from.read<double>(name));
        }
        break;
      default:
        with_integer_type(from, name, [&](auto none) {
          if (from.shape(name).empty()) {
            to.write(name, from.read_scalar<decltype(none)>(name));
          } else {
            to.write(name, from.read<decltype(none)>(name));
          }
        });
    }
  }
}

}  // namespace plastica::calibrate
