#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/support_kind.hpp"

/// Hinges within the beam: a hinge stands in place of a joint and lets its two sides bend freely.
/// What acts on a point of the beam there acts on both sides; what turns or follows a segment would
/// be on one side of it, and which one, nothing says.
namespace plastica::model_detail {
namespace {

using Vector = std::array<double, 3>;

constexpr std::string_view kBeside = "give it a place beside the hinge";

void check_place_of_hinge(const Support& hinge, Ends ends, const std::string& name) {
  const auto node = segment_end_at(hinge.at, ends);
  if (node && *node > 0 && static_cast<std::size_t>(*node) + 1 < ends.size()) return;
  throw InputError({}, name + ".at", place_text(hinge.at),
                   node ? "a hinge must be within the beam; at an end, a pin lets it turn"
                        : "a hinge must be at a segment's end");
}

/// Along the beam at a hinge: halfway between its two segments, as the hinge's own axes are.
Vector axis_at(const Beam& beam, std::size_t node, Ends ends) {
  Vector sum{};
  for (const std::size_t end : {node, node + 1}) {
    const Vector a = axis_point(beam, ends[end - 1]);
    const Vector b = axis_point(beam, ends[end]);
    const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += (b[k] - a[k]) / length;
  }
  const double length = std::hypot(sum[0], sum[1], sum[2]);
  for (double& part : sum) part /= length;
  return sum;
}

/// Whether a vector has a part across an axis that is more than rounding.
bool is_across(const Vector& vector, const Vector& axis) {
  const double along = vector[0] * axis[0] + vector[1] * axis[1] + vector[2] * axis[2];
  const double all = std::hypot(vector[0], vector[1], vector[2]);
  return all * all - along * along > 1e-12 * all * all;
}

void check_other_supports(const Scene& scene, std::size_t hinge, const Vector& axis,
                          double fraction, Ends ends) {
  const std::string name = item_name("support", hinge);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& other = scene.supports[i];
    if (i == hinge || other.to || fraction_of(other.at, ends) != fraction) continue;
    const std::string field = item_name("support", i, ".at");
    if (traits_of(other).releases) {
      if (i < hinge) continue;  // said of the second one
      throw InputError({}, field, place_text(other.at), name + " is a hinge at the same place");
    }
    const HeldFreedoms held = other.held();
    for (std::size_t k = 0; k < 3; ++k) {
      Vector about{};
      about[k] = 1.0;
      const bool resists = held[3 + k] || other.rotational_stiffness[k] > 0.0;
      if (!resists || !is_across(about, axis)) continue;
      throw InputError({}, field, place_text(other.at),
                       "a rotation is held at a hinge (" + name +
                           " is at the same place): " + std::string(kBeside));
    }
  }
}

void check_loads(const Scene& scene, const Vector& axis, double fraction, Ends ends) {
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const Load& load = scene.loads[i];
    if (load.to || fraction_of(load.at, ends) != fraction) continue;
    if (load.moment != Vector{} && is_across(load.moment, axis)) {
      throw InputError({}, item_name("load", i, ".moment"), "",
                       "acts at a hinge: " + std::string(kBeside));
    }
    if (load.follows) {
      throw InputError({}, item_name("load", i, ".follows"), "true",
                       "would follow one of the two sides of a hinge: " + std::string(kBeside));
    }
  }
}

void check_masses_at(const Scene& scene, double fraction, Ends ends) {
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    const PointMass& mass = scene.masses[i];
    if (!mass.has_rotational_inertia() || fraction_of(mass.at, ends) != fraction) continue;
    throw InputError({}, item_name("mass", i, ".inertia"), "",
                     "turns with one of the two sides of a hinge: " + std::string(kBeside));
  }
}

void check_probes_at(const Scene& scene, double fraction, Ends ends) {
  const auto has_support = [&] {
    for (const Support& support : scene.supports) {
      const bool here = !support.to && fraction_of(support.at, ends) == fraction;
      if (here && !traits_of(support).releases) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const Probe& probe = scene.probes[i];
    const bool has_place = is_of_joint(probe.quantity) ||
                           probe.quantity == ProbeQuantity::Reaction ||
                           probe.quantity == ProbeQuantity::ReactionMoment;
    if (!has_place || fraction_of(probe.at, ends) != fraction) continue;
    const std::string word(probe_kinds()[static_cast<std::size_t>(probe.quantity)]);
    switch (probe.quantity) {
      case ProbeQuantity::Strain:
      case ProbeQuantity::PlasticStrain:
      case ProbeQuantity::AccumulatedStrain:
      case ProbeQuantity::LocalPlasticStrain:
      case ProbeQuantity::LocalAccumulatedStrain:
        throw InputError(
            {}, item_name("probe", i, ".kind"), word,
            "is none where the beam turns freely, at a hinge: \"angle\" is by how much");
      case ProbeQuantity::Reaction:
      case ProbeQuantity::ReactionMoment:
        if (has_support()) break;
        throw InputError({}, item_name("probe", i, ".kind"), word,
                         "is none at a hinge, which holds nothing to the ground: \"force\" is what "
                         "goes through it");
      default: break;
    }
  }
}

}  // namespace

void check_hinges(const Scene& scene, Ends ends) {
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& hinge = scene.supports[i];
    if (!traits_of(hinge).releases) continue;
    check_place_of_hinge(hinge, ends, item_name("support", i));
    const double fraction = fraction_of(hinge.at, ends);
    const auto node = static_cast<std::size_t>(*segment_end_at(hinge.at, ends));
    const Vector axis = axis_at(scene.beam, node, ends);
    check_other_supports(scene, i, axis, fraction, ends);
    check_loads(scene, axis, fraction, ends);
    check_masses_at(scene, fraction, ends);
    check_probes_at(scene, fraction, ends);
  }
}

}  // namespace plastica::model_detail
