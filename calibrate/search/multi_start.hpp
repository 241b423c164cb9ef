#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "calibrate/search/marquardt_steps.hpp"
#include "calibrate/search/pass_kinks.hpp"

namespace plastica::calibrate {

/// Where Gauss and Newton's steps have come to, and their model of the cost there.
struct Basin {
  Eigen::VectorXd x;  ///< (n)
  SquaresModel model;
};

/// Whether each of two points lies where the other one's model has risen by no more than a fraction
/// of the smaller cost: dx . normal dx <= rise cost, with both matrices.
bool same_basin(const Basin& a, const Basin& b, double rise);

/// How many of several searches go to their ends.
struct MultiStartOptions {
  int short_evaluations = 8;  ///< of each search before the best are chosen, >= 1
  std::size_t polished = 2;   ///< how many go on
  /// Past kinks go those alone that come down to so many times the least cost that is known.
  double near = 1.5;
  double known = std::numeric_limits<double>::infinity();  ///< such a cost, of elsewhere
  double rise = 0.1;  ///< up to which a point is in a basin that is known, see `same_basin`
};

/// What several searches found.
struct Ends {
  std::vector<Minimum> apart;  ///< each in a basin of its own
  /// In basins that were known: as far as they had come when that was seen.
  std::vector<Minimum> alike;
};

/// Short searches by "gauss-newton" from several points, of which the best go on to their ends. One
/// that comes into a basin that is known goes no further.
/// @param problem  with cost and squares; its start does not count
/// @param starts  within its box (n_starts, n)
/// @param how  of the descents
/// @param known  basins, to which the new ones are added
/// @throws whatever the problem's functions threw
Ends search_from(const Problem& problem, const std::vector<std::vector<double>>& starts,
                 const MultiStartOptions& options, const MinimizeOptions& how,
                 const StageListener& tell, std::vector<Basin>& known);

/// When enough searches have ended at the least of the minima that kinks make in one basin.
struct AgreementOptions {
  std::size_t enough = 4;  ///< ends at the least cost, the one that is known among them
  std::size_t max = 12;    ///< searches past kinks at most
  double same = 1e-6;      ///< costs that differ by this fraction are one
};

/// Lets points of one basin go past kinks, from the least cost on, until enough of them have come
/// to the same least cost.
/// @param best  the least that is known
/// @return the least end; `best` unless it is lower by more than what searches that are compared
///         leave open (`how.cost_tolerance`)
/// @throws whatever the problem's functions threw
Minimum least_of_basin(const Problem& problem, std::vector<Minimum> points, Minimum best,
                       const AgreementOptions& options, const MinimizeOptions& how,
                       const StageListener& tell);

}  // namespace plastica::calibrate
