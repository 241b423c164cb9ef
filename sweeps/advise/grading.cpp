#include "sweeps/advise/grading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plastica/model/beam_axis.hpp"

namespace plastica::sweeps {
namespace {

/// Of the mean change of the curvature: so much counts where it does not change. The cube root of
/// 0.03 is 0.31.
constexpr double kFloor = 0.03;

/// How fast the curvature changes over each segment, of each stretch between needed ends by itself:
/// at a hinge, or where the section changes, it jumps, which costs nothing. [rad per length^2]
std::vector<double> changes_of_curvature(const std::vector<double>& bent,
                                         const std::vector<double>& ends,
                                         const std::vector<double>& needed) {
  std::vector<double> change(ends.size() - 1, 0.0);
  const auto curvature = [&](std::size_t i) {
    return bent[i] / (0.5 * (ends[i + 1] - ends[i - 1]));
  };
  std::size_t first = 0;
  for (std::size_t stretch = 1; stretch < needed.size(); ++stretch) {
    const auto found = segment_end_at({needed[stretch], {}}, ends);
    if (!found) continue;  // a place within a segment: the stretch goes on
    const auto last = static_cast<std::size_t>(*found);
    for (std::size_t i = first + 2; i < last; ++i) {
      change[i - 1] = std::abs(curvature(i) - curvature(i - 1)) / (ends[i] - ends[i - 1]);
    }
    // How much of a length an end's joint stands for is a rule of its own: on as within.
    if (last >= first + 3) {
      change[first] = change[first + 1];
      change[last - 1] = change[last - 2];
    }
    first = last;
  }
  return change;
}

/// How many segments come before each end: its cumulative density, 0 … 1.
std::vector<double> cumulative_density(const std::vector<double>& change,
                                       const std::vector<double>& ends) {
  const std::size_t count = change.size();
  std::vector<double> smooth(count);
  double mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double before = change[i > 0 ? i - 1 : i];
    const double after = change[i + 1 < count ? i + 1 : i];
    smooth[i] = (before + change[i] + after) / 3.0;
    mean += smooth[i] * (ends[i + 1] - ends[i]);
  }
  std::vector<double> sum(ends.size());
  if (!(mean > 0.0) || !std::isfinite(mean)) return {};
  for (std::size_t i = 0; i < count; ++i) {
    sum[i + 1] = sum[i] + std::cbrt(smooth[i] / mean + kFloor) * (ends[i + 1] - ends[i]);
  }
  for (double& each : sum) each /= sum[count];
  return sum;
}

/// Where a line through points is at an x; both rise.
double on_line(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::upper_bound(xs.begin() + 1, xs.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - xs.begin());
  const double part = (x - xs[k - 1]) / (xs[k] - xs[k - 1]);
  return ys[k - 1] + part * (ys[k] - ys[k - 1]);
}

/// Places in their order, the last one the beam's end.
std::vector<double> each_once(std::vector<double> places) {
  constexpr double kSamePlace = 1e-9;
  std::sort(places.begin(), places.end());
  const auto same = [](double a, double b) { return b - a <= kSamePlace; };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  places.back() = 1.0;
  return places;
}

/// Where segments are to end: where the scene needs it, where it looks, where it cuts, and where
/// what moves at first begins and ends. What a probe within a segment sees goes with the place in
/// it, in a beam with each segment divided, too.
std::vector<double> wanted_ends(const Scene& scene, const std::vector<double>& ends) {
  std::vector<double> wanted = needed_ends(scene);
  const auto add = [&](const Place& place) { wanted.push_back(fraction_of(place, ends)); };
  for (const Probe& probe : scene.probes) add(probe.at);
  for (const Cut& cut : scene.cuts) add(cut.at);
  for (const InitialMotion& motion : scene.initial_motions) {
    add(motion.from);
    add(motion.to);
  }
  return each_once(std::move(wanted));
}

/// Whether a probe is of a place along the beam, where its error depends on how far that is from
/// the segments' ends: of a joint it is that of the nearest one; within a segment, which is
/// straight, a point is off by c(t) h^2 with another c at each fraction t, and half as long
/// segments have another t.
bool is_of_place(ProbeQuantity quantity) {
  switch (quantity) {
    case ProbeQuantity::Displacement:
    case ProbeQuantity::Rotation:
    case ProbeQuantity::Velocity:
    case ProbeQuantity::Spin: return true;
    default: return is_of_joint(quantity);
  }
}

/// How many segments each stretch between wanted ends gets: at least one, else by its part.
std::vector<int> dealt(const std::vector<double>& density_at, int segments) {
  const std::size_t stretches = density_at.size() - 1;
  const auto wanted = [&](std::size_t j) { return (density_at[j + 1] - density_at[j]) * segments; };
  std::vector<int> counts(stretches, 1);
  for (int left = segments - static_cast<int>(stretches); left > 0; --left) {
    std::size_t most = 0;  // whose segments are the longest for their density
    for (std::size_t j = 1; j < stretches; ++j) {
      if (wanted(j) / counts[j] > wanted(most) / counts[most]) most = j;
    }
    ++counts[most];
  }
  return counts;
}

}  // namespace

