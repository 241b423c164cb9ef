#include "calibrate/engine/engine_notes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/version.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::calibrate {
namespace {

void note_yield(const Scene& scene, EngineBeam& beam) {
  const auto& hardening = scene.material.hardening;
  switch (scene.yield_model) {
    case YieldModel::Elastic:
      beam.notes.emplace_back("the scene is elastic: nothing yields or breaks");
      return;
    case YieldModel::PerAxis: break;
    case YieldModel::Interaction:
    case YieldModel::Conservative:
      beam.notes.emplace_back(
          "the scene's yield surface lets the moments of a joint act together; the caps here are "
          "those of each moment alone, too strong where several act");
      break;
    case YieldModel::Fibre:
      beam.notes.emplace_back(fmt::format(
          "the scene's fibre sections go on from the first-yield moments given here up to {:.4g}, "
          "{:.4g} and {:.4g} times as much about x, y and z",
          beam.regions[0].properties.plastic_section_modulus_x /
              beam.regions[0].properties.section_modulus_x,
          beam.regions[0].properties.plastic_section_modulus_y /
              beam.regions[0].properties.section_modulus_y,
          beam.regions[0].properties.plastic_torsion_modulus /
              beam.regions[0].properties.torsion_modulus));
      break;
  }
  if (hardening.law == HardeningLaw::Linear) {
    beam.notes.emplace_back(fmt::format(
        "linear hardening, {:g} of it kinematic: behind first yield a joint has the hardened "
        "stiffness",
        hardening.kinematic_fraction));
  } else if (hardening.law != HardeningLaw::Ideal) {
    beam.notes.emplace_back(fmt::format("{} is left out: the moments are those of first yield",
                                        hardening_kind(hardening.law).phrase()));
  }
  const RateDependence& rate = scene.material.rate;
  if (rate.law == RateLaw::None) return;
  if (rate.strain_rate) {
    beam.notes.emplace_back(
        fmt::format("moments are those at a strain rate of {:g} 1/s", *rate.strain_rate));
  } else {
    beam.notes.emplace_back(
        "the rate law is left out: the moments are those at rest, and faster they would be larger");
  }
}

void note_supports(const Scene& scene, const std::vector<EngineSegment>& segments,
                   EngineBeam& beam) {
  std::vector<double> ends{0.0};
  for (const EngineSegment& segment : segments) ends.push_back(ends.back() + segment.length);
  for (double& end : ends) end /= scene.beam.length;
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& support = scene.supports[i];
    const auto place = [&] {
      return fmt::format("support[{}] at {:g} m", i + 1,
                         fraction_of(support.at, ends) * scene.beam.length);
    };
    const SupportTraits& kind = traits_of(support);
    if (kind.one_sided) {
      beam.notes.push_back(place() + " only pushes: left out");
    } else if (kind.normal && is_oblique(support.normal)) {
      beam.notes.push_back(place() +
                           " holds along its normal alone, which is no axis: left out, so that the "
                           "beam is free there");
    }
    if (kind.springs) beam.notes.push_back(place() + " has springs to the ground: left out");
    if (support.moves()) beam.notes.push_back(place() + " moves: here it stands still");
  }
}

/// "k_x = …" of one region, with its numbers.
void describe_region(const EngineBeam& beam, std::size_t index, std::vector<std::string>& lines) {
  const EngineRegion& region = beam.regions[index];
  const SectionProperties& p = region.properties;
  const Material& m = region.material;
  const std::string name = one_line(shown_name(m));
  lines.push_back(written("{}{}", index == 0 ? "Beam" : written("region[{}]", index),
                          name.empty() ? "" : ": " + name));
  lines.push_back(written("  E = {} Pa, G = {} Pa, rho = {} kg/m^3", m.youngs_modulus,
                          resolved_shear_modulus(m), m.density));
  if (beam.yield_model != YieldModel::Elastic) {
    const bool report = beam.formulas == Formulas::Report;
    lines.push_back(written(
        "  sigma_y = {} Pa, tau_y = {} Pa", m.yield_stress,
        report ? m.shear_yield_stress.value_or(m.yield_stress) : resolved_shear_yield_stress(m)));
  }
  lines.push_back(written("  A = {} m^2, I_x = {} m^4, I_y = {} m^4, J = {} m^4", p.area,
                          p.second_moment_x, p.second_moment_y, p.torsion_constant));
  lines.push_back(written("  W_x = {} m^3, W_y = {} m^3, W_t = {} m^3", p.section_modulus_x,
                          p.section_modulus_y, p.torsion_modulus));
  lines.push_back(written("  f = {}, c = {}", digits(region.stiffness_factor, ", "),
                          digits(region.cap_factor, ", ")));
}

/// "0.03 m", or "0.03, 0.02, 0.03 m about x, y, z".
std::string hinge_text(const std::array<double, 3>& lengths) {
  const auto& [x, y, z] = lengths;
  if (x == y && x == z) return written("{} m", x);
  return written("{}, {}, {} m about x, y, z", x, y, z);
}

