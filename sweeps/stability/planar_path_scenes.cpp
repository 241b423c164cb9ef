#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plastica/theory/cantilever.hpp"
#include "plastica/theory/elastica.hpp"
#include "plastica/theory/lumped_chain.hpp"
#include "plastica/theory/polygon.hpp"
#include "sweeps/stability/base_scene.hpp"
#include "sweeps/stability/scene_parts.hpp"

namespace plastica::sweeps::stability {
namespace {

using namespace parts;
using theory::ChainConvention;

/// Tip deflection over L of the elastica under alpha = P L^2/(E I). Beyond 1e4 all but a boundary
/// layer of sqrt(E I/P) hangs straight down.
double elastica_tip(double alpha) {
  constexpr double kMax = 1e4;
  if (alpha <= kMax) return theory::elastica_tip_force(alpha).deflection;
  return 1.0 - (1.0 - theory::elastica_tip_force(kMax).deflection) * std::sqrt(kMax / alpha);
}

/// Adds what is known of the tip under a force across it: of the chain where deflections are small,
/// of the beam always.
void expect_tip(StabilityCase& made, double force, double ratio) {
  const Scene& scene = made.setup.scene;
  const double L = scene.beam.length;
  const double I = section_properties(scene.section, scene.material.poisson_ratio).second_moment_x;
  const double alpha = force * L * L / (scene.material.youngs_modulus * I);
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double beam = elastica_tip(alpha) * L;
  Reference reference{.what = "tip deflection", .probe = tip, .value = beam, .size = beam};
  if (alpha <= 0.1) {
    // Finite rotations take the same fraction of both.
    reference.value = ratio * beam;
    reference.tolerance = 1e-9 + 0.05 * alpha * alpha;
    reference.continuum = beam;
  } else {
    // The balance of its joints is audited; the chain's own deflection has no closed form.
    reference.tolerance =
        0.02 + 2.0 * std::fabs(ratio - 1.0) + std::sqrt(alpha) / scene.beam.segments;
    reference.continuum = beam;
  }
  made.expected.references.push_back(reference);
}

StabilityCase force(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  const double P = knobs.load * b.yield / b.L;
  push(made, Place::end(), {0.0, P, 0.0}, {});
  expect_tip(made, P, theory::tip_force_ratio(ChainConvention::HalfJoint, rounded(knobs.segments)));
  return made;
}

StabilityCase weight(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  const double w = 2.0 * knobs.load * b.yield / (b.L * b.L);
  made.setup.scene.gravity = {0.0, -w / b.rho_A, 0.0};
  const double small = w * b.L * b.L * b.L / b.EI;
  const double ratio =
      theory::self_weight_ratio(ChainConvention::HalfJoint, rounded(knobs.segments));
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  if (small < 0.03 && knobs.mass_ratio == 1.0) {
    const double beam = -small * b.L / 8.0;
    made.expected.references.push_back({.what = "tip deflection",
                                        .probe = tip,
                                        .value = ratio * beam,
                                        .tolerance = 1e-8 + small * small,
                                        .continuum = beam});
  }
  return made;
}

/// A moment at the tip rolls the chain up to a polygon, whatever its size.
StabilityCase roll(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  const double M = knobs.load * 2.0 * std::numbers::pi * b.EI / b.L;
  push(made, Place::end(), {}, {M, 0.0, 0.0});
  // The beam lies along z; a moment about x turns z towards -y.
  const std::size_t y = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const std::size_t z = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Z);
  const int n = rounded(knobs.segments);
  const double turn = knobs.load * 2.0 * std::numbers::pi;
  if (turn < 2.0 * std::numbers::pi * n) {
    // The last segment has the end's half turn, too: it lies along the end's tangent.
    auto at = theory::polygon_node(n, turn, n - 1);
    at[0] += std::cos(turn) / n;
    at[1] += std::sin(turn) / n;
    const double size = b.L;
    made.expected.references.push_back(
        {.what = "tip across", .probe = y, .value = -at[1] * b.L, .size = size, .tolerance = 1e-7});
    made.expected.references.push_back({.what = "tip along",
                                        .probe = z,
                                        .value = (at[0] - 1.0) * b.L,
                                        .size = size,
                                        .tolerance = 1e-7});
  }
  return made;
}

/// A column under `load` times its buckling load, with a thousandth of it across its tip.
StabilityCase column(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  const int n = rounded(knobs.segments);
  const double P = knobs.load * theory::buckling_load(n, b.EI, b.L);
  const double Q = 1e-3 * P;
  push(made, Place::end(), {0.0, Q, -P}, {});
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  if (knobs.load < 0.95) {
    // Slopes of the segments: A sin((i - 1/2) t) + B cos((i - 1/2) t) - Q/P, 2 - 2 cos t = P
    // l^2/EI; phi_0 = -phi_1 at the clamp, phi_{N+1} = phi_N at the tip.
    const double l = b.L / n;
    const double t = 2.0 * std::asin(0.5 * l * std::sqrt(P / b.EI));
    const double B = Q / P / std::cos(0.5 * t);
    const double A = B * std::tan(n * t);
    double sum = 0.0;
    for (int i = 1; i <= n; ++i)
      sum += A * std::sin((i - 0.5) * t) + B * std::cos((i - 0.5) * t) - Q / P;
    const double u = b.L * std::sqrt(P / b.EI);
    const double beam = Q / P * b.L * (std::tan(u) / u - 1.0);
    made.expected.references.push_back(
        {.what = "tip deflection",
         .probe = tip,
         .value = l * sum,
         .tolerance = 1e-8 + 1e-3 * knobs.load / (1.0 - knobs.load) / (1.0 - knobs.load),
         .continuum = beam});
  }
  return made;
}

/// Ideal joints: the limit is first yield at the clamp, where the beam is stiff enough not to swing
/// out of the way.
StabilityCase hinge_of(const Knobs& knobs, YieldModel model) {
  StabilityCase made = cantilever(knobs, Level::Planar, model);
  const Numbers b(knobs);
  push(made, Place::end(), {0.0, knobs.load * b.yield / b.L, 0.0}, {});
  const double limit = knobs.yield_stress / kNominalYield / knobs.load;
  const double bent = b.yield * knobs.yield_stress / kNominalYield * b.L / b.EI;
  if (limit < 1.0 && bent < 0.1) made.expected.limit = limit;
  return made;
}
StabilityCase hinge(const Knobs& knobs) { return hinge_of(knobs, YieldModel::Interaction); }
StabilityCase hinge_per_axis(const Knobs& knobs) { return hinge_of(knobs, YieldModel::PerAxis); }

/// Fibres under a tip force of `load` first yields, which is taken off again.
StabilityCase fibres(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Fibre);
  const Numbers b(knobs);
  const double P = knobs.load * b.yield / b.L;
  push(made, Place::end(), {0.0, P, 0.0}, {}, History::turning_points({1.0, 0.0}));
  made.setup.solver.steps = 20;
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double ratio = knobs.load * kNominalYield / knobs.yield_stress;
  const double bent = P * b.L * b.L / b.EI;
  if (ratio < 1.45 && bent < 0.1) {
    const int n = rounded(knobs.segments);
    const double unit = P / ratio * b.L * b.L * b.L / (3.0 * b.EI);
    made.expected.references.push_back(
        {.what = "greatest tip deflection",
         .probe = tip,
         .sample = 10,
         .value = unit * theory::elastoplastic_tip_ratio(ChainConvention::HalfJoint, n, ratio),
         .tolerance = 0.01,
         .continuum = unit * theory::tip_deflection_ratio(ratio)});
  } else if (ratio > 1.55 && bent < 0.1) {
    made.expected.limit = 1.5 / ratio;
  }
  return made;
}