std::vector<double> graded_fractions(const Scene& scene, const std::vector<double>& bent,
                                     int segments) {
  const std::vector<double> ends = segment_ends(scene);
  if (ends.size() < 4 || ends.size() != bent.size()) return {};
  const std::vector<double> wanted = wanted_ends(scene, ends);
  if (segments + 1 < static_cast<int>(wanted.size())) return {};
  const std::vector<double> sum =
      cumulative_density(changes_of_curvature(bent, ends, needed_ends(scene)), ends);
  if (sum.empty()) return {};
  std::vector<double> density_at;
  density_at.reserve(wanted.size());
  for (const double place : wanted) density_at.push_back(on_line(ends, sum, place));
  const std::vector<int> counts = dealt(density_at, segments);
  // Ends with few digits, for who reads them; a thousandth of a segment does not matter.
  const double digits = std::pow(10.0, 3.0 + std::ceil(std::log10(segments)));
  std::vector<double> fractions;
  double before = 0.0;
  for (std::size_t j = 0; j + 1 < wanted.size(); ++j) {
    for (int i = 1; i <= counts[j]; ++i) {
      const double part = static_cast<double>(i) / counts[j];
      const double at = on_line(sum, ends, std::lerp(density_at[j], density_at[j + 1], part));
      const double end = i == counts[j] ? wanted[j + 1] : std::round(at * digits) / digits;
      if (!(end > before)) return {};
      fractions.push_back(end - before);
      before = end;
    }
  }
  return fractions;
}

std::vector<double> fractions_that_end_at_probes(const Scene& scene) {
  const std::vector<double> ends = segment_ends(scene);
  if (ends_at_probes(scene)) return {};
  std::vector<double> wanted = needed_ends(scene);
  for (const Probe& probe : scene.probes) {
    if (is_of_place(probe.quantity)) wanted.push_back(fraction_of(probe.at, ends));
  }
  wanted = each_once(std::move(wanted));
  if (scene.beam.segments + 1 < static_cast<int>(wanted.size())) return {};
  const std::vector<int> counts = dealt(wanted, scene.beam.segments);
  std::vector<double> fractions;
  for (std::size_t j = 0; j + 1 < wanted.size(); ++j) {
    const double length = (wanted[j + 1] - wanted[j]) / counts[j];
    fractions.insert(fractions.end(), static_cast<std::size_t>(counts[j]), length);
  }
  return fractions;
}

bool ends_at_probes(const Scene& scene) {
  const std::vector<double> ends = segment_ends(scene);
  return std::ranges::all_of(scene.probes, [&](const Probe& probe) {
    return !is_of_place(probe.quantity) || segment_end_at(probe.at, ends);
  });
}

Scene with_divided_segments(const Scene& scene, int parts) {
  const std::vector<double> own = segment_ends(scene);
  std::vector<double> ends;
  for (std::size_t i = 0; i + 1 < own.size(); ++i) {
    for (int k = 0; k < parts; ++k) {
      ends.push_back(std::lerp(own[i], own[i + 1], static_cast<double>(k) / parts));
    }
  }
  ends.push_back(1.0);
  for (const Probe& probe : scene.probes) {
    if (is_of_place(probe.quantity)) ends.push_back(fraction_of(probe.at, own));
  }
  ends = each_once(std::move(ends));
  Scene made = scene;
  made.beam.segments = static_cast<int>(ends.size()) - 1;
  made.beam.segment_fractions.clear();
  const bool sets_lengths =
      scene.end_rule == EndRule::Half || scene.end_rule == EndRule::ThreeHalves;
  const std::vector<double> even = segment_ends(made);
  const auto is_there = [&](double end) { return segment_end_at({end, {}}, even).has_value(); };
  if (sets_lengths || std::ranges::all_of(ends, is_there)) return made;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    made.beam.segment_fractions.push_back(ends[i] - ends[i - 1]);
  }
  return made;
}

std::vector<double> divided_evenly(const std::vector<double>& fractions, int parts) {
  std::vector<double> all;
  all.reserve(fractions.size() * static_cast<std::size_t>(parts));
  for (const double fraction : fractions) {
    all.insert(all.end(), static_cast<std::size_t>(parts), fraction / parts);
  }
  return all;
}

}  // namespace plastica::sweeps
