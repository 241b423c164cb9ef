#include "plastica/solve/first_roots.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::solve {
namespace {

/// Of an x: how near to a root rounding counts it on the wrong side, generously.
constexpr double kRounding = 1e-6;

/// An x, and how many roots are not above it.
struct Counted {
  double x;
  int passed;
};

class Bisection {
 public:
  Bisection(const std::function<int(double)>& passed, const RootSearch& search)
      : passed_(passed), search_(search) {}

  Roots roots() {
    const Counted from{search_.from, passed_(search_.from)};
    Counted to = from;
    Counted below = from;
    for (double reach = search_.reach; reach <= search_.most * search_.reach; reach *= 2.0) {
      if (is_raised(search_.stop)) return {};
      to = {search_.from + reach, passed_(search_.from + reach)};
      roots_.falls = roots_.falls || to.passed < below.passed;
      if (to.passed - from.passed >= search_.count) break;
      below = to;
    }
    split(from, below);
    split(below, to);
    return std::move(roots_);
  }

 private:
  void split(const Counted& below, const Counted& above) {
    const auto wanted = static_cast<std::size_t>(search_.count);
    if (above.passed <= below.passed || roots_.at.size() >= wanted || is_raised(search_.stop))
      return;
    const double middle = 0.5 * (below.x + above.x);
    const double width = search_.tolerance * std::max(std::fabs(below.x), std::fabs(above.x));
    if (above.x - below.x <= width || middle <= below.x || middle >= above.x) {
      const auto here = static_cast<std::size_t>(above.passed - below.passed);
      roots_.at.insert(roots_.at.end(), std::min(here, wanted - roots_.at.size()), middle);
      return;
    }
    // What rounding counts amiss beside a root stays between its neighbours.
    const int passed = passed_(middle);
    const Counted at{middle, std::clamp(passed, below.passed, above.passed)};
    const bool far =
        above.x - below.x > kRounding * std::max(std::fabs(below.x), std::fabs(above.x));
    roots_.falls = roots_.falls || (far && at.passed != passed);
    split(below, at);
    split(at, above);
  }

  const std::function<int(double)>& passed_;
  const RootSearch& search_;
  Roots roots_;
};

}  // namespace

Roots first_roots(const std::function<int(double)>& passed, const RootSearch& search) {
  return Bisection(passed, search).roots();
}

}  // namespace plastica::solve