/// The tip is driven until the hinge at the clamp breaks.
StabilityCase breaks_planar(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Interaction);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  scene.material.break_strain = 0.01;
  Support driven;
  driven.at = Place::end();
  driven.kind = SupportKind::Roller;
  driven.hold = HeldFreedoms{false, true, false, false, false, false};
  const double at_yield = b.yield * knobs.yield_stress / kNominalYield * b.L * b.L / (3.0 * b.EI);
  const double angle = 0.02;
  driven.translation = {0.0, knobs.load * (at_yield + angle * b.L), 0.0};
  scene.supports.push_back(driven);
  const double bent = at_yield / b.L;
  made.expected.breaks = knobs.load >= 1.5 && bent < 0.05 && driven.translation[1] < 0.5 * b.L;
  return made;
}

/// A pillar under the tip, half of the free deflection away.
StabilityCase pillar(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  const double P = knobs.load * b.yield / b.L;
  const double ratio = theory::tip_force_ratio(ChainConvention::HalfJoint, rounded(knobs.segments));
  const double compliance = ratio * b.L * b.L * b.L / (3.0 * b.EI);
  push(made, Place::end(), {0.0, -P, 0.0}, {});
  Support pillar;
  pillar.at = Place::end();
  pillar.kind = SupportKind::Pillar;
  pillar.gap = std::min(0.5 * P * compliance, 0.3 * b.L);
  made.setup.scene.supports.push_back(pillar);
  const std::size_t push_of = probe(made, ProbeQuantity::Reaction, Place::end(), Component::Y);
  const double bent = P * b.L * b.L / b.EI;
  if (bent <= 0.1) {
    made.expected.references.push_back({.what = "force of the pillar",
                                        .probe = push_of,
                                        .value = 0.5 * P,
                                        .tolerance = 1e-8 + bent * bent});
  }
  return made;
}

