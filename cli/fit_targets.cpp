#include "cli/fit_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "calibrate/fit/scene_laws.hpp"
#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

using calibrate::Law;
using calibrate::StoredScene;

std::string with_segments(const StoredScene& scene) {
  if (!scene.setup || scene.setup->scene.is_coupon()) return scene.name + " (a coupon)";
  return fmt::format("{} ({} segments)", scene.name, scene.setup->scene.beam.segments);
}

std::string list_of(const std::vector<StoredScene>& scenes) {
  std::string text;
  for (const StoredScene& scene : scenes) text += (text.empty() ? "" : ", ") + with_segments(scene);
  return text;
}

bool harden_alike(const Setup& a, const Setup& b) {
  return std::ranges::all_of(fields(), [&](const Field& field) {
    return !field.path.starts_with("material.hardening.") || field.get(a) == field.get(b);
  });
}

}  // namespace

FitTargets::FitTargets(const std::vector<calibrate::SceneFitRecord>& records,
                       const calibrate::SceneFitRecord& record,
                       const calibrate::StoredSceneFit* stored, const std::string& wanted)
    : records_(records), record_(record), stored_(stored), wanted_(wanted) {
  std::vector<std::size_t> all(record.targets.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const std::size_t target : all) {
    if (wanted.empty() || record.targets[target].name == wanted) targets_.push_back(target);
  }
  if (targets_.empty()) {
    throw InputError({}, "--target", wanted, "must be one of those of the fit: " + list(all));
  }
}

std::optional<std::size_t> FitTargets::scene_of(std::size_t target) const {
  if (stored_ == nullptr) return std::nullopt;
  const std::vector<std::size_t>& scenes = stored_->scene_of_table;
  std::size_t table = record_.targets[target].table;
  // Files of older versions do not say; where each table has one target they stand in its order.
  if (table == 0 && records_.size() == 1 && record_.targets.size() == scenes.size()) {
    table = target + 1;
  }
  return table == 0 || table > scenes.size() ? std::nullopt : std::optional(scenes[table - 1]);
}

Law FitTargets::law_of(std::size_t target) const {
  const auto& made = record_.result.targets;
  return target < made.size() ? made[target].law : record_.result.law;
}

Law FitTargets::law() const { return law_of(targets_.front()); }

std::vector<std::size_t> FitTargets::scene_indices() const {
  std::vector<std::size_t> scenes;
  for (const std::size_t target : targets_) {
    const auto scene = scene_of(target);
    if (!scene) {
      scenes.resize(stored_ == nullptr ? 0 : stored_->scenes.size());
      std::iota(scenes.begin(), scenes.end(), std::size_t{0});
      return scenes;
    }
    if (std::ranges::find(scenes, *scene) == scenes.end()) scenes.push_back(*scene);
  }
  return scenes;
}

std::vector<StoredScene> FitTargets::scenes() const {
  std::vector<StoredScene> scenes;
  for (const std::size_t index : scene_indices()) scenes.push_back(stored_->scenes[index]);
  return scenes;
}

std::string FitTargets::names() const {
  std::string text = targets_.size() == 1 ? "target " : "targets ";
  for (const std::size_t target : targets_) {
    text += (target == targets_.front() ? "" : ", ") + record_.targets[target].name;
  }
  return text;
}

std::string FitTargets::list(const std::vector<std::size_t>& targets) const {
  constexpr std::size_t kMaxNames = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(targets.size(), kMaxNames); ++k) {
    const std::size_t target = targets[k];
    const auto scene = scene_of(target);
    text += fmt::format("{}{} ({}{})", k == 0 ? "" : ", ", record_.targets[target].name,
                        scene ? with_segments(stored_->scenes[*scene]) + ", " : "",
                        calibrate::phrase_of(law_of(target)));
  }
  if (targets.size() > kMaxNames) text += fmt::format(", … ({} in all)", targets.size());
  return text;
}

const StoredScene& FitTargets::take_scene(const std::string& name) {
  std::vector<std::size_t> found = scene_indices();
  const bool known =
      std::ranges::all_of(targets_, [&](std::size_t t) { return scene_of(t).has_value(); });
  if (!name.empty()) {
    std::erase_if(found, [&](std::size_t each) { return stored_->scenes[each].name != name; });
    if (found.empty()) {
      throw InputError({}, "--scene", name,
                       fmt::format("is no file, nor a scene that {} went through: {}",
                                   wanted_.empty() ? "the fit" : names(), list_of(scenes())));
    }
  }
  if (found.size() > 1 && !known) {
    throw InputError({}, "--scene", name,
                     fmt::format("{}: {}",
                                 name.empty() ? "must be one of those that the fit went through"
                                              : "is several in the fit; take a scene file",
                                 list_of(scenes())));
  }
  if (found.size() > 1) {
    throw InputError({}, "--target", "",
                     fmt::format("must be one of those of the fit, which went through several "
                                 "scenes: {}",
                                 list(targets_)));
  }
  if (known) std::erase_if(targets_, [&](std::size_t t) { return scene_of(t) != found.front(); });
  return stored_->scenes[found.front()];
}

std::optional<Law> FitTargets::harden(Setup& setup) const {
  const std::span<const calibrate::Parameter> parameters =
      stored_ == nullptr ? std::span<const calibrate::Parameter>{} : stored_->parameters;
  const Law own = calibrate::law_of(setup.scene.material.hardening, parameters);
  const bool several =
      std::ranges::any_of(targets_, [&](std::size_t t) { return law_of(t) != law(); });
  if (several) {
    if (std::ranges::any_of(targets_, [&](std::size_t t) { return law_of(t) == own; })) {
      return std::nullopt;
    }
    throw InputError({}, "--target", "",
                     fmt::format("must be one of those of the fit: they have several laws, the "
                                 "scene has none of them, but {}: {}",
                                 calibrate::phrase_of(own), list(targets_)));
  }
  const std::vector<StoredScene> stored = scenes();
  const bool alike = std::ranges::all_of(stored, [&](const StoredScene& scene) {
    return scene.setup && harden_alike(*scene.setup, *stored.front().setup);
  });
  if (!stored.empty() && alike) {
    setup.scene.material.hardening = stored.front().setup->scene.material.hardening;
  } else if (!stored.empty() && own != law()) {
    throw InputError({}, "--target", "",
                     fmt::format("must be one of those of the fit, whose scenes have several sets "
                                 "of numbers of {}: {}",
                                 calibrate::phrase_of(law()), list(targets_)));
  }
  return law();
}

}  // namespace plastica::cli
