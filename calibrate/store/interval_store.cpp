#include "calibrate/store/interval_store.hpp"

#include <stdexcept>
#include <string>

#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate::store {
namespace {

/// A bootstrap as a row of a table, each number of its intervals as a list.
struct BootstrapRow {
  std::string of;  ///< "residuals" or "specimens"
  BootstrapResult bootstrap;
  std::vector<double> standard_error, low, high;  ///< of its intervals (n_free)
};

/// Those of one fit.
struct BootstrapRows {
  std::vector<BootstrapRow> all;
};

template <typename Rows>
void traverse_bootstraps(Rows& fits) {
  auto rows = fits.list("bootstraps", PLASTICA_MEMBER(all), [](auto& columns) {
    columns("of", "", PLASTICA_MEMBER(of));
    columns("resamples", "1", PLASTICA_MEMBER(bootstrap.resamples));
    columns("failed", "1", PLASTICA_MEMBER(bootstrap.failed));
    columns("block", "1", PLASTICA_MEMBER(bootstrap.block));
  });
  rows.numbers("bootstraps/values", "", PLASTICA_MEMBER(bootstrap.values));
  rows.numbers("bootstraps/standard_error", "", PLASTICA_MEMBER(standard_error));
  rows.numbers("bootstraps/low", "", PLASTICA_MEMBER(low));
  rows.numbers("bootstraps/high", "", PLASTICA_MEMBER(high));
}

void add_row(const char* of, const BootstrapResult& bootstrap, BootstrapRows& rows) {
  if (bootstrap.resamples == 0) return;
  BootstrapRow& row = rows.all.emplace_back();
  row.of = of;
  row.bootstrap = bootstrap;
  for (const BootstrapInterval& interval : bootstrap.intervals) {
    row.standard_error.push_back(interval.standard_error);
    row.low.push_back(interval.low);
    row.high.push_back(interval.high);
  }
}

void take_row(const io::Hdf5Group& root, BootstrapRow& row, FitIntervals& intervals) {
  const auto refuse = [&](const char* column, const std::string& value, const char* rule) {
    io::refuse_value(root, std::string("bootstraps/") + column, value, rule);
  };
  if (row.standard_error.size() != row.low.size() || row.low.size() != row.high.size()) {
    refuse("low", "", "must have as many numbers as high and standard_error");
  }
  if (row.of != "residuals" && row.of != "specimens") {
    refuse("of", row.of, "must be residuals or specimens");
  }
  BootstrapResult& own = row.of == "residuals" ? intervals.residuals : intervals.specimens;
  if (own.resamples > 0) refuse("fit", "", "names a fit twice");
  own = std::move(row.bootstrap);
  if (own.failed > own.resamples || own.resamples == 0) {
    refuse("failed", std::to_string(own.failed), "must be no more than the resamples");
  }
  for (std::size_t k = 0; k < row.low.size(); ++k) {
    own.intervals.push_back({row.standard_error[k], row.low[k], row.high[k]});
  }
}

/// Whether values are rows of a table of so many columns, or so many rows of any.
bool is_table(const std::vector<double>& values, std::size_t extent) {
  return extent == 0 ? values.empty() : values.size() % extent == 0;
}

}  // namespace

void write_intervals(io::Hdf5Group& root, const std::vector<const FitOutcome*>& fits) {
  std::vector<std::string> paths;
  std::vector<BootstrapRows> bootstraps(fits.size());
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const FitIntervals& intervals = fits[i]->intervals;
    add_row("residuals", intervals.residuals, bootstraps[i]);
    add_row("specimens", intervals.specimens, bootstraps[i]);
    if (intervals.profiles.empty()) continue;
    for (const FittedParameter* p : fits[i]->free_parameters()) paths.push_back(p->path);
    if (intervals.profiles.size() != fits[i]->free_parameters().size()) {
      throw std::logic_error("write_intervals: a fit has not a profile a free parameter");
    }
  }
  root.write_texts("profiles/parameter", paths);
  WrittenRows<BootstrapRows> rows(root, pointers_to(std::span(std::as_const(bootstraps))));
  traverse_bootstraps(rows);
}

void read_intervals(const io::Hdf5Group& root, const std::vector<FitOutcome*>& fits) {
  std::vector<BootstrapRows> bootstraps(fits.size());
  ReadRows<BootstrapRows> rows({root, kFitRules}, pointers_to(std::span(bootstraps)));
  traverse_bootstraps(rows);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    for (BootstrapRow& row : bootstraps[i].all) take_row(root, row, fits[i]->intervals);
  }
}

void check_intervals(const io::Hdf5Group& root, const FitOutcome& fit) {
  const FitIntervals& intervals = fit.intervals;
  const std::size_t free = fit.free_parameters().size();
  if (!intervals.profiles.empty() && intervals.profiles.size() != free) {
    io::refuse_value(root, "profiles/fit", "", "does not name a fit once a free parameter");
  }
  for (const LikelihoodProfile& profile : intervals.profiles) {
    if (profile.rise.size() != profile.value.size() ||
        !is_table(profile.searched, profile.value.size())) {
      io::refuse_value(root, "profiles/searched", "", "must have a rise and a row for each value");
    }
  }
  for (const BootstrapResult* of : {&intervals.residuals, &intervals.specimens}) {
    if (of->resamples == 0) continue;
    if (of->intervals.size() != free || !is_table(of->values, free)) {
      io::refuse_value(root, "bootstraps/low", "", "does not have a number a free parameter");
    }
    if (free > 0 && of->values.size() / free > static_cast<std::size_t>(of->resamples)) {
      io::refuse_value(root, "bootstraps/values", "", "has more rows than resamples");
    }
  }
}

}  // namespace plastica::calibrate::store
