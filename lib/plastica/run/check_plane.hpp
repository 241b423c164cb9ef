#pragma once

#include <algorithm>
#include <cmath>

#include "plastica/run/chain_runner.hpp"
#include "plastica/solve/buckling_mode.hpp"

/// What a planar chain's runner asks of the space around it, and the modes of its bifurcations.
namespace plastica {
namespace detail {

template <class V>
std::array<double, 3> doubles(const V& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

inline bool same_elasticity(const MaterialValues<double>& a, const MaterialValues<double>& b) {
  const auto same = [&](MaterialField field) {
    const auto k = static_cast<std::size_t>(field);
    return a[k] == b[k];
  };
  return same(MaterialField::YoungsModulus) && same(MaterialField::PoissonRatio) &&
         same(MaterialField::ShearModulus);
}

/// A planar chain's unknowns as space sees them.
template <class L>
void see_in_space(const chain::Chain<L>& chain, const chain::View<L>& view,
                  const chain::Coordinates<L>& q, double time,
                  const std::vector<mask_t<typename L::Scalar>>& closed, PlanarEquilibrium& at) {
  at.time = time;
  at.angle.clear();
  at.shift.clear();
  at.held.clear();
  for (const auto& angle : q.angle) at.angle.push_back(doubles(view.spin_in_space(angle)));
  for (const auto& shift : q.shift) at.shift.push_back(doubles(view.point_in_space(shift)));
  at.root = doubles(view.point_in_space(q.root));
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const auto& constraint = chain.constraints[k];
    at.held.push_back({constraint.support, doubles(view.point_in_space(constraint.direction)),
                       doubles(view.spin_in_space(constraint.axis)),
                       static_cast<double>(q.multiplier[k]), closed[k]});
  }
}

}  // namespace detail

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::has_space_beside() {
  if constexpr (L::kTranslations != 2) {
    return false;
  } else {
    // What yields when does not matter to it, so that the runs of a fit share it.
    if (!beside_ || !detail::same_elasticity(beside_material_, material_)) {
      beside_ = make_out_of_plane(body_.model, material_);
      beside_material_ = material_;
    }
    return beside_->applies();
  }
}

/// Whether a planar beam is under a thrust worth the name: a tenth of the largest force in it.
template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::is_pushed(const Work& w) const {
  using S = typename L::Scalar;
  if constexpr (L::kTranslations == 2) {
    constexpr std::size_t kAlong = chain::SectionAxes<L>::kAxialShift;
    S thrust = constant<S>(0);
    S largest = constant<S>(0);
    for (std::size_t i = 0; i < w.transmitted.outer.size(); ++i) {
      const auto force = L::rotate_back(w.placement.near[i], w.transmitted.outer[i].force);
      thrust = max(thrust, -force[kAlong]);
      largest = max(largest, dot(force, force));
    }
    return thrust > constant<S>(0) && thrust * thrust > constant<S>(0.01) * largest;
  } else {
    return false;
  }
}

/// @param sections  there, if any may have yielded
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::see(const chain::Coordinates<L>& q, double time,
                                   const Sections* sections) {
  detail::see_in_space(body_.build.chain, body_.view, q, time, body_.work.closed, seen_);
  seen_.elastic.clear();
  seen_.ground_node.clear();
  seen_.aside.clear();
  if (sections == nullptr || (!has_yielded_ && !yields())) return;
  const auto axes = body_.view.section_axes();
  const auto elastic = [&](std::size_t joint, std::size_t axis) {
    const auto& numbers = body_.joints->joints()[joint];
    return numbers.elastic_deformation(axis, sections->force[joint][axis]);
  };
  const auto add = [&](std::size_t joint) {
    typename L::Spin angle;
    for (std::size_t k = 0; k < L::kRotations; ++k) angle[k] = elastic(joint, axes.rotation(k));
    seen_.elastic.push_back(detail::doubles(body_.view.spin_in_space(angle)));
    if (sections->aside.empty()) return;
    const std::size_t aside = 1 - axes.rotation(0);
    seen_.aside.push_back(static_cast<double>(sections->aside[joint] /
                                              body_.joints->joints()[joint].stiffness[aside]));
  };
  const auto& chain = body_.build.chain;
  for (std::size_t j = 0; j < chain.size(); ++j) add(j);
  for (const auto& ground : chain.ground_joints) {
    add(ground.joint);
    seen_.ground_node.push_back(ground.node);
  }
  if constexpr (kElastic) {
    constexpr std::size_t kAlong = std::decay_t<decltype(axes)>::kAxialShift;
    for (std::size_t j = 0; j < q.shift.size(); ++j) {
      typename L::Point shift = q.shift[j];
      shift[kAlong] = elastic(j, 3);
      seen_.shift[j] = detail::doubles(body_.view.point_in_space(shift));
    }
  }
}

/// Checks whether the plane is left at an equilibrium.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::check_plane(const chain::Coordinates<L>& q, double time,
                                           const Sections* sections) {
  if constexpr (L::kTranslations == 2) {
    const bool known = asks_beside_ || leaves_plane_ || !(time > checked_at_ || time < checked_at_);
    if (known || !has_space_beside()) return;
    checked_at_ = time;
    see(q, time, sections);
    leaves_plane_ = beside_->unstable_modes(seen_) > 0;
  }
}

