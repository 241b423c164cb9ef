#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/scene_store.hpp"

/// What reports, JSON and pictures say of a simulated scene.
namespace plastica::report {

/// The largest of something over all samples and joints.
struct Peak {
  double value = 0.0;
  std::size_t joint = 0;
  std::size_t sample = 0;
  std::size_t axis = 0;  ///< moments: 0 about x, 1 about y, 2 torque
};

struct ScenePeaks {
  std::optional<Peak> moment;          ///< by size [N m]
  std::optional<Peak> stress;          ///< of bending, of the extreme fibre [Pa]
  std::optional<Peak> shear_stress;    ///< of torsion, T/W_t, by size [Pa]
  std::optional<Peak> plastic_strain;  ///< in the break measure [1]
};

/// Empty where everything is zero, as for a coupon.
ScenePeaks peaks_of(const io::SceneRecord& record);

/// How a run ended, in a line: "limit load: no equilibrium beyond factor 1.4998 (none found at
/// 1.5003)".
std::string outcome_line(const io::SceneRecord& record);

/// A bound on how far the energies are off: |residual| over the largest of external work and
/// stored plus plastic energy on the path [1]; empty where there is no energy.
std::optional<double> residual_share(const io::SceneRecord& record);

/// "about x", "about y", "torque".
std::string_view axis_name(std::size_t axis);
/// "bending about x", "bending about both", …
std::string_view cause_name(BreakCause cause);
/// What a probe records and where: "displacement y at 1".
std::string probe_label(const io::SceneRecord& record, const Probe& probe);
/// A place as a share of the length: "start", "end", "0.25".
std::string place_label(double share);

}  // namespace plastica::report
