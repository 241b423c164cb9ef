#include "calibrate/config/stored_scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

#include "calibrate/config/read_parameters.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {
namespace {

/// @param segments  of all beams of the fit; empty: as scene and target have them
StoredScene read_scene(const io::InputText& input, const io::TomlTable& target,
                       std::optional<int> segments) {
  StoredScene scene;
  scene.name = input.name;
  try {
    Setup setup = io::parse_scene_file(input.text, input.name).setup;
    io::read_setup(target, setup);
    if (segments && !setup.scene.is_coupon()) setup.scene.beam.segments = *segments;
    scene.setup = std::move(setup);
  } catch (const InputError& error) {
    scene.why_not = error.what();
  }
  return scene;
}

/// Of one file; what targets change are fields of the table.
bool is_the_same(const StoredScene& a, const StoredScene& b) {
  if (a.setup.has_value() != b.setup.has_value()) return false;
  return !a.setup || std::ranges::all_of(fields(), [&](const Field& field) {
    return field.get(*a.setup) == field.get(*b.setup);
  });
}

}  // namespace

std::optional<StoredSceneFit> read_stored_scenes(const std::vector<io::InputText>& inputs) {
  if (inputs.empty()) return std::nullopt;
  const auto document = io::TomlDocument::parse(inputs.front().text, inputs.front().name);
  const io::TomlTable& root = document.root();
  StoredSceneFit stored;
  std::optional<int> segments;
  if (const auto fit = root.find_table("fit")) {
    stored.parameters = read_parameters(*fit, ParameterScope::Scene);
    const auto number = fit->find("segments");
    if (number) segments = static_cast<int>(number->integer(1, std::numeric_limits<int>::max()));
  }
  // Two files may have one name, in two folders.
  std::map<std::string, std::size_t> input_of;
  std::map<std::size_t, std::vector<std::size_t>> known;
  for (const io::TomlTable& target : root.find_tables("target")) {
    const std::filesystem::path path(target.at("scene").string());
    const auto [at, is_new] =
        input_of.emplace(path.lexically_normal().string(), input_of.size() + 1);
    const std::size_t index = at->second;
    if (index >= inputs.size() || inputs[index].name != path.filename().string()) {
      return std::nullopt;
    }
    StoredScene scene = read_scene(inputs[index], target, segments);
    std::vector<std::size_t>& of_file = known[index];
    const auto equal = std::ranges::find_if(
        of_file, [&](std::size_t each) { return is_the_same(stored.scenes[each], scene); });
    if (equal != of_file.end()) {
      stored.scene_of_table.push_back(*equal);
      continue;
    }
    of_file.push_back(stored.scenes.size());
    stored.scene_of_table.push_back(stored.scenes.size());
    stored.scenes.push_back(std::move(scene));
  }
  if (stored.scenes.empty()) return std::nullopt;
  return stored;
}

}  // namespace plastica::calibrate
