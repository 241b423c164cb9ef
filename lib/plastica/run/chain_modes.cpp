#include "plastica/run/chain_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "plastica/run/growing_histories.hpp"
#include "plastica/solve/first_roots.hpp"
#include "plastica/solve/stability_count.hpp"

namespace plastica {
namespace {

/// Of the softest coordinate's omega^2: below, a motion is one that nothing resists. Rounding
/// leaves about 1e-13 of it.
constexpr double kUnresisted = 1e-10;
/// Of the largest stiffness: below, it is the rounding of lever arms that should be zero, squared.
constexpr double kNoStiffness = 1e-24;
/// Fraction of the displacement that a constraint's own stiffness would leave, below which it holds
/// nothing.
constexpr double kHeldTwice = 1e-10;
/// How little joints are unloaded, of their elastic deformation.
constexpr double kUnloading = 1e-9;
/// Beside it, of a tangent, what rounding and the residual of an equilibrium leave.
constexpr double kAsymmetry = 1e-6;
/// Of a root: how near others are that rounding does not tell apart where it is there twice.
constexpr double kSameRoot = 1e-6;
/// How far critical loads are sought, of the load that acts.
constexpr double kFarthest = 1e15;
/// How far natural frequencies are, of the softest coordinate's omega^2.
constexpr double kStiffest = 1e30;

}  // namespace

template <class L, bool kElastic>
ChainModes<L, kElastic>::ChainModes(ChainBody<L, kElastic>& body, const chain::Coordinates<L>& q,
                                    double time, bool yielded)
    : body_(body), w_(body.work) {
  w_.q = q;
  w_.time = time;
  solve::detail::assemble(body.build.chain, *body.joints, w_);
  if (yielded) unload(q);
}

/// Joints on their yield surface have no one tangent: a little off it they have that of unloading.
template <class L, bool kElastic>
void ChainModes<L, kElastic>::unload(const chain::Coordinates<L>& q) {
  const chain::Chain<L>& chain = body_.build.chain;
  const auto axes = body_.view.section_axes();
  auto shift = q.shift;
  for (std::size_t j = 0; j < chain.joints(); ++j) {
    const auto& numbers = body_.joints->joints()[j];
    const auto& force = body_.joints->section_forces()[j];
    const auto elastic = [&](std::size_t axis) {
      return numbers.elastic_deformation(axis, force[axis]);
    };
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      w_.angles[j][k] = w_.angles[j][k] - constant<S>(kUnloading) * elastic(axes.rotation(k));
    }
    if constexpr (kElastic) {
      constexpr std::size_t kAlong = std::decay_t<decltype(axes)>::kAxialShift;
      if (j < shift.size()) {
        shift[j][kAlong] = shift[j][kAlong] - constant<S>(kUnloading) * elastic(3);
      }
    }
  }
  body_.joints->evaluate(w_.angles, shift, w_.joints);
  gather();
}

/// Of joints that do not yield: their moments do not follow the axial force.
template <class L, bool kElastic>
void ChainModes<L, kElastic>::gather() {
  const chain::Chain<L>& chain = body_.build.chain;
  chain::gather_forces(
      chain, w_.q, w_.placement, w_.stage, w_.joints,
      [&](std::size_t history) { return chain.histories[history].at(w_.time); }, w_.outer_forces);
  w_.outer_forces.axial.along.clear();
  solve::detail::set_constraints(chain, w_);
}

template <class L, bool kElastic>
int ChainModes<L, kElastic>::unstable_modes() {
  return static_cast<int>(
      solve::unstable_modes(body_.build.chain, solve::PathCondition<L>{}, false, w_));
}

/// Of a symmetric tangent the count falls by rounding alone, which beside a root that is there
/// twice reaches as far as the square root of its own size.
template <class L, bool kElastic>
bool ChainModes<L, kElastic>::is_symmetric(solve::Pencil<L, kElastic>& pencil, double x) {
  pencil.factor(x);
  return static_cast<double>(solve::asymmetry(body_.build.chain, w_)) < kAsymmetry;
}

template <class L, bool kElastic>
double ChainModes<L, kElastic>::growth(double before, double time, double reach, bool held,
                                       double& about) const {
  const History* growing = &body_.record.shown_history();
  const Scene& scene = body_.model.scene;
  // Where none grew, all do in proportion to what they are.
  const auto goes = [&](const History& history) {
    return held ? history.at(time) != 0.0 : grows(history, before);
  };
  const auto take = [&](const History& history) {
    if (!goes(*growing) && goes(history)) growing = &history;
  };
  for (const Load& load : scene.loads) take(load.history);
  for (const Support& support : scene.supports) {
    if (support.moves()) take(support.history);
  }
  if (scene.gravity != std::array<double, 3>{}) take(scene.gravity_history);
  about = growing->at(time);
  return held ? about / reach : growing->slope_at(before);
}

