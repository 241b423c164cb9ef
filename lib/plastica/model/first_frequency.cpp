#include "plastica/model/first_frequency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

using std::numbers::pi;

/// Freedoms of supports (HeldFreedoms).
constexpr std::size_t kAlong = 2;
constexpr std::size_t kTwist = 5;

/// How a point of the beam is held in one plane, or against twist: `rotation` alone.
struct Hold {
  bool across = false;
  bool rotation = false;

  std::size_t row() const { return (across ? 1U : 0U) + (rotation ? 2U : 0U); }
};

/// beta L of the first mode that bends, by the ends: free, pinned, guided, clamped.
constexpr std::array<std::array<double, 4>, 4> kBetaL{{{4.7300, 3.9266, 2.3650, 1.8751},
                                                       {3.9266, pi, pi / 2.0, 3.9266},
                                                       {2.3650, pi / 2.0, pi, 2.3650},
                                                       {1.8751, 3.9266, 2.3650, 4.7300}}};

/// Holds by their fraction of the length, both ends included.
/// @param across, rotation  the freedoms of a support that count
std::map<double, Hold> holds_of(const Scene& scene, std::span<const double> ends,
                                std::size_t across, std::size_t rotation) {
  std::map<double, Hold> holds{{0.0, {}}, {1.0, {}}};
  for (const Support& support : scene.supports) {
    const HeldFreedoms held = support.held();
    if (!held[across] && !held[rotation]) continue;
    Hold& hold = holds[fraction_of(support.at, ends)];
    hold.across = hold.across || held[across];
    hold.rotation = hold.rotation || held[rotation];
  }
  return holds;
}

/// The smallest (beta L)^2 over the square of its stretch's fraction of the length.
double bending_number(const Scene& scene, std::span<const double> ends, BendingAxis axis) {
  const bool about_x = axis == BendingAxis::X;
  const auto holds = holds_of(scene, ends, about_x ? 1 : 0, about_x ? 3 : 4);
  double smallest = 0.0;
  auto from = holds.begin();
  for (auto to = std::next(from); to != holds.end(); ++to) {
    const bool last = std::next(to) == holds.end();
    if (!last && !to->second.across) continue;
    Hold start = from->second;
    Hold end = to->second;
    if (from != holds.begin() && !end.across) start.rotation = true;
    if (!last && !start.across) end.rotation = true;
    const double stretch = to->first - from->first;
    const double beta = kBetaL[start.row()][end.row()] / stretch;
    if (smallest == 0.0 || beta * beta < smallest) smallest = beta * beta;
    from = to;
  }
  return smallest;
}

/// omega L/c of the first swing of a rod, which twists or stretches with waves of speed c.
/// @param freedom  of a support that holds it
double rod_number(const Scene& scene, std::span<const double> ends, std::size_t freedom) {
  const auto holds = holds_of(scene, ends, freedom, freedom);
  double smallest = 0.0;
  for (auto from = holds.begin(), to = std::next(from); to != holds.end(); ++from, ++to) {
    const bool same = from->second.rotation == to->second.rotation;
    const double number = (same ? pi : pi / 2.0) / (to->first - from->first);
    if (smallest == 0.0 || number < smallest) smallest = number;
  }
  return smallest;
}

FirstFrequency torsion_of(const Scene& scene, const SectionProperties& section,
                          std::span<const double> ends) {
  const double polar = section.second_moment_x + section.second_moment_y;
  const double speed = std::sqrt(resolved_shear_modulus(scene.material) * section.torsion_constant /
                                 (scene.material.density * polar));
  return {rod_number(scene, ends, kTwist) * speed / scene.beam.length / (2.0 * pi),
          Vibration::Torsion, !scene.masses.empty()};
}

FirstFrequency stretch_of(const Scene& scene, std::span<const double> ends) {
  const double speed = std::sqrt(scene.material.youngs_modulus / scene.material.density);
  return {rod_number(scene, ends, kAlong) * speed / scene.beam.length / (2.0 * pi),
          Vibration::Stretch, !scene.masses.empty()};
}

/// Whether point masses make of a beam a spring, whose own swings are small beside theirs.
bool is_spring_of_masses(const Scene& scene, const SectionProperties& section, bool twists) {
  double all = 0.0;
  for (const PointMass& one : scene.masses) {
    all += twists ? *std::ranges::max_element(one.inertia) : one.mass;
  }
  const double polar = section.second_moment_x + section.second_moment_y;
  return all > scene.material.density * scene.beam.length * (twists ? polar : section.area);
}

/// Whether the part of a vector along the axis at a place is a notable one.
bool is_along_axis(const Scene& scene, const std::array<double, 3>& vector, const Place& place,
                   std::span<const double> ends) {
  constexpr double kNotable = 0.1;
  constexpr double kOnEachSide = 1e-6;  // of the length
  const double at = fraction_of(place, ends);
  const auto from = axis_point(scene.beam, std::max(0.0, at - kOnEachSide));
  const auto to = axis_point(scene.beam, std::min(1.0, at + kOnEachSide));
  double along = 0.0;
  double distance = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += vector[k] * (to[k] - from[k]);
    distance += (to[k] - from[k]) * (to[k] - from[k]);
    size += vector[k] * vector[k];
  }
  return std::fabs(along) > kNotable * std::sqrt(distance * size);
}

