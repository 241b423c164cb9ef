#include "sweeps/stability/audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/section.hpp"
#include "plastica/report/format.hpp"

namespace plastica::sweeps::stability {
namespace {

using Space = std::array<double, 3>;

Space plus(const Space& a, const Space& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Space minus(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Space times(double s, const Space& a) { return {s * a[0], s * a[1], s * a[2]}; }
Space cross(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double size_of(const Space& a) { return std::hypot(a[0], a[1], a[2]); }

/// Rodrigues' formula.
Space turned(const Space& by, const Space& a) {
  const double angle = size_of(by);
  if (angle == 0.0) return a;
  const Space axis = times(1.0 / angle, by);
  const Space across = cross(axis, a);
  return plus(
      a, plus(times(std::sin(angle), across), times(1.0 - std::cos(angle), cross(axis, across))));
}

/// The moment that a joint transmits, from the one that works on its angle: the latter belongs to
/// the rotation vector. A = 1 + skew/2 + c skew^2 makes it so, c = 1/t^2 - (1 + cos t)/(2 t sin t).
Space transmitted(const Space& angle, const Space& moment) {
  const double t = size_of(angle);
  const double c = t < 1e-2 ? 1.0 / 12.0 + t * t / 720.0
                            : 1.0 / (t * t) - (1.0 + std::cos(t)) / (2.0 * t * std::sin(t));
  const Space across = cross(angle, moment);
  return plus(moment, plus(times(0.5, across), times(c, cross(angle, across))));
}

/// The last recorded shape of a response.
class Shape {
 public:
  Shape(const Setup& setup, const Response& response)
      : ends_(segment_ends(setup.scene)), chain_(response.chain) {
    const auto& frames = chain_.frame_sample;
    frame_ = static_cast<std::size_t>(
        std::lower_bound(frames.begin(), frames.end(), response.samples - 1) - frames.begin());
  }

  bool known() const { return frame_ < chain_.frame_sample.size(); }
  std::size_t segments() const { return chain_.joints - 1; }
  const std::vector<double>& ends() const { return ends_; }

  Space node(std::size_t i) const { return of(chain_.position, chain_.joints, i); }
  Space moment(std::size_t i) const { return of(chain_.moment, chain_.joints, i); }
  Space angle(std::size_t i) const { return of(chain_.angle, chain_.joints, i); }
  Space rotation(std::size_t segment) const { return of(chain_.rotation, segments(), segment); }
  Space reaction(std::size_t support) const {
    return of(chain_.reaction, 2 * supports(), 2 * support);
  }
  Space reaction_moment(std::size_t support) const {
    return of(chain_.reaction, 2 * supports(), 2 * support + 1);
  }

  /// The segment of a place: the one that ends there, or has it inside.
  std::size_t segment_at(double fraction) const {
    const auto after = std::lower_bound(ends_.begin() + 1, ends_.end() - 1, fraction - 1e-12);
    return static_cast<std::size_t>(after - ends_.begin()) - 1;
  }
  Space point(double fraction) const {
    const std::size_t i = segment_at(fraction);
    const double within = (fraction - ends_[i]) / (ends_[i + 1] - ends_[i]);
    return plus(node(i), times(within, minus(node(i + 1), node(i))));
  }

 private:
  std::size_t supports() const { return chain_.supports; }
  Space of(const std::vector<double>& values, std::size_t rows, std::size_t row) const {
    const std::size_t at = 3 * (frame_ * rows + row);
    return {values[at], values[at + 1], values[at + 2]};
  }

  std::vector<double> ends_;
  const ChainHistory& chain_;
  std::size_t frame_ = 0;
};

/// A force with a moment on a segment.
struct Act {
  double fraction = 0.0;     ///< of the place
  bool holds_start = false;  ///< of a support at the start, behind the first joint
  Space at{};
  Space force{};
  Space moment{};
};

bool is_plane(const Scene& scene) { return scene.regions.empty(); }

void add_spread(const Shape& shape, double from, double to, const Space& total,
                std::vector<Act>& acts) {
  for (std::size_t i = 0; i < shape.segments(); ++i) {
    const double a = std::max(from, shape.ends()[i]);
    const double b = std::min(to, shape.ends()[i + 1]);
    if (b <= a) continue;
    const double middle = 0.5 * (a + b);
    acts.push_back({middle, false, shape.point(middle), times((b - a), total), {}});
  }
}

/// All that acts on the beam from outside; empty if a load or support is of a kind that is not
/// summed here.
std::optional<std::vector<Act>> acts_on(const Setup& setup, const Response& response,
                                        const Shape& shape) {
  const Scene& scene = setup.scene;
  const double time = response.chain.time[response.samples - 1];
  std::vector<Act> acts;
  for (const Load& load : scene.loads) {
    const double factor = load.history.at(time);
    const double fraction = fraction_of(load.at, shape.ends());
    if (load.to) {
      if (load.moment != Space{} || load.follows) return std::nullopt;
      add_spread(shape, fraction, fraction_of(*load.to, shape.ends()),
                 times(factor * scene.beam.length, load.force), acts);
      continue;
    }
    Space force = times(factor, load.force);
    Space moment = times(factor, load.moment);
    if (load.follows) {
      const Space by = shape.rotation(shape.segment_at(fraction));
      force = turned(by, force);
      moment = turned(by, moment);
    }
    // A moment at a joint acts on both of its segments, half on each.
    const auto joint = segment_end_at(load.at, shape.ends());
    const bool inner = joint && *joint > 0 && *joint < scene.beam.segments;
    if (inner && moment != Space{}) {
      const auto beyond = static_cast<std::size_t>(*joint);
      moment = times(0.5, moment);
      acts.push_back({0.5 * (shape.ends()[beyond] + shape.ends()[beyond + 1]),
                      false,
                      shape.point(fraction),
                      {},
                      moment});
    }
    acts.push_back({fraction, false, shape.point(fraction), force, moment});
  }
  if (scene.gravity != Space{}) {
    const double area = section_properties(scene.section, scene.material.poisson_ratio).area;
    const double weight =
        scene.material.density * area * scene.beam.length * scene.gravity_history.at(time);
    add_spread(shape, 0.0, 1.0, times(weight, scene.gravity), acts);
    for (const PointMass& body : scene.masses) {
      const double fraction = fraction_of(body.at, shape.ends());
      const double pulls = body.mass * scene.gravity_history.at(time);
      acts.push_back({fraction, false, shape.point(fraction), times(pulls, scene.gravity), {}});
    }
  }
  for (const Support& support : scene.supports) {
    // What joints beside such a node carry is the chain's own affair (chain/README.md).
    const double at = fraction_of(support.at, shape.ends());
    if (support.rotational_stiffness != Space{} && at > 0.0 && at < 1.0) return std::nullopt;
  }
  for (std::size_t s = 0; s < scene.supports.size(); ++s) {
    // Of a bed of springs the response has the sum alone.
    if (scene.supports[s].to) return std::nullopt;
    const double fraction = fraction_of(scene.supports[s].at, shape.ends());
    acts.push_back({fraction, fraction == 0.0, shape.point(fraction), shape.reaction(s),
                    shape.reaction_moment(s)});
  }
  return acts;
}

std::string over(std::string_view what, double fraction) {
  return std::string(what) + " by " + report::significant(fraction, 3);
}

std::optional<std::string> check_lengths(const Setup& setup, const Response& response,
                                         const Shape& shape) {
  const Scene& scene = setup.scene;
  if (setup.solver.translation == JointTranslation::Elastic ||
      scene.beam.shape != BeamShape::Straight)
    return std::nullopt;
  // A cut joint is where its outer segment begins.
  std::vector<bool> cut(shape.segments() + 1, false);
  for (const ChainBreak& event : response.chain.events) {
    for (const BrokenJoint& joint : event.joints) {
      if (joint.cut) cut[static_cast<std::size_t>(joint.joint)] = true;
    }
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < shape.segments(); ++i) {
    if (cut[i + 1]) continue;
    const double length = (shape.ends()[i + 1] - shape.ends()[i]) * scene.beam.length;
    worst = std::max(worst, std::fabs(size_of(minus(shape.node(i + 1), shape.node(i))) - length));
  }
  if (worst <= kAuditTolerance * scene.beam.length) return std::nullopt;
  return over("a rigid segment is stretched", worst / scene.beam.length);
}

std::optional<std::string> check_caps(const Setup& setup, const Shape& shape) {
  const Scene& scene = setup.scene;
  if (scene.yield_model == YieldModel::Elastic ||
      scene.material.hardening.law != HardeningLaw::Ideal || scene.formulas == Formulas::Report)
    return std::nullopt;
  const SectionProperties section = section_properties(scene.section, scene.material.poisson_ratio);
  const bool plastic =
      scene.yield_cap == YieldCap::FullyPlastic || scene.yield_model == YieldModel::Fibre;
  const double yield = scene.material.yield_stress;
  const double shear = resolved_shear_yield_stress(scene.material);
  const Space caps =
      plastic ? Space{yield * section.plastic_section_modulus_x,
                      yield * section.plastic_section_modulus_y,
                      shear * section.plastic_torsion_modulus}
              : Space{yield * section.section_modulus_x, yield * section.section_modulus_y,
                      shear * section.torsion_modulus};
  double worst = 0.0;
  for (std::size_t i = 0; i <= shape.segments(); ++i) {
    const Space moment = shape.moment(i);
    for (std::size_t k = 0; k < 3; ++k)
      worst = std::max(worst, std::fabs(moment[k]) / caps[k] - 1.0);
  }
  if (worst <= kAuditTolerance) return std::nullopt;
  return over("an ideal joint is beyond its cap", worst);
}

std::optional<std::string> check_balance(const Setup& setup, const Response& response,
                                         const Shape& shape) {
  auto acts = acts_on(setup, response, shape);
  if (!acts) return std::nullopt;
  // From the free end inwards: what lies beyond each joint.
  std::stable_sort(acts->begin(), acts->end(), [](const Act& a, const Act& b) {
    return a.holds_start != b.holds_start ? b.holds_start : a.fraction > b.fraction;
  });
  const double length = setup.scene.beam.length;
  double largest_force = 0.0;
  double largest_moment = 0.0;
  for (const Act& act : *acts) {
    largest_force = std::max(largest_force, size_of(act.force));
    largest_moment = std::max(largest_moment, size_of(act.moment));
  }
  // What has been on the beam before and is taken off again has left its rounding.
  for (const Load& load : setup.scene.loads) {
    for (const double factor : load.history.factor) {
      largest_force = std::max(largest_force, std::fabs(factor) * size_of(load.force));
      largest_moment = std::max(largest_moment, std::fabs(factor) * size_of(load.moment));
    }
  }
  const std::size_t n = shape.segments();
  for (std::size_t i = 0; i <= n; ++i)
    largest_moment = std::max(largest_moment, size_of(shape.moment(i)));
  const double force_scale = std::max(largest_force, largest_moment / length);
  const double moment_scale = std::max(largest_moment, 1e-2 * largest_force * length);
  if (force_scale == 0.0) return std::nullopt;

  const bool shifts = setup.solver.translation == JointTranslation::Elastic;
  Space force{};
  Space moment{};
  Space about{};
  double worst = 0.0;
  auto next = acts->begin();
  const auto take = [&](std::size_t node, const auto& beyond) {
    const Space at = shape.node(node);
    moment = plus(moment, cross(minus(about, at), force));
    about = at;
    for (; next != acts->end() && beyond(*next); ++next) {
      force = plus(force, next->force);
      moment = plus(moment, plus(next->moment, cross(minus(next->at, at), next->force)));
    }
  };
  about = shape.node(n);
  for (std::size_t i = n; i-- > 0;) {
    take(i, [&](const Act& act) {
      return i == 0 ? !act.holds_start : act.fraction > shape.ends()[i] + 1e-12;
    });
    if (shifts) continue;
    worst = std::max(
        worst, std::fabs(size_of(moment) - size_of(transmitted(shape.angle(i), shape.moment(i)))));
  }
  take(0, [](const Act&) { return true; });
  if (worst > kAuditTolerance * moment_scale)
    return over("a joint is out of balance", worst / moment_scale);
  const double left = size_of(force);
  if (left > kAuditTolerance * force_scale)
    return over("the forces on the beam do not balance", left / force_scale);
  if (!shifts && size_of(moment) > kAuditTolerance * moment_scale)
    return over("the moments on the beam do not balance", size_of(moment) / moment_scale);
  return std::nullopt;
}

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

bool is_finite(const Setup& setup, const Response& response) {
  for (const auto& probe : response.probes) {
    if (!all_finite(std::span(probe).first(response.samples))) return false;
  }
  if (setup.scene.is_coupon()) return std::isfinite(response.permanent_strain);
  const ChainHistory& chain = response.chain;
  for (const Energies& e : std::span(chain.energy).first(response.samples)) {
    if (!all_finite(std::array{e.elastic, e.kinetic, e.plastic, e.damping, e.numerical_dissipation,
                               e.impact, e.fracture, e.external, e.residual}))
      return false;
  }
  return std::isfinite(response.energy_balance_error) && std::isfinite(response.permanent_strain) &&
         all_finite(chain.position) && all_finite(chain.moment) && all_finite(chain.force) &&
         all_finite(chain.angle) && all_finite(chain.plastic_angle) && all_finite(chain.rotation) &&
         all_finite(chain.velocity) && all_finite(chain.spin) && all_finite(chain.plastic_strain) &&
         all_finite(chain.stress) && all_finite(chain.reaction);
}

std::optional<std::string> audit(const Setup& setup, const Response& response) {
  if (setup.scene.is_coupon() || response.samples == 0) return std::nullopt;
  const Shape shape(setup, response);
  if (!shape.known()) return std::nullopt;
  if (auto found = check_lengths(setup, response, shape)) return found;
  if (!is_plane(setup.scene)) return std::nullopt;
  if (auto found = check_caps(setup, shape)) return found;
  if (setup.solver.analysis == Analysis::Dynamics) return std::nullopt;
  if (!response.chain.events.empty()) return std::nullopt;
  return check_balance(setup, response, shape);
}

}  // namespace plastica::sweeps::stability
