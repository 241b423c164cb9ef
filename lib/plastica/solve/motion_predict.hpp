#pragma once

#include "plastica/solve/motion_step.hpp"

/// Where the velocities point to: the first guess of a step, right to second order.
namespace plastica::solve {

template <class L, bool kElastic>
void MotionStep<L, kElastic>::predict(double length) {
  const S h = constant<S>(length);
  typename L::Spin inner_spin = slope_of(chain_.root.history) * chain_.root.rotation;
  typename L::Point inner_velocity{};
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const auto& frame = begin_.frame[i];
    const typename L::Spin spin = L::axes(frame) * motion_[i].spin;
    const typename L::Point arm = L::rotate(frame, chain_.inertias[i].center);
    const typename L::Point velocity = motion_[i].velocity - L::spun(spin, arm);
    if (any(w_.q.open[i])) {
      const S size = max(h * size_of(spin), constant<S>(1e-30));
      const S fraction = min(constant<S>(1), constant<S>(0.5 * kLargestStepSpin) / size);
      const typename L::Spin increment = fraction * (h * spin);
      w_.q.pose[i].position += h * velocity;
      w_.q.pose[i].frame = L::compose(L::rotation(increment), w_.q.pose[i].frame);
    } else {
      if (i == 0) {
        const typename L::Point ground = slope_of(chain_.root.history) * chain_.root.motion;
        for (std::size_t k = 0; k < L::kTranslations; ++k) {
          if (!chain_.root.held[k]) w_.q.root[k] += h * (velocity[k] - ground[k]);
        }
        inner_velocity = velocity;
      }
      predict_joint(i, h, inner_spin, velocity - inner_velocity);
    }
    inner_spin = spin;
    inner_velocity = velocity + L::spun(spin, L::rotate(frame, chain_.segments[i].arm));
  }
}

/// @param gap_rate  velocity of the segment's joint less that of its inner neighbour
template <class L, bool kElastic>
void MotionStep<L, kElastic>::predict_joint(std::size_t i, const S& h,
                                            const typename L::Spin& inner_spin,
                                            const typename L::Point& gap_rate) {
  const typename L::Spin spin = L::axes(begin_.frame[i]) * motion_[i].spin;
  typename L::Spin increment = h * transposed_times(L::axes(begin_.near[i]), spin - inner_spin);
  const S most = constant<S>(options_.largest_rotation);
  const S size = size_of(increment);
  const mask_t<S> turns_far = size > most;
  if (any(turns_far)) {
    const typename L::Spin shorter = (most / size) * increment;
    increment = select(turns_far, shorter, increment);
  }
  w_.q.angle[i] = L::add_rotation(increment, w_.q.angle[i]);
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    if (i == 0 && chain_.root.clamped[k]) w_.q.angle[i][k] = q_begin_.angle[i][k];
  }
  if constexpr (kElastic) {
    // The gap (near + far) u/2 grows with the shift and turns with both sides.
    const auto near = L::frame_matrix(begin_.near[i]);
    const auto far = L::frame_matrix(begin_.far[i]);
    const typename L::Point& shift = q_begin_.shift[i];
    const S half = constant<S>(0.5);
    const typename L::Point displaced =
        L::spun(inner_spin, half * (near * shift)) + L::spun(spin, half * (far * shift));
    if (i > 0) {
      w_.q.shift[i] += h * (chain::inverse(half * (near + far)) * (gap_rate - displaced));
    }
  }
}

/// What a second order scheme foretells the next step by: see `error`.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::note_accelerations() {
  const S rate = constant<S>(1.0 / h_);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    acceleration_[i] = rate * (motion_now_[i].velocity - motion_[i].velocity);
    if constexpr (kTwists<L>) {
      twist_rate_[i] = rate * (twist_of<L>(motion_now_[i].spin) - twist_of<L>(motion_[i].spin));
    }
  }
}

/// The displacement of a segment less what its velocity and acceleration before the step foretell.
/// A twist displaces no axis: it counts by itself, times the beam's length.
///
/// With a jerk j, a step h after one of h0 differs by j h^3 (1/6 + h0/(4 h)), of which a second
/// order midpoint scheme makes j h^3/12 of error; an Euler step of acceleration a differs from its
/// velocity before by a h^2 and makes a h^2/2. After a jump the acceleration is not known and
/// counts whole.
template <class L, bool kElastic>
double MotionStep<L, kElastic>::error() const {
  const bool first_order = claims_.order == 1;
  const bool known = !first_order && h_before_ > 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const S h = constant<S>(h_);
    typename L::Point off = step_[i].displacement - h * motion_[i].velocity;
    if (known) off -= constant<S>(0.5 * h_ * h_) * acceleration_[i];
    largest = std::max(largest, double(size_of(off)));
    if constexpr (kTwists<L>) {
      const typename L::Spin spin = transposed_times(L::axes(begin_.frame[i]), step_[i].spin);
      S turned = twist_of<L>(spin) - h * twist_of<L>(motion_[i].spin);
      if (known) turned -= constant<S>(0.5 * h_ * h_) * twist_rate_[i];
      largest = std::max(largest, chain_.length * double(abs(turned)));
    }
  }
  return largest * (known ? 1.0 / (2.0 + 3.0 * h_before_ / h_) : 0.5);
}

/// A step of Newton's method can leave forces that are below the rounding of positions, times the
/// mass over the square of the step: no further one brings them down. What acts before the first
/// may be smaller, and moves the beam all the same: moments that twist it come from rotations
/// alone, and what is small adds up over the steps.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_force_floor() {
  // Times the least tolerance, four times the rounding.
  constexpr double kFraction = kIsDouble<S> ? 1e-4 : 0.03;
  E far = E(chain_.length);
  const E fraction = constant<E>(kFraction);
  const E square = constant<E>(h_ * h_);
  if constexpr (L::kTranslations > 0) {
    for (const std::size_t i : {std::size_t{0}, chain_.size() - 1}) {
      far = max(far, E(size_of(begin_.position[i])));
    }
    w_.force_floor = S(fraction * mass_ * far / square);
  } else {
    E rotational = constant<E>(0.0);
    for (const auto& inertia : chain_.inertias) rotational += inertia.rotational(0, 0);
    // Angles of a shaft grow with its turns, and their rounding with them.
    E turned = constant<E>(1.0);
    for (const std::size_t i : {std::size_t{0}, chain_.size() - 1}) {
      turned = max(turned, E(abs(begin_.frame[i].angle)));
    }
    w_.force_floor = S(fraction * rotational * turned / (square * far));
  }
}

}  // namespace plastica::solve
