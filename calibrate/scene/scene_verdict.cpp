#include "calibrate/scene/scene_verdict.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "calibrate/fit/compare_laws.hpp"

namespace plastica::calibrate {

namespace {

/// How many times as many segments leave as much as the noise does: "; about 1.9 times as many …".
std::string enough_segments(const SceneParameter& p, const SegmentsError& segments) {
  constexpr double kMost = 1000.0;
  const double over = segments.error / (std::sqrt(3.0) * p.noise_error);
  const double times = std::pow(over, 1.0 / segments.order);
  if (!(times < kMost)) return "";
  return fmt::format("; about {:.1f} times as many segments would make both alike",
                     std::ceil(10.0 * times) / 10.0);
}

}  // namespace

void judge(double half, const SegmentsError& segments, double prior, SceneParameter& p) {
  const bool seen = segments.trend > SegmentsTrend::Settled;
  const Judgement judgement = calibrate::judge({.value = p.value,
                                                .lower = p.lower,
                                                .upper = p.upper,
                                                .at_bound = p.at_bound,
                                                .noise_error = p.noise_error,
                                                .half = half,
                                                .standard_error = p.standard_error,
                                                .segments = seen ? segments.error : 0.0,
                                                .prior = prior});
  p.verdict = judgement.verdict;
  p.verdict_number = judgement.number;
}

void add_warning(const SceneParameter& p, const SegmentsError& segments,
                 std::vector<std::string>& warnings) {
  const std::string name = p.path.substr(p.path.rfind('.') + 1);
  if (p.verdict == Verdict::LimitedBySegments) {
    warnings.push_back(fmt::format(
        "{} is limited by segments: what they do to it, {:.2g} % of it, {}{}", name,
        100.0 * p.verdict_number,
        std::isnan(segments.order) ? "does not fall steadily with their number"
                                   : fmt::format("is more than the noise does, {:.2g} %",
                                                 100.0 * p.noise_error / std::abs(p.value)),
        enough_segments(p, segments)));
    return;
  }
  std::string warning = warning_of(name, {p.verdict, p.verdict_number}, p.lower);
  if (!warning.empty()) warnings.push_back(std::move(warning));
}

void add_warning(const ScenePartFit& part, Law law, std::string_view try_next,
                 std::vector<std::string>& warnings) {
  const std::string lack =
      lack_of_fit(phrase_of(law), part.misfit_share, part.runs_probability, try_next);
  if (!lack.empty()) warnings.push_back(part.name + ": " + lack);
}

}  // namespace plastica::calibrate
