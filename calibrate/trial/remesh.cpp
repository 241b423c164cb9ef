#include "calibrate/trial/remesh.hpp"

#include <string>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/model/beam_axis.hpp"

namespace plastica::calibrate {
namespace {

constexpr int kMinSegments = 4;

/// Of segments whose end ones are half as long there are as many whole ones as joints.
int divided(const Scene& scene, Division division) {
  const int more = scene.end_rule == EndRule::Half ? 1 : 0;
  const int whole = scene.beam.segments - more;
  if (division == Division::Twice) return 2 * whole + more;
  if (whole < kMinSegments || whole % 2 != 0) {
    throw InputError({}, "beam.segments", std::to_string(scene.beam.segments),
                     "cannot be halved: it is " +
                         std::string(whole < kMinSegments ? "too small" : "no even number"));
  }
  return whole / 2 + more;
}

std::vector<double> divided(const std::vector<double>& fractions, Division division) {
  std::vector<double> made;
  if (division == Division::Twice) {
    for (const double fraction : fractions) made.insert(made.end(), 2, 0.5 * fraction);
  } else {
    for (std::size_t i = 0; i + 1 < fractions.size(); i += 2) {
      made.push_back(fractions[i] + fractions[i + 1]);
    }
  }
  return made;
}

/// The same division without anything on the beam.
std::vector<double> bare_ends(const Scene& scene) {
  Scene bare;
  bare.beam.segments = scene.beam.segments;
  bare.beam.segment_fractions = scene.beam.segment_fractions;
  return segment_ends(bare);
}

/// The segments' fractions of the length where they are not even; empty where they are, or where
/// the rule Half, which does not go with fractions, sets the lengths.
/// @param ends  of its segments
std::vector<double> uneven_fractions(const Scene& scene, const std::vector<double>& ends) {
  if (scene.end_rule == EndRule::Half) return {};
  if (!scene.beam.segment_fractions.empty()) return scene.beam.segment_fractions;
  if (ends == bare_ends(scene)) return {};
  std::vector<double> fractions;
  for (std::size_t i = 1; i < ends.size(); ++i) fractions.push_back(ends[i] - ends[i - 1]);
  return fractions;
}

/// Moves places to the new segments, whose ends are among the old ones or the other way round:
/// else the values of three divisions would not lie on one curve of N.
class Places {
 public:
  /// @param from  the ends of the old segments
  Places(std::vector<double> from, const Scene& to)
      : from_(std::move(from)),
        to_(to.end_rule == EndRule::Half ? segment_ends(to) : bare_ends(to)) {}

  void move(Place& place) const { place = {fraction_of(place, from_), {}}; }

  void move_end(Place& place, const std::string& name) const {
    const bool was_end = segment_end_at(place, from_).has_value();
    move(place);
    if (!was_end || segment_end_at(place, to_)) return;
    throw InputError({}, name, "", "would fall within a segment");
  }

 private:
  std::vector<double> from_, to_;
};

std::string name_of(const char* list, std::size_t index, const char* key) {
  return std::string(list) + "[" + std::to_string(index + 1) + "]." + key;
}

void move_places(std::vector<double> from, Setup& setup) {
  Scene& scene = setup.scene;
  const Places places(std::move(from), scene);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    places.move_end(scene.supports[i].at, name_of("support", i, "at"));
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    places.move_end(scene.loads[i].at, name_of("load", i, "at"));
    if (scene.loads[i].to) places.move_end(*scene.loads[i].to, name_of("load", i, "to"));
  }
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    places.move_end(scene.masses[i].at, name_of("mass", i, "at"));
  }
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    places.move_end(scene.regions[i].from, name_of("region", i, "from"));
    places.move_end(scene.regions[i].to, name_of("region", i, "to"));
  }
  for (InitialMotion& motion : scene.initial_motions) {
    places.move(motion.from);
    places.move(motion.to);
    places.move(motion.about);
  }
  for (Cut& cut : scene.cuts) places.move(cut.at);
  for (Probe& probe : scene.probes) places.move(probe.at);
  if (setup.solver.control_at) places.move(*setup.solver.control_at);
}

}  // namespace

Setup remeshed(const Setup& setup, Division division) {
  const Scene& original = setup.scene;
  if (!original.beam.joint_lengths.empty()) {
    throw InputError({}, "beam.joint_lengths", "", "are given for each joint");
  }
  Setup made = setup;
  made.scene.beam.segments = divided(original, division);
  std::vector<double> ends = segment_ends(original);
  made.scene.beam.segment_fractions = divided(uneven_fractions(original, ends), division);
  move_places(std::move(ends), made);
  return made;
}

Setup remeshed(const WeightedTarget& weighted, Division division) {
  const SceneTarget& target = weighted.target;
  for (const Probe& probe : weighted.setup.scene.probes) {
    const bool over = target.kind == Abscissa::Probe && probe.name == target.abscissa_probe;
    if (!over && probe.name != target.ordinate_probe) continue;
    if (!is_angle_of_joint(probe.quantity)) continue;
    throw InputError({}, "probe", probe.name,
                     "is the angle of one joint, which follows its length");
  }
  return remeshed(weighted.setup, division);
}

double order_of_joints(const Scene& scene) {
  return resolved_end_rule(scene) == EndRule::Equal ? 1.0 : 2.0;
}

}  // namespace plastica::calibrate
