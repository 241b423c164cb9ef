#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/config/stored_scenes.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::cli {

/// The targets of a fit through scenes that a beam is exported for: with their scene, and with the
/// law that it has.
class FitTargets {
 public:
  /// @param records  of the file; must outlive this, as must the next ones
  /// @param record  of these
  /// @param stored  what the file has of the scenes; null: nothing
  /// @param wanted  name of a target; empty: all of the fit's
  /// @throws InputError naming the targets if the fit has none of this name
  FitTargets(const std::vector<calibrate::SceneFitRecord>& records,
             const calibrate::SceneFitRecord& record, const calibrate::StoredSceneFit* stored,
             const std::string& wanted);

  /// The scene that they went through. To be asked where something is stored. Those that went
  /// through another one are left out from then on.
  /// @param name  of its file; empty: their only one
  /// @throws InputError naming the targets where there are several
  const calibrate::StoredScene& take_scene(const std::string& name);

  /// Gives a scene of a file the hardening that the targets' scenes have, with its numbers.
  /// @return their law; empty if they have several and the scene has one of these: its own stays
  /// @throws InputError naming the targets and their laws if the scene has none of several
  std::optional<calibrate::Law> harden(Setup& setup) const;

  calibrate::Law law() const;  ///< of the first
  /// The scenes that they went through, each once; all that are stored if that is not known.
  std::vector<calibrate::StoredScene> scenes() const;
  std::string names() const;  ///< "target bar", "targets bar, long"

 private:
  std::optional<std::size_t> scene_of(std::size_t target) const;
  calibrate::Law law_of(std::size_t target) const;
  std::vector<std::size_t> scene_indices() const;
  std::string list(const std::vector<std::size_t>& targets) const;

  const std::vector<calibrate::SceneFitRecord>& records_;
  const calibrate::SceneFitRecord& record_;
  const calibrate::StoredSceneFit* stored_;
  std::string wanted_;
  std::vector<std::size_t> targets_;  ///< of the record's
};

}  // namespace plastica::cli
