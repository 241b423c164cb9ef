#pragma once

#include <vector>

namespace plastica {

/// How a path was followed.
struct PathCounters {
  int steps = 0;       ///< converged, recorded or not
  int iterations = 0;  ///< Newton iterations, those of failed steps included
  int cutbacks = 0;    ///< steps that were tried again shorter
};

/// The load factor between whose ends the last equilibrium lies [1]; set with Status::LimitLoad.
struct LimitLoad {
  double below = 0.0;  ///< equilibrium was found here
  double above = 0.0;  ///< and none here; of fibres, to where it may rise at most (chain/README.md)
  /// The mode in which the beam moves there: translations of the joints in the last step, world
  /// axes, the largest being 1 (n_joints x 3); none of a beam that is only twisted.
  std::vector<double> mode{};
};

/// Where a beam that yields gives way, and the path goes on: it moved so many times as far as it
/// would have elastically while the factor rose from one to the other.
struct Plateau {
  double from = 0.0;
  double to = 0.0;
  double times = 0.0;
};

/// The bifurcations that a path has passed, in the order of time: where the number of unstable
/// modes changes, while the path goes on (at a limit load it does not).
struct CriticalPoints {
  std::vector<double> factor;       ///< of the first load's history [1] (n)
  std::vector<double> below;        ///< the factors that it lies between [1] (n)
  std::vector<double> above;        ///< (n)
  std::vector<int> unstable_modes;  ///< beyond it; 0: stable (n)
  std::vector<int> out_of_plane;    ///< 1: it leaves the plane of a planar level (n)
  /// Translations of the joints in the mode, world axes, the largest being 1 (n x n_joints x 3).
  std::vector<double> mode;

  bool empty() const { return factor.empty(); }
};

/// Loads at which a beam buckles, from the tangent at one of its equilibria with all forces growing
/// on at the same shape (solve/pencil.hpp).
struct BucklingModes {
  double about = 0.0;          ///< factor of the equilibrium, a stable one [1]
  std::vector<double> factor;  ///< from `about` on, in the direction in which it goes [1] (n)
  /// By how much some segment will have turned up to there, if all turn on as they do at `about`: 0
  /// where the shape stays; where it is large, the factor is that of a shape that will be another
  /// [rad] (n).
  std::vector<double> rotation;
  std::vector<int> out_of_plane;  ///< as of `CriticalPoints` (n)
  std::vector<double> mode;       ///< likewise (n x n_joints x 3)
};

/// Small undamped vibrations about an equilibrium.
struct VibrationModes {
  std::vector<double>
      frequency;  ///< rising; 0 where nothing resists, or the load pushes on [Hz] (n)
  /// Translations of the joints, world axes, the largest being 1; 0 where sections turn about the
  /// beam alone (n x n_joints x 3).
  std::vector<double> mode;
};

}  // namespace plastica
