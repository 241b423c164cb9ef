#pragma once

#include <optional>
#include <vector>

#include "plastica/run/chain_body.hpp"
#include "plastica/run/out_of_plane.hpp"
#include "plastica/solve/buckling_mode.hpp"
#include "plastica/solve/pencil.hpp"

namespace plastica {

/// Buckling and vibration about one equilibrium of a chain: chain/README.md.
template <class L, bool kElastic>
class ChainModes {
 public:
  using S = typename L::Scalar;

  /// Assembles the chain in the body's work, which it uses from then on.
  /// @param q        where it is in equilibrium
  /// @param yielded  whether joints have: they are then taken as they unload
  ChainModes(ChainBody<L, kElastic>& body, const chain::Coordinates<L>& q, double time,
             bool yielded);

  /// The first load factors at which it buckles as all forces grow on.
  /// @param beside  what grows beside a planar chain; may be null
  /// @param stop  once raised, what has been found so far is returned
  /// @return none if the equilibrium is not stable, nothing acts there or the tangent is not
  ///         symmetric; else fewer than `count` if no more are found below 1e15 times the load
  std::optional<BucklingModes> buckling(int count, OutOfPlane* beside, StopFlag stop = nullptr);
  /// Its lowest natural frequencies.
  /// @param count  no more than the chain has degrees of freedom
  /// @return none if the tangent is not symmetric
  std::optional<VibrationModes> vibration(int count, StopFlag stop = nullptr);
  /// Degrees of freedom of the chain.
  int freedoms();
  /// Lets supports go that hold what others hold already: a straight chain's end does not move
  /// along it.
  void release_idle_constraints();

 private:
  /// A single unit motion of a joint, or of the start, with all beyond locked.
  struct Coordinate {
    double stiffness;  ///< [N m/rad, N/m]
    double mass;       ///< [kg m^2, kg]
  };
  /// A bifurcation.
  struct Root {
    double time;  ///< after that of the equilibrium [s]
    bool out_of_plane;
  };

  /// How the shown factor grows, or that of the first history that does [1/s]; and its value.
  double growth(double before, double time, double reach, bool held, double& about) const;
  void unload(const chain::Coordinates<L>& q);
  void gather();
  int unstable_modes();
  bool is_symmetric(solve::Pencil<L, kElastic>& pencil, double x);
  std::vector<Coordinate> coordinates();
  /// Least omega^2 of a single coordinate that something resists [1/s^2].
  double softest();
  /// The first constraint that holds nothing with the inertia of a motion at omega^2, or none.
  std::size_t idle_constraint(double square);
  /// Appends the mode of a root.
  /// @param again  whether it is that of the root before, which is there more than once
  void add_mode(solve::Pencil<L, kElastic>& pencil, double root, bool again,
                std::vector<double>& mode);

  ChainBody<L, kElastic>& body_;
  solve::NewtonWork<L, kElastic>& w_;
  std::vector<std::vector<chain::Motion<L>>> known_;  ///< modes of one root
};

}  // namespace plastica