template <class L, bool kElastic>
std::optional<BucklingModes> ChainModes<L, kElastic>::buckling(int count, OutOfPlane* beside,
                                                               StopFlag stop) {
  const double time = w_.time;
  const double before = solve::just_before(time);
  solve::RootSearch search;
  search.reach = time > 0.0 ? time : body_.model.stops.back();
  search.most = kFarthest;
  search.count = count;
  search.stop = stop;
  auto& histories = body_.build.chain.histories;
  const std::vector<History> kept = histories;
  const bool held = let_held_grow(before, time, search.reach, histories);
  BucklingModes modes;
  const double slope = growth(before, time, search.reach, held, modes.about);
  w_.time = before;
  solve::Pencil<L, kElastic> pencil(body_.build.chain, w_);
  pencil.let_forces_grow();
  histories = kept;
  if (slope == 0.0) return std::nullopt;
  double rotational = 0.0;
  for (std::size_t i = 0; i < body_.build.chain.size(); ++i) {
    rotational = std::max(rotational, static_cast<double>(pencil.rotation_rate(i)));
  }
  std::vector<Root> roots;
  bool falls = false;
  const auto add_roots = [&](bool out_of_plane, const std::function<int(double)>& passed) {
    const solve::Roots found = solve::first_roots(passed, search);
    falls = falls || (found.falls && (out_of_plane || !is_symmetric(pencil, 0.0)));
    for (const double root : found.at) roots.push_back({root, out_of_plane});
  };
  const auto in_plane = [&](double x) {
    pencil.factor(x);
    return unstable_modes();
  };
  if (in_plane(0.0) > 0 || (beside != nullptr && beside->unstable_after(0.0) > 0))
    return std::nullopt;
  add_roots(false, in_plane);
  if (beside != nullptr) add_roots(true, [&](double x) { return beside->unstable_after(x); });
  if (falls) return std::nullopt;
  std::stable_sort(roots.begin(), roots.end(),
                   [](const Root& a, const Root& b) { return a.time < b.time; });
  roots.resize(std::min(roots.size(), static_cast<std::size_t>(count)));
  double last = -1.0;  // of the chain's own roots
  for (const Root& root : roots) {
    if (is_raised(stop)) break;
    modes.factor.push_back(modes.about + root.time * slope);
    modes.rotation.push_back(root.time * rotational);
    modes.out_of_plane.push_back(root.out_of_plane ? 1 : 0);
    if (root.out_of_plane) {
      beside->add_mode_after(root.time, modes.mode);
    } else {
      add_mode(pencil, root.time, root.time <= (1.0 + kSameRoot) * last, modes.mode);
      last = root.time;
    }
  }
  return modes;
}

template <class L, bool kElastic>
void ChainModes<L, kElastic>::add_mode(solve::Pencil<L, kElastic>& pencil, double root, bool again,
                                       std::vector<double>& mode) {
  if (!again) known_.clear();
  std::vector<chain::Motion<L>> motion;
  solve::look_at_root(root, [&](double x) {
    pencil.factor(x);
    motion = solve::softest_motion(body_.build.chain, w_, known_);
    return std::ranges::all_of(motion, [](const chain::Motion<L>& of_segment) {
      return std::ranges::all_of(of_segment.spin.at, [](const S& spin) {
        return std::isfinite(static_cast<double>(spin));
      });
    });
  });
  known_.push_back(std::move(motion));
  for (const auto& displacement : solve::mode_of(body_.build.chain, known_.back(), w_)) {
    const auto in_space = body_.view.point_in_space(displacement);
    for (std::size_t k = 0; k < 3; ++k) mode.push_back(static_cast<double>(in_space[k]));
  }
}

template <class L, bool kElastic>
std::optional<VibrationModes> ChainModes<L, kElastic>::vibration(int count, StopFlag stop) {
  VibrationModes modes;
  const double softest_square = softest();
  const auto wanted = static_cast<std::size_t>(count);
  solve::Pencil<L, kElastic> pencil(body_.build.chain, w_);
  pencil.let_inertia_resist();
  const auto passed = [&](double square) {
    pencil.factor(square);
    return unstable_modes();
  };
  std::vector<double> squares(wanted, 0.0);
  if (std::isfinite(softest_square)) {
    solve::RootSearch search;
    search.from = kUnresisted * softest_square;
    search.reach = softest_square;
    search.most = kStiffest;
    search.stop = stop;
    // Constraints that hold next to nothing may be counted off by one.
    const int unresisted = std::clamp(passed(search.from), 0, count);
    search.count = count - unresisted;
    if (search.count > 0) {
      const solve::Roots roots = solve::first_roots(passed, search);
      if (roots.falls && !is_symmetric(pencil, search.reach)) return std::nullopt;
      squares.resize(static_cast<std::size_t>(unresisted));
      squares.insert(squares.end(), roots.at.begin(), roots.at.end());
    }
  }
  double last = -1.0;
  for (const double square : squares) {
    if (is_raised(stop)) break;
    modes.frequency.push_back(std::sqrt(square) / (2.0 * std::numbers::pi));
    // Just below, since at 0 nothing may be there to divide by.
    add_mode(pencil, square > 0.0 ? square : -kUnresisted * softest_square,
             square <= (1.0 + kSameRoot) * last, modes.mode);
    last = square;
  }
  return modes;
}

