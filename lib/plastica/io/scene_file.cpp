#include "plastica/io/scene_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/io/read_chain.hpp"
#include "plastica/io/read_drive.hpp"
#include "plastica/io/read_fields.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/checked_scene.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/run/check_regions.hpp"

namespace plastica::io {
namespace {

/// Whether a scene is a coupon; refuses what is neither that nor a chain, and keys of the other.
bool is_coupon(const TomlTable& root, const SolverOptions& solver, SceneUse use) {
  const bool coupon = root.contains("drive");
  const bool is_at_rest = use == SceneUse::Run && solver.analysis == Analysis::Statics;
  if (!coupon && !root.contains("support") && is_at_rest) {
    throw InputError({root.where().file, 0}, "support", "",
                     "is missing: a scene needs [[support]] and loads, or a [drive]; a beam in "
                     "free flight needs solver.analysis = \"dynamics\"");
  }
  for (const std::string_view key :
       {"support", "load", "mass", "region", "gravity", "initial_motion", "cut"}) {
    if (!coupon || !root.contains(key)) continue;
    throw InputError(locate(root, key), key, "",
                     "does not go with [drive]: a scene is a chain with supports and loads, or a "
                     "coupon with a drive");
  }
  if (coupon) refuse_rules_of_chains(root);
  return coupon;
}

void read_coupon(const TomlTable& root, const std::string& file, Setup& setup) {
  const auto drive = root.find_table("drive");
  read_part(*drive, "drive.", setup);
  setup.scene.drive.strain = read_strain(*drive, file);
  if (std::vector<Probe> probes = read_probes(root, true); !probes.empty()) {
    setup.scene.probes = std::move(probes);
  }
}

void read_chain(const TomlTable& root, Setup& setup) {
  read_regions(root, setup);
  read_actions(root, setup);
  setup.scene.probes = read_probes(root, false);
}

InputError placed_in(const TomlTable& root, const InputError& error) {
  if (!error.where().file.empty() || error.field().starts_with("--")) return error;
  return {locate(root, error.field()), error.field(), error.value(), error.rule()};
}

/// Says of an error that names a field alone where the file has that.
template <class Check>
void at_its_key(const TomlTable& root, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw placed_in(root, error);
  }
}

/// @throws InputError
void check_run(const Scene& scene, const SolverOptions& solver) {
  const LevelChoice level = model_detail::checked_scene(scene, solver).level;
  // There it is an angle, of which a file gives none.
  if (solver.control == PathControl::Displacement && level.level == Level::Twist) {
    throw InputError({}, "solver.control", "displacement",
                     "takes a point along: a beam that is twisted alone follows \"arc_length\"");
  }
}

}  // namespace

void refuse_rules_of_chains(const TomlTable& root) {
  const auto rules = root.find_table("rules");
  if (!rules) return;
  for (const auto& [path, why] : model_detail::chain_rules()) {
    const std::string_view key = path.substr(path.find('.') + 1);
    if (rules->contains(key)) throw rules->at(key).error(why);
  }
}

void read_setup(const TomlTable& root, Setup& setup) {
  const auto material = part_of_beam(root, "material");
  const auto section = part_of_beam(root, "section");
  if (material) read_material(*material, setup);
  if (section) read_section(*section, setup);
  constexpr std::array<std::string_view, 4> kReadElsewhere{"material", "section", "drive",
                                                           "gravity"};
  for (const Field& field : fields()) {
    const std::string_view part = field.path.substr(0, field.path.find('.'));
    if (std::find(kReadElsewhere.begin(), kReadElsewhere.end(), part) == kReadElsewhere.end()) {
      read_field(root, field.path, field, setup);
    }
  }
  at_its_key(root, [&] {
    check_material(setup.scene.material);
    check_section(setup.scene.section);
  });
}

void check_section_is_whole(const TomlTable& root, const Setup& setup) {
  const auto section = part_of_beam(root, "section");
  if (!section || section->is_string() || section->table().contains("profile")) return;
  const TomlTable table = section->table();
  const auto is_said = [&](const Field& field) {
    return table.contains(field.path.substr(std::string_view("section.").size()));
  };
  const auto dimensions = section_kind(setup.scene.section).dimensions();
  if (!table.contains("shape") && std::ranges::none_of(dimensions, is_said)) return;
  refuse_missing_dimensions(*section, setup.scene.section);
}

SceneFile parse_scene_file(std::string text, std::string name, SceneUse use) {
  const TomlDocument document = TomlDocument::parse(std::move(text), std::move(name));
  const TomlTable& root = document.root();
  SceneFile file{document.name(), document.text(), {}, {}};
  Scene& scene = file.setup.scene;
  const auto title = root.find("name");
  scene.name = title ? title->string() : std::filesystem::path(file.path).stem().string();
  read_setup(root, file.setup);
  read_beam(root, file.setup);
  if (is_coupon(root, file.setup.solver, use)) {
    read_coupon(root, file.path, file.setup);
  } else {
    read_chain(root, file.setup);
  }
  root.check_unused();
  check_section_is_whole(root, file.setup);
  at_its_key(root, [&] {
    if (use == SceneUse::Run) check_run(scene, file.setup.solver);
    check_regions(scene);
  });
  file.notes = root.notes();
  return file;
}

InputError placed_in(const SceneFile& file, const InputError& error) {
  return placed_in(TomlDocument::parse(file.text, file.path).root(), error);
}

SceneFile read_scene_file(const std::string& path, SceneUse use) {
  const TomlDocument document = TomlDocument::read(path);
  return parse_scene_file(document.text(), path, use);
}

}  // namespace plastica::io
