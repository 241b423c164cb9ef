#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/model/check_value.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/model/item_field.hpp"
#include "plastica/model/scene.hpp"

/// The parts of `check_scene`; not installed. All throw InputError naming the first field that is
/// wrong, as files name it: the second [[support]] is "support[2]".
namespace plastica::model_detail {

/// "support[2].at" of ("support", 1, ".at").
std::string item_name(std::string_view list, std::size_t index, std::string_view key = {});

/// A place as messages show it: "start", "end", { segment = 12 }, 0.25.
std::string place_text(const Place& place);

/// A place on a beam of so many segments.
void check_place(const Place& place, int segments, std::string_view field);

/// Throws unless all components are finite.
void check_finite(std::span<const double> values, std::string_view field);

/// Throws unless each number of an item is within its range.
template <class Item, class Field>
void check_item(const Item& item, std::span<const Field> fields, const std::string& name) {
  for (const Field& field : fields) {
    const std::string path = name + '.' + std::string(field.key);
    check_finite(field.values(item), path);
    for (const double value : field.values(item)) {
      require(field.range.contains(value), {}, path, value, field.range.rule());
    }
  }
}

/// Where the segments of a beam end, which all later checks go by (`segment_ends`).
using Ends = std::span<const double>;

/// Lengths and shape of a chain's beam, and its regions.
/// @return where its segments end
std::vector<double> check_beam(const Scene& scene);

/// What a support holds, rotations about the world's axes: of a pin the twist of a beam that goes
/// along x or y there.
HeldFreedoms held_about_world(const Scene& scene, const Support& support, Ends ends);

void check_supports(const Scene& scene, Ends ends);

/// Hinges within the beam, and what must not act there.
void check_hinges(const Scene& scene, Ends ends);

void check_masses(const Scene& scene);

/// Loads and gravity, and that something acts on the beam at all.
void check_actions(const Scene& scene, Analysis analysis, Ends ends);

/// What a path of equilibria does not have: initial motions, cuts, impacts, damping.
void check_statics(const Scene& scene, const SolverOptions& options);

/// What a motion begins with and how it is solved; cuts apart.
void check_dynamics(const Scene& scene, const SolverOptions& options, Ends ends);

/// Cuts, on a level that holds the scene.
/// @return the segment end at the nearest joint of each (cuts)
std::vector<int> check_cuts(const Scene& scene, const LevelChoice& level, Ends ends);

/// What articulated schemes cannot do.
void check_articulated(const Scene& scene, const SolverOptions& options, const LevelChoice& level,
                       Ends ends);

/// The first load whose work depends on the path, so that the tangent at an equilibrium is not
/// symmetric: it follows its segment, or is a moment of a fixed axis in space.
std::optional<std::size_t> load_without_potential(const Scene& scene, const LevelChoice& level);

/// What buckling factors and natural frequencies are asked of.
void check_modes(const Scene& scene, const SolverOptions& options, const LevelChoice& level);

/// A field of [rules] that a coupon has no use for, and why.
struct ChainRule {
  std::string_view path;
  std::string_view why;
};
std::span<const ChainRule> chain_rules();

/// Rules of chains that the scene of a coupon sets.
void check_coupon_rules(const Setup& setup);

/// Rules of a chain that contradict each other.
void check_rules(const Scene& scene);

/// Whether ends that are held against rotation are held by half joints, not by rigid clamps.
bool has_half_joints(const Scene& scene);

/// The end of the last history that anything follows [s].
double last_time(const Scene& scene);

/// That there are kernels of the precision that is asked for.
void check_precision(const Scene& scene, const SolverOptions& options);

/// How a chain is solved.
void check_solver(const Scene& scene, const SolverOptions& options);

/// Probes of a coupon, without ends, or a chain.
void check_probes(const Scene& scene, Analysis analysis, Ends ends);

}  // namespace plastica::model_detail
