#include "sweeps/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica::sweeps {

void Worst::add(const std::optional<double>& number, std::size_t whose,
                const std::string& otherwise) {
  keep(number, whose, otherwise);
  if (lacks_one()) return;
  if (!number || !std::isfinite(*number)) {
    reason_ = otherwise.empty() ? "there is no number" : otherwise;
    whose_ = whose;
  } else if (!number_ || badness(*number) > badness(*number_)) {
    number_ = number;
    whose_ = whose;
  }
}

void Worst::keep(const std::optional<double>& number, std::size_t whose,
                 const std::string& otherwise) {
  ++added_;
  const bool is_number = number && std::isfinite(*number);
  const double off = is_number ? badness(*number) : std::numeric_limits<double>::infinity();
  const auto place = std::ranges::find_if(worst_, [&](const Entry& e) { return e.badness < off; });
  if (place == worst_.end() && worst_.size() == kMostJudged) return;
  if (is_number) {
    worst_.insert(place, {number, whose, "", off});
  } else {
    worst_.insert(place, {std::nullopt, whose, otherwise, off});
  }
  if (worst_.size() > kMostJudged) worst_.pop_back();
}

ClaimVerdict Worst::verdict(const std::function<std::string(std::size_t whose)>& name) const {
  ClaimVerdict verdict;
  verdict.judged = added_;
  for (const Entry& entry : worst_) {
    verdict.worst.push_back({name ? name(entry.whose) : std::string(), entry.number, entry.reason});
  }
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
