#include "sweeps/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica::sweeps {

void Worst::add(const std::optional<double>& number, std::size_t whose,
                const std::string& otherwise) {
  if (lacks_one()) return;
  if (!number || !std::isfinite(*number)) {
    reason_ = otherwise.empty() ? "there is no number" : otherwise;
    whose_ = whose;
  } else if (!number_ || badness(*number) > badness(*number_)) {
    number_ = number;
    whose_ = whose;
  }
}

ClaimVerdict Worst::verdict() const {
  ClaimVerdict verdict;
  if (!lacks_one()) verdict.number = number_;
  if (lacks_one()) {
    verdict.reason = reason_;
  } else if (!number_) {
    verdict.reason = "no case is chosen";
  } else {
    verdict.holds = badness(*number_) <= 0.0;
  }
  return verdict;
}

double Worst::badness(double number) const {
  double worst = -std::numeric_limits<double>::infinity();
  if (claim_.at_least) worst = std::max(worst, *claim_.at_least - number);
  if (claim_.at_most) worst = std::max(worst, number - *claim_.at_most);
  return worst;
}

}  // namespace plastica::sweeps