/// Whether what follows a history makes a beam swing with a period about the equilibrium that it
/// asks for. Where the factor f jumps the amplitude is the jump, where its slope jumps by s it is
/// s T/(2 pi): that of an oscillator without damping.
/// @param duration  of the motion [s]: what comes later neither shakes nor is it reached
bool shakes(const History& history, double period, double duration) {
  constexpr double kNotable = 0.02;  // of the largest
  double largest = std::fabs(history.at(duration));
  for (std::size_t i = 0; i < history.time.size() && history.time[i] < duration; ++i) {
    largest = std::max(largest, std::fabs(history.factor[i]));
  }
  double amplitude = std::fabs(history.at(0.0));
  double before = 0.0;
  const auto look_at = [&](double slope) {
    amplitude = std::max(amplitude, std::fabs(slope - before) * period / (2.0 * pi));
  };
  look_at(history.slope_at(0.0));
  for (const double time : history.time) {
    if (time <= 0.0) continue;
    if (time >= duration) break;
    const History::SlopeChange change = history.slopes_about(time, 1e-9 * time);
    before = change.before;
    look_at(change.after);
  }
  return amplitude > kNotable * largest;
}

/// Whether loads, supports or an initial motion make the beam twist or stretch in swings.
bool is_excited(const Scene& scene, const FirstFrequency& first, double duration,
                std::span<const double> ends) {
  const bool twists = first.of == Vibration::Torsion;
  const double period = 1.0 / first.hertz;
  for (const Load& load : scene.loads) {
    const bool acts = is_along_axis(scene, twists ? load.moment : load.force, load.at, ends);
    if (acts && shakes(load.history, period, duration)) return true;
  }
  bool is_held = false;
  for (const Support& support : scene.supports) {
    is_held = is_held || support.held()[twists ? kTwist : kAlong];
    const auto& motion = twists ? support.rotation : support.translation;
    if (is_along_axis(scene, motion, support.at, ends) &&
        shakes(support.history, period, duration)) {
      return true;
    }
  }
  return std::ranges::any_of(scene.initial_motions, [&](const InitialMotion& one) {
    const bool is_whole =
        fraction_of(one.from, ends) == 0.0 && fraction_of(one.to, ends) == 1.0 && !is_held;
    return !is_whole && is_along_axis(scene, twists ? one.spin : one.velocity, one.to, ends);
  });
}

}  // namespace

std::string frequency_text(const FirstFrequency& first) {
  const char* const of = first.of == Vibration::Bending   ? "bending"
                         : first.of == Vibration::Torsion ? "torsion"
                                                          : "stretching";
  return std::string("first frequency in ") + of + ", about " + figure(first.hertz) + " Hz" +
         (first.leaves_masses ? " without its point masses" : "");
}

std::optional<FirstFrequency> first_frequency(const Scene& scene, const LevelChoice& level,
                                              const SectionProperties& section,
                                              std::span<const double> ends) {
  if (scene.beam.segments < 2) return std::nullopt;
  const Material& material = scene.material;
  const double length = scene.beam.length;
  if (level.level == Level::Twist) return torsion_of(scene, section, ends);
  const auto omega = [&](BendingAxis axis, double area_moment) {
    return bending_number(scene, ends, axis) / (length * length) *
           std::sqrt(material.youngs_modulus * area_moment / (material.density * section.area));
  };
  const double about_x = omega(BendingAxis::X, section.second_moment_x);
  const double about_y = omega(BendingAxis::Y, section.second_moment_y);
  double first = std::min(about_x, about_y);
  if (level.level == Level::Planar) first = level.bending == BendingAxis::X ? about_x : about_y;
  return FirstFrequency{first / (2.0 * pi), Vibration::Bending, !scene.masses.empty()};
}

std::vector<FirstFrequency> excited_frequencies(const Scene& scene, const LevelChoice& level,
                                                const ExcitedMotion& motion,
                                                const SectionProperties& section,
                                                std::span<const double> ends) {
  std::vector<FirstFrequency> all;
  if (scene.beam.segments < 2 || level.level == Level::Twist) return all;
  const auto look_at = [&](const FirstFrequency& first) {
    const bool is_spring = is_spring_of_masses(scene, section, first.of == Vibration::Torsion);
    if (!is_spring && is_excited(scene, first, motion.duration, ends)) all.push_back(first);
  };
  if (level.level == Level::Spatial) look_at(torsion_of(scene, section, ends));
  if (motion.translation == JointTranslation::Elastic) look_at(stretch_of(scene, ends));
  return all;
}

}  // namespace plastica::model_detail
