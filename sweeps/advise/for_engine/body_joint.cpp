#include "sweeps/advise/for_engine/body_joint.hpp"

#include <cmath>

#include "plastica/chain/rotation.hpp"

namespace plastica::sweeps {
namespace {

using Vector3 = Vec<double, 3>;
using Matrix3 = Mat<double, 3, 3>;

/// The quaternion of a rotation vector: w, and the rest.
struct UnitQuaternion {
  double w = 1.0;
  Vector3 rest{};

  explicit UnitQuaternion(const Vector3& rotation) {
    const double angle = std::sqrt(dot(rotation, rotation));
    w = std::cos(0.5 * angle);
    rest = (angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5) * rotation;
  }
};

void add_row(MateTerms& mate, std::size_t from, std::size_t k, double gap, const Matrix3& here,
             const Matrix3& before) {
  for (std::size_t c = 0; c < 3; ++c) {
    mate.here(mate.rows, from + c) = here(k, c);
    mate.before(mate.rows, from + c) = before(k, c);
  }
  mate.gap[mate.rows] = gap;
}

/// Each row of a matrix times a number of its own.
Matrix3 scaled_rows(const Vector3& by, Matrix3 m) {
  for (std::size_t k = 0; k < 9; ++k) m.at[k] *= by[k / 3];
  return m;
}

}  // namespace

MateTerms mate_terms(const BodyJoint& joint, const BodyState& here, const BodyState& before) {
  MateTerms mate;
  const Matrix3 to_joint = transpose(before.frame * joint.axes_before);  // B^T
  const Matrix3 relative = to_joint * here.frame;
  const Vector3 apart = here.position + here.frame * joint.point_here - before.position -
                        before.frame * joint.point_before;
  const Vector3 gap = to_joint * apart;
  const Matrix3 turn_here = -(relative * skew(joint.point_here));
  const Matrix3 turn_before = transpose(joint.axes_before) *
                              skew(joint.point_before + transposed_times(before.frame, apart));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!joint.holds_translation[k]) continue;
    add_row(mate, 0, k, gap[k], to_joint, -to_joint);
    add_row(mate, 3, k, gap[k], turn_here, turn_before);
    ++mate.rows;
  }
  if (joint.holds_rotation == std::array<bool, 3>{}) return mate;
  const UnitQuaternion q(chain::rotation_vector(relative * joint.axes_here));
  // d(rest)/dt = (w - [rest]) spin/2, of a spin in the axes of B.
  const Matrix3 half = 0.5 * (q.w * identity<double, 3>() - skew(q.rest));
  const Matrix3 by_here = half * relative;
  const Matrix3 by_before = -(half * transpose(joint.axes_before));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!joint.holds_rotation[k]) continue;
    add_row(mate, 3, k, q.rest[k], by_here, by_before);
    ++mate.rows;
  }
  return mate;
}

BushingTerms bushing_terms(const BodyJoint& joint, const BodyState& here, const BodyState& before) {
  BushingTerms terms;
  const Matrix3 to_before = transpose(joint.axes_before);  // from the body before to B
  const Matrix3 turn = transpose(before.frame) * here.frame;
  const Matrix3 to_joint = to_before * turn;  // from the body to B
  const Vector3 rotation = chain::rotation_vector(to_joint * joint.axes_here);
  const Vector3 spin = turn * here.spin;
  const Vector3 relative_spin = to_before * (spin - before.spin);
  Vector3 moment;
  for (std::size_t k = 0; k < 3; ++k) {
    moment[k] = joint.stiffness[k] * rotation[k] + joint.damping[k] * relative_spin[k];
  }
  const Vector3 on_before = transposed_times(to_before, moment);
  const Vector3 on_here = transposed_times(to_joint, moment);
  terms.moment_before = on_before;
  terms.moment_here = -on_here;
  // d(moment) along B's axes, by increments of the rotation of each body in its own axes.
  const chain::RotationCoefficients<double> coefficients(dot(rotation, rotation));
  const Matrix3 springs =
      scaled_rows(joint.stiffness, chain::inverse_tangent_map(rotation, coefficients));
  const Matrix3 by_here =
      springs * to_joint - scaled_rows(joint.damping, to_joint * skew(here.spin));
  const Matrix3 by_before =
      scaled_rows(joint.damping, to_before * skew(spin)) - springs * to_before;
  const Matrix3 from_here = transpose(to_joint);
  const Matrix3 from_before = transpose(to_before);
  // The moment on the body turns with B, as seen from the body.
  terms.stiffness_here_here = skew(on_here) + from_here * by_here;
  terms.stiffness_here_before = from_here * by_before - transpose(turn) * skew(on_before);
  terms.stiffness_before_here = -(from_before * by_here);
  terms.stiffness_before_before = -(from_before * by_before);
  const Matrix3 damped_here = scaled_rows(joint.damping, to_joint);
  const Matrix3 damped_before = scaled_rows(joint.damping, to_before);
  terms.damping_here_here = from_here * damped_here;
  terms.damping_here_before = -(from_here * damped_before);
  terms.damping_before_here = -(from_before * damped_here);
  terms.damping_before_before = from_before * damped_before;
  return terms;
}

}  // namespace plastica::sweeps
