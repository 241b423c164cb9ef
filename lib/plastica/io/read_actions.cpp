#include "plastica/io/read_chain.hpp"
#include "plastica/io/read_fields.hpp"
#include "plastica/io/read_place.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::io {
namespace {

template <class Item>
void read_number(const TomlValue& value, const ItemField<Item>& field, Item& item) {
  const Dimension dimension = field.dimension_of(item);
  if (const auto* number = std::get_if<double Item::*>(&field.member)) {
    item.** number = value.quantity(dimension);
  } else {
    item.*std::get<std::array<double, 3> Item::*>(field.member) = read_vector(value, dimension);
  }
}

/// Of a bed of springs a unit that does not fit is most likely that of one spring.
void read_of_support(const TomlValue& value, const SupportField& field, Support& support) {
  try {
    read_number(value, field, support);
  } catch (const InputError& error) {
    const bool of_unit = error.rule().find("unit of") != std::string::npos;
    if (!support.to || !of_unit || field.of != &SupportTraits::springs) throw;
    throw InputError(error.where(), error.field(), error.value(),
                     error.rule() + ": with to, a stiffness is per length");
  }
}

/// Those numbers that a table gives, at least one.
template <class Item>
void read_any(const TomlTable& table, std::span<const ItemField<Item>> fields, Item& item) {
  std::string names;
  bool any = false;
  for (const ItemField<Item>& field : fields) {
    names += (names.empty() ? "" : " or ") + std::string(field.key);
    const auto value = table.find(field.key);
    if (value) read_number(*value, field, item);
    any = any || value;
  }
  if (!any) throw InputError(table.where(), table.key(), "", "needs " + names);
}

HeldFreedoms read_hold(const TomlValue& list) {
  HeldFreedoms held{};
  for (const TomlValue& item : list.array()) {
    bool& freedom = held[item.word(freedom_names())];
    if (freedom) throw item.error("is in the list twice");
    freedom = true;
  }
  return held;
}

/// Where something is, or begins: `at`, or `from` beside `to`, as regions say it.
Place read_begin(const TomlTable& table) {
  const auto at = table.find("at");
  const auto from = table.find("from");
  if (!from) return read_place(table.at("at"));
  if (at) throw at->error("stands beside from: one of them is enough");
  if (!table.find("to")) throw from->error("needs to; a single place is at");
  return read_place(*from);
}

Support read_support(const TomlTable& table) {
  Support support;
  support.at = read_begin(table);
  support.kind = static_cast<SupportKind>(table.at("kind").word(support_kinds()));
  const SupportTraits& kind = traits_of(support);
  if (const auto hold = table.find("hold")) support.hold = read_hold(*hold);
  if (const auto to = table.find("to")) {
    if (!kind.springs) throw to->error("belongs to " + kinds_with(&SupportTraits::springs));
    support.to = read_place(*to);
  }
  for (const SupportField& field : support_fields()) {
    const auto value = table.find(field.key);
    if (!value) continue;
    if (!field.belongs_to(support)) throw value->error("belongs to " + kinds_with(field.of));
    if (field.of == &SupportTraits::normal) {
      support.normal = read_direction(*value);
    } else {
      read_of_support(*value, field, support);
    }
  }
  if (kind.normal && !kind.any_normal) (void)table.at("normal");
  if (const auto history = table.find("history")) {
    if (!table.find("translation") && !table.find("rotation")) {
      throw history->error("has no translation or rotation to move");
    }
    support.history = read_history(*history);
  }
  return support;
}

Load read_load(const TomlTable& table) {
  Load load;
  load.at = read_begin(table);
  const auto to = table.find("to");
  if (to) load.to = read_place(*to);
  read_any(table, load_fields(), load);
  if (const auto follows = table.find("follows")) load.follows = follows->boolean();
  if (const auto history = table.find("history")) load.history = read_history(*history);
  return load;
}

PointMass read_mass(const TomlTable& table) {
  PointMass mass;
  mass.at = read_place(table.at("at"));
  (void)table.at("mass");
  read_any(table, mass_fields(), mass);
  return mass;
}

InitialMotion read_initial_motion(const TomlTable& table) {
  InitialMotion motion;
  if (const auto from = table.find("from")) motion.from = read_place(*from);
  if (const auto to = table.find("to")) motion.to = read_place(*to);
  read_any(table, initial_motion_fields(), motion);
  if (const auto about = table.find("about")) {
    if (!table.find("spin")) throw about->error("has no spin to go through it");
    motion.about = read_place(*about);
  }
  return motion;
}

void read_gravity(const TomlTable& root, Setup& setup) {
  const auto gravity = root.find("gravity");
  if (!gravity) return;
  if (gravity->is_array()) {
    setup.scene.gravity = read_vector(*gravity, Dimension::Acceleration);
    return;
  }
  if (!gravity->is_table()) {
    throw gravity->error(
        "must be a list of x, y and z, or a table of acceleration, or x, y and z, and history");
  }
  const TomlTable table = gravity->table();
  read_part(table, "gravity.", setup);
  if (const auto all = table.find("acceleration")) {
    setup.scene.gravity = read_vector(*all, Dimension::Acceleration);
  }
  if (const auto history = table.find("history")) {
    setup.scene.gravity_history = read_history(*history);
  }
}

}  // namespace

