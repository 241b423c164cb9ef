#include "calibrate/store/interval_store.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/fit_rules.hpp"

namespace plastica::calibrate::store {
namespace {

constexpr io::DatasetOptions kPlain{{}, kDeflate};

struct ProfileRow {
  std::uint64_t fit = 0;
  std::string parameter;
  LikelihoodProfile profile;
};

struct BootstrapRow {
  std::uint64_t fit = 0;
  std::string of;  ///< "residuals" or "specimens"
  BootstrapResult bootstrap;
};

constexpr auto kProfileColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("parameter", "", PLASTICA_MEMBER(parameter));
  columns("low", "", PLASTICA_MEMBER(profile.low));
  columns("high", "", PLASTICA_MEMBER(profile.high));
  columns("low_end", "", PLASTICA_MEMBER(profile.low_end));
  columns("high_end", "", PLASTICA_MEMBER(profile.high_end));
  columns("threshold", "1", PLASTICA_MEMBER(profile.threshold));
};

constexpr auto kBootstrapColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("of", "", PLASTICA_MEMBER(of));
  columns("resamples", "1", PLASTICA_MEMBER(bootstrap.resamples));
  columns("failed", "1", PLASTICA_MEMBER(bootstrap.failed));
  columns("block", "1", PLASTICA_MEMBER(bootstrap.block));
};

/// The lists of a table that have a row for each of its rows, by the names of their datasets.
constexpr auto kProfileLists = [](auto& lists) {
  lists(
      "value", [](auto& row) -> auto& { return row.profile.value; });
  lists(
      "rise", [](auto& row) -> auto& { return row.profile.rise; });
  lists(
      "searched", [](auto& row) -> auto& { return row.profile.searched; });
};

template <typename Row>
class ListWriter {
 public:
  ListWriter(io::Hdf5Group& group, const std::vector<Row>& rows) : group_(group), rows_(rows) {}

  template <typename List>
  void operator()(const std::string& name, const List& list) {
    io::Ragged<double> all;
    for (const Row& row : rows_) all.push_back(list(row));
    group_.write_ragged(name, all, kPlain);
  }

 private:
  io::Hdf5Group& group_;
  const std::vector<Row>& rows_;
};

template <typename Row>
class ListReader {
 public:
  ListReader(const io::Hdf5Group& group, std::vector<Row>& rows) : group_(group), rows_(rows) {}

  template <typename List>
  void operator()(const std::string& name, const List& list) {
    const auto all = io::read_lists(group_, name, rows_.size(), kIntervalRules);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::span<const double> row = all.row(i);
      list(rows_[i]).assign(row.begin(), row.end());
    }
  }

 private:
  const io::Hdf5Group& group_;
  std::vector<Row>& rows_;
};

/// Whether values are rows of a table of so many columns, or so many rows of any.
bool is_table(const std::vector<double>& values, std::size_t extent) {
  return extent == 0 ? values.empty() : values.size() % extent == 0;
}

template <typename Row, typename Columns>
std::vector<Row> read_rows(const io::Hdf5Group& group, std::size_t fits, const Columns& columns) {
  std::vector<Row> rows(group.read<std::uint64_t>("fit").size());
  ColumnReader<Row> reader(group, pointers_to(std::span(rows)), kIntervalRules, kNewest);
  columns(reader);
  for (const Row& row : rows) {
    if (row.fit >= fits) io::refuse_value(group, "fit", "", "names a fit that is not in the file");
  }
  return rows;
}

template <typename Row, typename Columns>
io::Hdf5Group write_rows(io::Hdf5Group& root, const std::string& path, const std::vector<Row>& rows,
                         const Columns& columns) {
  io::Hdf5Group group = root.group(path);
  ColumnWriter<Row> writer(group, pointers_to(std::span(rows)));
  columns(writer);
  return group;
}

/// A percentile interval as three columns, a list per bootstrap.
void write_bootstrap_lists(io::Hdf5Group& group, const std::vector<BootstrapRow>& rows) {
  io::Ragged<double> values, errors, low, high;
  for (const BootstrapRow& row : rows) {
    values.push_back(row.bootstrap.values);
    std::vector<double> of[3];
    for (const BootstrapInterval& interval : row.bootstrap.intervals) {
      of[0].push_back(interval.standard_error);
      of[1].push_back(interval.low);
      of[2].push_back(interval.high);
    }
    errors.push_back(of[0]);
    low.push_back(of[1]);
    high.push_back(of[2]);
  }
  group.write_ragged("values", values, kPlain);
  group.write_ragged("standard_error", errors, kPlain);
  group.write_ragged("low", low, kPlain);
  group.write_ragged("high", high, kPlain);
}

