#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/scene_store.hpp"

/// What reports, JSON and pictures say of a simulated scene.
namespace plastica::report {

/// Whether a record is of a chain's motion, and not of a path of equilibria or a coupon.
bool is_motion(const io::SceneRecord& record);

/// The largest of something over all frames and joints.
struct Peak {
  double value = 0.0;
  std::size_t joint = 0;
  std::size_t sample = 0;
  std::size_t axis = 0;  ///< moments: 0 about x, 1 about y, 2 torque
};

struct ScenePeaks {
  std::optional<Peak> displacement;    ///< of a joint, its size; the axis is that it goes along [m]
  std::optional<Peak> moment;          ///< by size [N m]
  std::optional<Peak> stress;          ///< of bending, of the extreme fibre [Pa]
  std::optional<Peak> shear_stress;    ///< of torsion, T/W_t, by size [Pa]
  std::optional<Peak> plastic_strain;  ///< in the break measure [1]
};

/// Empty where everything is zero, as for a coupon.
ScenePeaks peaks_of(const io::SceneRecord& record);

/// How a run ended, in a line: "limit load: factor 1.4998; at 1.5003 the beam has given
/// way".
std::string outcome_line(const io::SceneRecord& record);

/// An entry of the energy balance.
struct EnergyEntry {
  double Energies::*member = nullptr;
  std::string_view name;  ///< as in files
  std::string_view doc;
};

/// All entries but the residual: first what comes in, then where it is or has gone.
std::span<const EnergyEntry> energy_entries();
/// Its name for people: "numerical dissipation".
std::string label_of(const EnergyEntry& entry);
/// Whether an entry is zero, or round-off, at all samples.
bool is_idle(const io::SceneRecord& record, const EnergyEntry& entry);

/// How far the energies are off: of a motion, what its response says; else the largest |residual|
/// over the largest of external work and stored plus plastic energy on the path [1]. Empty where
/// there is no energy.
std::optional<double> residual_fraction(const io::SceneRecord& record);

/// What keeps a motion's fixed steps shorter than `solver.time_step`: "samples", which are nearer
/// to each other; "division", of the time from one sample to the next into equal steps; or nothing.
std::string_view step_cut(const io::SceneRecord& record);

/// The word of a solver field that is a choice: "generalized_alpha" of "solver.scheme".
std::string solver_word(const io::SceneRecord& record, std::string_view field);

/// "about x", "about y", "torque".
std::string_view axis_name(std::size_t axis);
/// "bending about x", "bending about both", …; short: "bending x", "bending x, y"
std::string_view cause_name(BreakCause cause, bool brief = false);
/// What a probe records and where: "displacement y at 1".
std::string probe_label(const io::SceneRecord& record, const Probe& probe);
/// A place as a fraction of the length: "start", "end", "0.25".
std::string place_label(double fraction);

}  // namespace plastica::report