/// Held at both ends, its joints stretching: an even load.
StabilityCase held(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  made.setup.solver.translation = JointTranslation::Elastic;
  const double w = 12.0 * knobs.load * b.yield / (b.L * b.L);
  scene.gravity = {0.0, -w / b.rho_A, 0.0};
  const std::size_t start = probe(made, ProbeQuantity::Reaction, Place::start(), Component::Y);
  if (knobs.mass_ratio == 1.0) {
    // The half segment at the end neither stretches nor shears, that at the start does.
    made.expected.references.push_back({.what = "force of the start",
                                        .probe = start,
                                        .value = 0.5 * w * b.L,
                                        .tolerance = 1e-6 + 1.0 / b.n,
                                        .continuum = 0.5 * w * b.L});
  }
  return made;
}

}  // namespace

std::vector<BaseScene> planar_path_scenes() {
  using enum Analysis;
  const std::vector<std::string_view> elastic{"modulus", "segments", "slenderness",
                                              "load",    "poisson",  "length"};
  const std::vector<std::string_view> weighed{"modulus", "segments", "slenderness", "mass ratio",
                                              "load",    "poisson",  "length"};
  const std::vector<std::string_view> yields{"modulus", "segments", "slenderness", "load",
                                             "yield",   "poisson",  "length"};
  Knobs over;
  over.load = 2.0;
  Knobs bent;
  bent.load = 1.2;
  Knobs soft;
  soft.load = 0.25;
  return {
      {"planar tip force",
       Level::Planar,
       Statics,
       force,
       {},
       elastic,
       {{"modulus", "segments"}, {"slenderness", "load"}, {"length", "modulus"}}},
      {"planar weight", Level::Planar, Statics, weight, {}, weighed, {{"mass ratio", "segments"}}},
      {"planar roll-up", Level::Planar, Statics, roll, soft, elastic, {{"load", "segments"}}},
      {"planar column",
       Level::Planar,
       Statics,
       column,
       {},
       elastic,
       {{"load", "segments"}, {"load", "slenderness"}}},
      {"planar hinge",
       Level::Planar,
       Statics,
       hinge,
       over,
       yields,
       {{"load", "yield"}, {"load", "segments"}}},
      {"planar hinge per axis",
       Level::Planar,
       Statics,
       hinge_per_axis,
       over,
       yields,
       {{"modulus", "yield"}}},
      {"planar fibres", Level::Planar, Statics, fibres, bent, yields, {{"load", "yield"}}},
      {"planar break", Level::Planar, Statics, breaks_planar, over, yields, {{"load", "segments"}}},
      {"planar pillar", Level::Planar, Statics, pillar, {}, elastic, {{"modulus", "load"}}},
      {"planar held", Level::Planar, Statics, held, {}, weighed, {{"slenderness", "load"}}},
  };
}

}  // namespace plastica::sweeps::stability