void read_bootstrap_lists(const io::Hdf5Group& group, std::vector<BootstrapRow>& rows) {
  struct Lists {
    std::vector<double> values, errors, low, high;
  };
  std::vector<Lists> lists(rows.size());
  ListReader<Lists> reader(group, lists);
  reader(
      "values", [](auto& row) -> auto& { return row.values; });
  reader(
      "standard_error", [](auto& row) -> auto& { return row.errors; });
  reader(
      "low", [](auto& row) -> auto& { return row.low; });
  reader(
      "high", [](auto& row) -> auto& { return row.high; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Lists& of = lists[i];
    if (of.errors.size() != of.low.size() || of.low.size() != of.high.size()) {
      io::refuse_value(group, "low", "", "must have as many numbers as high and standard_error");
    }
    for (std::size_t k = 0; k < of.low.size(); ++k) {
      rows[i].bootstrap.intervals.push_back({of.errors[k], of.low[k], of.high[k]});
    }
    rows[i].bootstrap.values = std::move(of.values);
  }
}

}  // namespace

void write_intervals(io::Hdf5Group& root, const std::vector<StoredIntervals>& fits) {
  std::vector<ProfileRow> profiles;
  std::vector<BootstrapRow> bootstraps;
  for (std::uint64_t i = 0; i < fits.size(); ++i) {
    const FitIntervals& all = *fits[i].intervals;
    for (std::size_t k = 0; k < all.profiles.size(); ++k) {
      profiles.push_back({i, fits[i].paths.at(k), all.profiles[k]});
    }
    if (all.residuals.resamples > 0) bootstraps.push_back({i, "residuals", all.residuals});
    if (all.specimens.resamples > 0) bootstraps.push_back({i, "specimens", all.specimens});
  }
  io::Hdf5Group group = write_rows(root, "profiles", profiles, kProfileColumns);
  ListWriter<ProfileRow> lists(group, profiles);
  kProfileLists(lists);
  io::Hdf5Group of_bootstraps = write_rows(root, "bootstraps", bootstraps, kBootstrapColumns);
  write_bootstrap_lists(of_bootstraps, bootstraps);
}

void read_intervals(const io::Hdf5Group& root, const std::vector<FitIntervals*>& fits) {
  const io::Hdf5Group group = root.open_group("profiles");
  auto profiles = read_rows<ProfileRow>(group, fits.size(), kProfileColumns);
  ListReader<ProfileRow> lists(group, profiles);
  kProfileLists(lists);
  for (ProfileRow& row : profiles) {
    const LikelihoodProfile& profile = row.profile;
    if (profile.rise.size() != profile.value.size() ||
        !is_table(profile.searched, profile.value.size())) {
      io::refuse_value(group, "searched", "", "must have a rise and a row for each value");
    }
    fits[row.fit]->profiles.push_back(std::move(row.profile));
  }
  const io::Hdf5Group of_bootstraps = root.open_group("bootstraps");
  auto bootstraps = read_rows<BootstrapRow>(of_bootstraps, fits.size(), kBootstrapColumns);
  read_bootstrap_lists(of_bootstraps, bootstraps);
  for (BootstrapRow& row : bootstraps) {
    FitIntervals& intervals = *fits[row.fit];
    if (row.of != "residuals" && row.of != "specimens") {
      io::refuse_value(of_bootstraps, "of", row.of, "must be residuals or specimens");
    }
    BootstrapResult& own = row.of == "residuals" ? intervals.residuals : intervals.specimens;
    if (own.resamples > 0) io::refuse_value(of_bootstraps, "fit", "", "names a fit twice");
    if (row.bootstrap.failed > row.bootstrap.resamples || row.bootstrap.resamples == 0) {
      io::refuse_value(of_bootstraps, "failed", std::to_string(row.bootstrap.failed),
                       "must be no more than the resamples");
    }
    own = std::move(row.bootstrap);
  }
}

void check_intervals(const io::Hdf5Group& root, const FitIntervals& intervals, std::size_t free) {
  if (!intervals.profiles.empty() && intervals.profiles.size() != free) {
    io::refuse_value(root, "profiles/fit", "", "does not name a fit once a free parameter");
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
