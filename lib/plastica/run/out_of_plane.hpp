#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "plastica/model/material_field.hpp"
#include "plastica/run/chain_model.hpp"

namespace plastica {

/// An equilibrium of a planar chain, as space sees it.
struct PlanarEquilibrium {
  struct Held {
    std::size_t support = 0;
    std::array<double, 3> direction{};  ///< zero where it holds a rotation
    std::array<double, 3> axis{};
    double multiplier = 0.0;
    bool closed = true;
  };
  double time = 0.0;
  std::vector<std::array<double, 3>> angle;  ///< rotation vectors of the joints (N)
  std::vector<std::array<double, 3>> shift;  ///< of elastic joints, in their axes (N), or empty
  /// Where joints have yielded, the elastic part of the angles; else empty.
  std::vector<std::array<double, 3>> elastic;  ///< of the joints (N), then at `ground_node`
  std::vector<std::size_t> ground_node;        ///< of joints to the ground: their segment ends
  /// Then, of sections that yield in part: the stiffness that they have left for bending about the
  /// other axis, over the elastic one (as `elastic`), or empty where all is left.
  std::vector<double> aside;
  std::array<double, 3> root{};  ///< free translation of the start [m]
  std::vector<Held> held;        ///< constraints
};

/// Whether a planar chain would leave its plane: the spatial tangent about its equilibria, of which
/// only the freedoms out of the plane are looked at; at a planar state they go with none of the
/// others. Torsion is elastic, and so is bending about the other axis, but for fibres: those that
/// flow have the slope of their hardening (the tangent modulus; Engesser, Shanley 1947). README.md,
/// Stability.
class OutOfPlane {
 public:
  virtual ~OutOfPlane() = default;
  /// Whether the supports hold the beam out of its plane at all.
  virtual bool applies() const = 0;
  /// Whether all that acts has a potential in space; else `unstable_modes` is a parity.
  virtual bool has_potential() const = 0;
  /// Number of unstable modes out of the plane.
  virtual int unstable_modes(const PlanarEquilibrium& at) = 0;
  /// Logarithm of the determinant that changes its sign with them, up to a constant.
  virtual double log_determinant(const PlanarEquilibrium& at) = 0;
  /// Appends the mode in which it would be left just there: translations of the joints, the
  /// largest being 1 (n_joints x 3).
  virtual void add_mode(const PlanarEquilibrium& at, std::vector<double>& mode) = 0;

  /// Takes an equilibrium as that from which all forces grow on at the same shape, as for
  /// `solve::Pencil`.
  /// @param reach  as for `let_held_grow`
  virtual void let_forces_grow(const PlanarEquilibrium& at, double reach) = 0;
  /// `unstable_modes`, and `add_mode`, a time later than that.
  virtual int unstable_after(double time) = 0;
  virtual void add_mode_after(double time, std::vector<double>& mode) = 0;
};

/// @param model     of a planar level, which outlives what is made
/// @param material  of the scene's own part
std::unique_ptr<OutOfPlane> make_out_of_plane(const ChainModel& model,
                                              const MaterialValues<double>& material);

}  // namespace plastica