void read_regions(const TomlTable& root, Setup& setup) {
  for (const TomlTable& table : root.find_tables("region")) {
    const TomlValue from = table.at("from");
    const TomlValue to = table.at("to");
    const auto section = table.find("section");
    const auto to_section = table.find("to_section");
    const auto material = table.find("material");
    if (!section && !to_section && !material) {
      table.check_unused();
      throw InputError(table.where(), table.key(), "", "needs a section or a material");
    }
    Setup part;
    part.scene.section = setup.scene.section;
    part.scene.material = setup.scene.material;
    if (section) read_section(*section, part);
    if (material) read_material(*material, part);
    Setup end = part;
    if (to_section) read_section(*to_section, end);
    std::vector<std::string> own;
    if (section) own = paths_said(*section, "section");
    if (material) {
      const auto said = paths_said(*material, "material");
      own.insert(own.end(), said.begin(), said.end());
    }
    Region region{read_place(from), read_place(to), part.scene.section, part.scene.material};
    if (to_section) {
      region.to_section = end.scene.section;
      for (const std::string& path : paths_said(*to_section, "section")) {
        own.push_back("to_" + path);
      }
    }
    region.own = std::move(own);
    setup.scene.regions.push_back(std::move(region));
  }
}

void read_actions(const TomlTable& root, Setup& setup) {
  for (const TomlTable& table : root.find_tables("support")) {
    setup.scene.supports.push_back(read_support(table));
  }
  for (const TomlTable& table : root.find_tables("load")) {
    setup.scene.loads.push_back(read_load(table));
  }
  for (const TomlTable& table : root.find_tables("mass")) {
    setup.scene.masses.push_back(read_mass(table));
  }
  read_gravity(root, setup);
  for (const TomlTable& table : root.find_tables("initial_motion")) {
    setup.scene.initial_motions.push_back(read_initial_motion(table));
  }
  for (const TomlTable& table : root.find_tables("cut")) {
    setup.scene.cuts.push_back(
        {read_place(table.at("at")), table.at("time").quantity(Dimension::Time)});
  }
  const auto solver = root.find_table("solver");
  if (const auto at = solver ? solver->find("control_at") : std::nullopt) {
    setup.solver.control_at = read_place(*at);
  }
  if (const auto motion = solver ? solver->find("control_motion") : std::nullopt) {
    if (setup.solver.control != PathControl::Displacement) {
      throw motion->error("goes with control = \"displacement\" alone");
    }
    setup.solver.control_motion = read_vector(*motion, Dimension::Length);
  }
}

}  // namespace plastica::io