void describe_break(const EngineBeam& beam, std::vector<std::string>& lines) {
  if (!beam.breaks) {
    lines.emplace_back("  break: no limit is given, nothing breaks");
    return;
  }
  if (beam.formulas == Formulas::Report) {
    lines.emplace_back(
        "  break angle [rad], permanent: eps l/h = sin(theta/2) about x, with b about y; "
        "gamma l/(c/2) about z, c the longer side");
    return;
  }
  lines.push_back(written(
      "  break angle [rad], permanent: eps a/(h/2) about x, eps a/(b/2) about y, gamma a W_t/J "
      "about z, a = {}, L_p = {}",
      beam.break_length, hinge_text(beam.hinge_lengths)));
  if (beam.break_length != "l") {
    lines.emplace_back(
        "    of a joint that turns alone; where its neighbours turn too, plastica counts what a "
        "length L_p turns in all");
  }
  const Material& m = beam.regions[0].material;
  const auto limit = [](const std::optional<double>& value) {
    return value ? digits(*value) : std::string("none");
  };
  lines.push_back(written("    of the material: eps = {}, gamma = {}", limit(m.break_strain),
                          limit(resolved_break_shear_strain(m))));
}

}  // namespace

void add_scene_notes(const Scene& scene, const SolverOptions& options, EngineBeam& beam) {
  note_yield(scene, beam);
  if (options.translation == JointTranslation::Elastic) {
    beam.notes.emplace_back("stretch and shear of the joints are left out: translations are rigid");
  }
  note_supports(scene, beam.segments, beam);
  if (beam.carries_masses) {
    beam.notes.emplace_back(
        "point masses are in the mass, center and inertia of the segments that carry them");
  }
}

std::vector<std::string> comment_lines(const EngineBeam& beam) {
  std::vector<std::string> lines;
  lines.push_back(written("{}: a lumped beam of {} rigid segments; plastica {}",
                          beam.name.empty() ? "beam" : one_line(beam.name), beam.segments.size(),
                          version()));
  lines.emplace_back("SI units: m, kg, s, N, rad. z runs along the beam, b is its width along x,");
  lines.emplace_back("h its height along y; about x and y it bends, about z it is twisted.");
  for (std::size_t region = 0; region < beam.regions.size(); ++region)
    describe_region(beam, region, lines);
  lines.emplace_back("A joint of tributary length l = (L_a + L_b)/2, or as the scene gives it; at");
  lines.emplace_back("an end that is held against rotation a half joint, l = L/2:");
  lines.emplace_back("  stiffness [N m/rad]: f_x E I_x/l, f_y E I_y/l, f_z G J/l");
  if (beam.regions.size() > 1) {
    lines.emplace_back("    between two regions both halves give way, each by its own share of l");
  }
  if (beam.yield_model != YieldModel::Elastic) {
    lines.push_back(written(
        "  yield moment [N m]: c_x sigma_y W_x, c_y sigma_y W_y, c_z tau_y W_t ({})",
        beam.yield_cap == YieldCap::FullyPlastic ? "the whole section yields" : "first yield"));
    describe_break(beam, lines);
  }
  lines.emplace_back(
      "A segment: mass rho A L; inertia m L^2/12 + rho I_x L about x, with I_y about");
  lines.emplace_back("y, rho (I_x + I_y) L about z.");
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> own{};
    own[k] = 1.0;
    if (beam.scene_axes[k] == own) continue;
    lines.push_back(fmt::format("Turned: the scene's {} is along ({}).", "xyz"[k],
                                digits(beam.scene_axes[k], ", ")));
  }
  for (const std::string& note : beam.notes) lines.push_back("Note: " + one_line(note));
  lines.emplace_back("Loads are not part of the beam.");
  return lines;
}

std::string comment(const EngineBeam& beam, std::string_view sign) {
  std::string text;
  for (const std::string& line : comment_lines(beam)) text += written("{} {}\n", sign, line);
  return text;
}

std::string digits(double value) { return fmt::format("{:.14g}", value); }

std::string digits(std::span<const double> values, std::string_view separator) {
  return fmt::format("{:.14g}", fmt::join(values, separator));
}

std::array<double, 4> quaternion(const EngineAxes& axes) {
  const auto m = [&](std::size_t row, std::size_t column) { return axes[column][row]; };
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  // The largest of w, x, y, z first, so that nothing small is divided by.
  std::array<double, 4> squares{1.0 + trace, 1.0 + 2.0 * m(0, 0) - trace,
                                1.0 + 2.0 * m(1, 1) - trace, 1.0 + 2.0 * m(2, 2) - trace};
  const auto largest =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double twice = std::sqrt(squares[largest]);
  const double scale = 0.5 / twice;
  std::array<double, 4> q{};
  q[largest] = 0.5 * twice;
  if (largest == 0) {
    q[1] = scale * (m(2, 1) - m(1, 2));
    q[2] = scale * (m(0, 2) - m(2, 0));
    q[3] = scale * (m(1, 0) - m(0, 1));
    return q;
  }
  const std::size_t i = largest - 1;
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  q[0] = scale * (m(k, j) - m(j, k));
  q[1 + j] = scale * (m(j, i) + m(i, j));
  q[1 + k] = scale * (m(k, i) + m(i, k));
  return q;
}

EngineAxes seen_from(const EngineAxes& frame, const EngineAxes& axes) {
  EngineAxes seen;
  for (std::size_t axis = 0; axis < 3; ++axis) seen[axis] = seen_from(frame, axes[axis]);
  return seen;
}

std::array<double, 3> seen_from(const EngineAxes& frame, const std::array<double, 3>& vector) {
  std::array<double, 3> seen{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) seen[axis] += frame[axis][k] * vector[k];
  }
  return seen;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = ' ';
  }
  // XML ends a comment at two hyphens.
  for (std::size_t at = line.find("--"); at != std::string::npos; at = line.find("--", at)) {
    line.replace(at, 2, "- ");
  }
  return line;
}

}  // namespace plastica::calibrate