template <class L, bool kElastic>
std::vector<typename ChainModes<L, kElastic>::Coordinate> ChainModes<L, kElastic>::coordinates() {
  const chain::Chain<L>& chain = body_.build.chain;
  chain::OuterForces<L> held;
  chain::gather_forces(
      chain, w_.q, w_.placement, w_.stage, w_.joints, [](std::size_t /*history*/) { return 0.0; },
      held);
  std::vector<Coordinate> coordinates;
  const auto add = [&](const S& stiffness, const S& mass) {
    coordinates.push_back({static_cast<double>(stiffness), static_cast<double>(mass)});
  };
  chain::Impedance<L> mass{};
  chain::Impedance<L> stiffness{};
  // A joint moves what is outside of it, or what is inside: all of it, so that neither end counts
  // for less. About joint 0 first.
  const auto& position = w_.placement.position;
  chain::Impedance<L> all{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    auto own = solve::inertia_impedance(chain.inertias[i], w_.placement.frame[i]);
    const typename L::Point arm = position[i] - position[0];
    chain::carry(arm, arm, own);
    all += own;
  }
  for (std::size_t i = chain.size(); i-- > 0;) {
    mass += solve::inertia_impedance(chain.inertias[i], w_.placement.frame[i]);
    auto about = all;
    const typename L::Point back = position[0] - position[i];
    chain::carry(back, back, about);
    stiffness += held.impedance[i];
    const auto axes = L::axes(w_.placement.near[i]);
    const auto rotational = transpose(axes) * about.rr * axes;
    const auto resisting = transpose(axes) * stiffness.rr * axes;
    const auto& tangent = w_.joints.tangent[i];
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      if (i == 0 && chain.root.clamped[k]) continue;
      add(tangent(k, k) + resisting(k, k), rotational(k, k));
    }
    if constexpr (kElastic) {
      for (std::size_t k = 0; k < L::kTranslations && (i > 0 || chain.root.shifts); ++k) {
        add(tangent(L::kRotations + k, L::kRotations + k), mass.tt(k, k));
      }
    }
    if (i == 0) break;
    const typename L::Point arm = w_.placement.position[i] - w_.placement.position[i - 1];
    chain::carry(arm, arm, mass);
    chain::carry(arm, arm, stiffness);
  }
  for (std::size_t k = 0; k < L::kTranslations; ++k) {
    if (!chain.root.held[k]) add(stiffness.tt(k, k), mass.tt(k, k));
  }
  return coordinates;
}

/// By Rayleigh's principle no less than the lowest of the chain before it is held off the start,
/// and of its size. Infinite where nothing is resisted.
template <class L, bool kElastic>
double ChainModes<L, kElastic>::softest() {
  const std::vector<Coordinate> all = coordinates();
  double most = 0.0;
  for (const Coordinate& one : all) most = std::max(most, one.stiffness);
  double least = std::numeric_limits<double>::infinity();
  for (const Coordinate& one : all) {
    if (one.stiffness > kNoStiffness * most) least = std::min(least, one.stiffness / one.mass);
  }
  return least;
}

template <class L, bool kElastic>
int ChainModes<L, kElastic>::freedoms() {
  const auto closed = std::count(w_.closed.begin(), w_.closed.end(), true);
  return static_cast<int>(coordinates().size()) - static_cast<int>(closed);
}

template <class L, bool kElastic>
std::size_t ChainModes<L, kElastic>::idle_constraint(double square) {
  const chain::Chain<L>& chain = body_.build.chain;
  solve::Pencil<L, kElastic> pencil(chain, w_);
  pencil.let_inertia_resist();
  pencil.factor(square);
  std::size_t k = 0;
  std::size_t idle = chain.constraints.size();
  solve::detail::for_each_constraint_pivot(
      chain, solve::PathCondition<L>{}, false, w_, [&](const S& pivot) {
        const S stiffness = solve::detail::stiffness_of<S>(chain, chain.constraints[k]);
        const bool holds = std::fabs(static_cast<double>(pivot * stiffness)) > kHeldTwice;
        if (w_.closed[k] && !holds) idle = std::min(idle, k);
        ++k;
      });
  return idle;
}

template <class L, bool kElastic>
void ChainModes<L, kElastic>::release_idle_constraints() {
  const double least = softest();
  const double square = std::isfinite(least) ? kUnresisted * least : 1.0;
  for (;;) {
    const std::size_t idle = idle_constraint(square);
    if (idle == w_.closed.size()) return;
    w_.q.released_constraint[idle] = true;
    gather();
  }
}

template class ChainModes<chain::Twist<double>, false>;
template class ChainModes<chain::Planar<double>, false>;
template class ChainModes<chain::Planar<double>, true>;
template class ChainModes<chain::Spatial<double>, false>;
template class ChainModes<chain::Spatial<double>, true>;

}  // namespace plastica
