#pragma once

#include <functional>
#include <vector>

#include "plastica/base/stop_flag.hpp"

namespace plastica::solve {

/// Where eigenvalues of a matrix that changes with x go through zero, by how many have done so.
struct RootSearch {
  double from = 0.0;         ///< roots are sought above
  double reach = 1.0;        ///< first guess of how far, > 0
  double most = 1e12;        ///< as far at most, in units of `reach`
  int count = 1;             ///< how many roots
  double tolerance = 1e-13;  ///< of a root [1]
  StopFlag stop = nullptr;   ///< once raised, no more are sought
};

struct Roots {
  std::vector<double> at;  ///< rising
  /// Whether the number that is passed fell on the way, by more than rounding beside a root: what
  /// is sought are not the eigenvalues of a symmetric matrix then, and roots may be missing.
  bool falls = false;
};

/// The first roots above `from`, rising, each as often as it counts; fewer if there are no more.
/// By bisection: no root is missed, however near another it lies (Wittrick & Williams, Q. J. Mech.
/// Appl. Math. 24, 1971, 263).
/// @param passed  how many eigenvalues have gone through zero up to x
Roots first_roots(const std::function<int(double x)>& passed, const RootSearch& search);

/// Looks at a root, or just below: at it itself a pivot may be 0, and nothing comes of it.
/// @param look  (x): whether what came of it is finite
template <class Look>
void look_at_root(double root, const Look& look) {
  for (const double below : {0.0, 1e-10, 1e-8}) {
    if (look(root * (1.0 - below))) return;
  }
}

}  // namespace plastica::solve
