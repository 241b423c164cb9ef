#include "calibrate/store/scene_fit_digest.hpp"

#include "calibrate/inference/not_a_number.hpp"
#include "plastica/base/renamed.hpp"
#include "plastica/io/scene_digest.hpp"

namespace plastica::calibrate {
void add_to(io::Digest& digest, const SceneTarget& t) {
  digest.integer(static_cast<std::uint64_t>(t.kind)).integer(t.driven);
  digest.reals(t.abscissa).reals(t.ordinate).text(t.abscissa_probe).text(t.ordinate_probe);
  digest.real(t.abscissa_factor).real(t.ordinate_factor).real(t.noise.value_or(kNan));
  digest.real(t.broke ? t.broke->at : kNan).real(t.broke ? t.broke->half_interval : kNan);
  // Decides nothing, but stands in the result; one sample is what the version before had.
  if (t.broke && t.broke->cut > 1) digest.integer(t.broke->cut);
  for (const Repair& repair : t.repairs) digest.text(repair.kind).integer(repair.count);
  for (const std::string& warning : t.warnings) digest.text(warning);
}

void add_to(io::Digest& digest, const SceneFitOptions& options) {
  for (const Parameter& p : options.parameters) {
    digest.text(old_path(p.field->path)).integer(static_cast<std::uint64_t>(p.role));
    digest.integer(static_cast<std::uint64_t>(p.scale)).real(p.value.value_or(kNan));
    digest.real(p.lower.value_or(kNan)).real(p.upper.value_or(kNan));
    digest.text(p.tied_to != nullptr ? old_path(p.tied_to->path) : "").real(p.factor);
    digest.real(p.prior ? p.prior->mean : kNan);
    digest.real(p.prior ? p.prior->standard_deviation : kNan);
  }
  digest.integer(static_cast<std::uint64_t>(options.evaluations)).real(options.tolerance);
  digest.integer(static_cast<std::uint64_t>(options.starts)).integer(options.seed);
  digest.integer(static_cast<std::uint64_t>(options.screen));
  digest.integer(options.further_starts.size());
  for (const StartPoint& start : options.further_starts) {
    digest.integer(start.size());
    for (const auto& [field, value] : start) digest.text(old_path(field->path)).real(value);
  }
  digest.integer(options.laws.size());
  for (const Law law : options.laws) digest.text(name_of(law));
  digest.real(options.confidence).integer(options.segments_error ? 1 : 0);
  if (options.segments_within > 0.0) digest.real(options.segments_within);
  digest.integer(static_cast<std::uint64_t>(options.objective)).text(options.algorithm);
  const IntervalOptions& intervals = options.intervals;
  digest.integer(intervals.profile ? 1 : 0);
  for (const int number : {intervals.bootstrap, intervals.block, intervals.specimens}) {
    digest.integer(static_cast<std::uint64_t>(number));
  }
}

std::uint64_t digest_of(std::span<const WeightedTarget> targets, const SceneFitOptions& options) {
  io::Digest digest;
  for (const WeightedTarget& weighted : targets) {
    digest.text(weighted.target.name)
        .integer(io::scene_digest(weighted.setup))
        .real(weighted.weight);
    add_to(digest, weighted.target);
  }
  add_to(digest, options);
  return digest.value();
}

}  // namespace plastica::calibrate