/// A beam that leaves its plane may come back to rest in it: one that hangs down from a hinge is as
/// stable as before it was bent. So a path is checked between its ends, too, where it yields or has
/// turned far, each time that its largest moment has grown, which ends at the section's own.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::check_plane_while_moments_grow(const Work& w) {
  constexpr double kFar = 1.0;  // [rad]
  if (has_yielded_) {
    last_forces_ = sections().force;
    last_aside_ = sections().aside;
  }
  if (asks_beside_ || leaves_plane_) return;
  if (!has_yielded_) {
    double rotation = 0.0;
    double farthest = 0.0;
    for (const auto& angle : w.q.angle) {
      rotation += static_cast<double>(angle[0]);
      farthest = std::max(farthest, std::fabs(rotation));
    }
    if (farthest < kFar) return;
  }
  const std::size_t axis = body_.view.section_axes().rotation(0);
  double largest = 0.0;
  for (const auto& force : sections().force) {
    largest = std::max(largest, std::fabs(static_cast<double>(force[axis])));
  }
  if (largest < (has_yielded_ ? 1.02 : 2.0) * checked_moment_) return;
  checked_moment_ = largest;
  const Sections now = sections();
  check_plane(w.q, w.time, &now);
}

/// What acts at time 0, and whatever comes to its most or changes its way, may be gone at the end.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::check_plane_where_loads_turn(const Work& w) {
  constexpr double kWhile = 1e-6;  // of the path: over it a smooth peak shows, too
  if (asks_beside_ || leaves_plane_) return;
  const auto& chain = body_.build.chain;
  const double end = options_.stops.back();
  const auto acts_at_once = [&] {
    return std::any_of(chain.histories.begin(), chain.histories.end(), [](const History& history) {
      return history.at(0.0) < 0.0 || history.at(0.0) > 0.0;
    });
  };
  const bool looks = w.time > 0.0
                         ? solve::speed_change(chain, w.time, solve::kSameTime * end).is_corner() ||
                               solve::is_peak(chain, w.time, kWhile * end)
                         : acts_at_once();
  if (!looks) return;
  const Sections now = sections();
  check_plane(w.q, w.time, &now);
}

template <class L, bool kElastic>
int ChainRunner<L, kElastic>::unstable_beside(const Work& w) {
  if constexpr (L::kTranslations == 2) {
    if (!asks_beside_ || !has_space_beside()) return unstable_beside_;
    const Sections now = sections();
    see(w.q, w.time, &now);
    unstable_beside_ = beside_->unstable_modes(seen_);
    return unstable_beside_;
  } else {
    return 0;
  }
}

template <class L, bool kElastic>
double ChainRunner<L, kElastic>::log_determinant_beside(const Work& w) {
  if constexpr (L::kTranslations == 2) {
    if (!asks_beside_ || !has_space_beside()) return 0.0;
    const Sections now = sections();
    see(w.q, w.time, &now);
    return beside_->log_determinant(seen_);
  } else {
    return 0.0;
  }
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::note_mode(bool out_of_plane, Work& w, std::vector<double>& mode) {
  if constexpr (L::kTranslations == 2) {
    if (out_of_plane) {
      const Sections now = sections();
      see(w.q, w.time, &now);
      beside_->add_mode(seen_, mode);
      return;
    }
  }
  for (const auto& displacement : solve::buckling_mode(body_.build.chain, w)) {
    const auto in_space = detail::doubles(body_.view.point_in_space(displacement));
    mode.insert(mode.end(), in_space.begin(), in_space.end());
  }
}

}  // namespace plastica
