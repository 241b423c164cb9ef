#include "calibrate/fit/unseen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "calibrate/fit/fit_law.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/base/parallel_for.hpp"

namespace plastica::calibrate {
namespace {

/// Others that foretell a specimen at most.
constexpr std::size_t kMates = 10;

/// What is left of a target's curve by another one's values, as a fraction squared; NaN where the
/// model cannot be run with them.
class Foretold {
 public:
  Foretold(const Target& target, const FitOptions& options)
      : set_(target, options), misfit_(target, options, set_), residual_(target.corrected.size()) {}

  double by(const FitResult& other) {
    std::vector<double> active;
    for (const std::size_t i : set_.active()) {
      const auto path = set_.all()[i].field->path;
      const auto p = std::ranges::find(other.parameters, path, &FittedParameter::path);
      active.push_back(p != other.parameters.end() ? p->value : set_.all()[i].start);
    }
    if (!misfit_.residuals(active, residual_)) return std::numeric_limits<double>::quiet_NaN();
    double squares = 0.0;
    for (std::size_t s = 0; s < residual_.size(); ++s) {
      squares += misfit_.weights()[s] * residual_[s] * residual_[s];
    }
    return squares / misfit_.cost_unit();
  }

 private:
  ParameterSet set_;
  Misfit misfit_;
  std::vector<double> residual_;
};

/// The fits of one law of specimens that can foretell each other, by name; of those alone that
/// every law was fitted to, so that all laws are asked the same.
std::vector<std::vector<std::size_t>> groups_of(std::span<const Target> targets,
                                                std::span<const FitCase> cases,
                                                std::span<const FitResult> results) {
  using Key = std::tuple<Law, std::vector<std::pair<std::string, std::string>>, Test, Loading>;
  std::map<Key, std::vector<std::size_t>> groups;
  std::vector<bool> fitted(targets.size(), true);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (results[c].status != FitStatus::Fitted) fitted[cases[c].target] = false;
  }
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (!cases[c].law || !fitted[cases[c].target]) continue;
    const Target& target = targets[cases[c].target];
    groups[{*cases[c].law, target.group, target.test, target.loading}].push_back(c);
  }
  std::vector<std::vector<std::size_t>> all;
  for (auto& [key, members] : groups) {
    std::ranges::sort(members, {}, [&](std::size_t c) { return targets[cases[c].target].name; });
    all.push_back(std::move(members));
  }
  return all;
}

}  // namespace

void add_unseen(std::span<const Target> targets, std::span<const FitCase> cases,
                const FitOptions& options, int threads, std::span<FitResult> results) {
  if (options.laws.size() < 2) return;
  for (const std::vector<std::size_t>& group : groups_of(targets, cases, results)) {
    const std::size_t mates = std::min(kMates, group.size() - 1);
    if (mates == 0) continue;
    std::vector<double> left(group.size());
    parallel_for(group.size(), {threads}, [&](std::size_t i, int) {
      const FitCase& one = cases[group[i]];
      const CorrectedTarget target(targets[one.target]);
      const FitOptions own = options_of(*one.law, options, target->loading);
      Foretold foretold(*target, own);
      double sum = 0.0, ran = 0.0;
      for (std::size_t k = 1; k <= mates; ++k) {
        const double by = foretold.by(results[group[(i + k) % group.size()]]);
        if (!std::isfinite(by)) continue;
        sum += by;
        ran += 1.0;
      }
      left[i] = sum / ran;  // not a number where none ran
    });
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (std::isfinite(left[i])) results[group[i]].unseen = left[i];
    }
  }
}

}  // namespace plastica::calibrate
