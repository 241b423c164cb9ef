#include "calibrate/store/scene_fit_store.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/scene_fit_rows.hpp"

namespace plastica::calibrate {
namespace {

using store::ColumnWriter;
using store::SceneRows;

constexpr io::DatasetOptions kPlain{{}, store::kDeflate};

[[noreturn]] void refuse(const SceneFitRecord& record, const std::string& why) {
  throw std::logic_error("write_scene_fit_store: " + record.name + " " + why);
}

void check(const SceneFitRecord& record) {
  const std::vector<ScenePartFit>& parts = record.result.parts;
  if (record.weights.size() != record.targets.size()) refuse(record, "has not a weight a target");
  if (!parts.empty() && parts.size() != record.targets.size()) {
    refuse(record, "has not a part a target");
  }
  for (std::size_t p = 0; p < record.targets.size(); ++p) {
    const SceneTarget& target = record.targets[p];
    if (target.ordinate.size() != target.abscissa.size()) {
      refuse(record, "has a curve with more abscissas than ordinates or fewer");
    }
    if (parts.empty()) continue;
    if (parts[p].name != target.name) refuse(record, "has a part of another name than its target");
    if (!parts[p].fitted.empty() && parts[p].fitted.size() != target.abscissa.size()) {
      refuse(record, "has not a fitted ordinate an abscissa");
    }
    if (parts[p].fitted_error.size() != parts[p].fitted.size()) {
      refuse(record, "has not an error a fitted ordinate");
    }
  }
}

/// Pointers to the records, sorted by name and law and checked.
std::vector<const SceneFitRecord*> by_name(const std::vector<SceneFitRecord>& records) {
  std::vector<const SceneFitRecord*> sorted = store::pointers_to(std::span(records));
  const auto name = [](const SceneFitRecord* record) {
    return std::pair<std::string_view, Law>(record->name, record->result.law);
  };
  std::ranges::sort(sorted, std::less<>(), name);
  const auto twice = std::ranges::adjacent_find(sorted, std::equal_to<>(), name);
  if (twice != sorted.end()) refuse(**twice, "is the name of two fits");
  for (const SceneFitRecord* record : sorted) check(*record);
  return sorted;
}

SceneRows rows_of(const std::vector<const SceneFitRecord*>& records) {
  SceneRows rows;
  for (std::uint64_t i = 0; i < records.size(); ++i) {
    const SceneFitRecord& record = *records[i];
    for (std::size_t p = 0; p < record.targets.size(); ++p) {
      store::ScenePartRow& row = rows.parts.emplace_back();
      row.fit = i;
      row.target = record.targets[p];
      row.weight = record.weights[p];
      if (record.result.parts.empty()) continue;
      row.made = record.result.parts[p];
      row.has_curve = !row.made->fitted.empty();
    }
    for (const FittedParameter& parameter : record.result.parameters) {
      rows.parameters.push_back({i, parameter});
    }
    if (record.result.segments) {
      for (const SegmentsError& error : record.result.segments->parameters) {
        rows.segments.push_back({i, error});
      }
    }
    for (const SceneStart& start : record.result.starts) rows.starts.push_back({i, start});
    for (const std::string& text : record.result.warnings) rows.warnings.push_back({i, text});
  }
  return rows;
}

template <typename Row, typename Columns>
io::Hdf5Group write_rows(io::Hdf5Group& root, const std::string& path,
                         std::vector<const Row*> pointers, const Columns& columns) {
  io::Hdf5Group group = root.group(path);
  ColumnWriter<Row> writer(group, std::move(pointers));
  columns(writer);
  return group;
}

template <typename Row, typename Columns>
io::Hdf5Group write_rows(io::Hdf5Group& root, const std::string& path, const std::vector<Row>& rows,
                         const Columns& columns) {
  return write_rows(root, path, store::pointers_to(std::span(rows)), columns);
}

/// A column of units beside columns whose unit differs from row to row, for other readers.
template <typename Row, typename DimensionOf>
void write_units(io::Hdf5Group& group, std::string_view name, const std::vector<Row>& rows,
                 const DimensionOf& dimension_of) {
  std::vector<std::string> units(rows.size());
  std::ranges::transform(rows, units.begin(),
                         [&](const Row& row) { return std::string(si_unit(dimension_of(row))); });
  group.write_texts(name, units);
}

void write_curves(io::Hdf5Group& root, const std::vector<store::ScenePartRow>& parts) {
  std::vector<double> abscissa, ordinate, fitted, error;
  std::vector<std::uint64_t> offsets{0};
  for (const store::ScenePartRow& part : parts) {
    const SceneTarget& target = part.target;
    abscissa.insert(abscissa.end(), target.abscissa.begin(), target.abscissa.end());
    ordinate.insert(ordinate.end(), target.ordinate.begin(), target.ordinate.end());
    if (part.has_curve) {
      fitted.insert(fitted.end(), part.made->fitted.begin(), part.made->fitted.end());
      error.insert(error.end(), part.made->fitted_error.begin(), part.made->fitted_error.end());
    }
    for (std::vector<double>* column : {&fitted, &error}) {
      column->resize(abscissa.size(), std::numeric_limits<double>::quiet_NaN());
    }
    offsets.push_back(abscissa.size());
  }
  io::Hdf5Group group = root.group("curves");
  group.write("abscissa", abscissa, kPlain);
  group.write("ordinate", ordinate, kPlain);
  group.write("fitted", fitted, kPlain);
  group.write("fitted_error", error, kPlain);
  group.write("offsets", offsets, kPlain);
}

void write_tables(io::Hdf5Group& root, const SceneRows& rows) {
  io::Hdf5Group parameters =
      write_rows(root, "parameters", rows.parameters, store::kSceneParameterColumns);
  std::vector<const FittedParameter*> described;
  for (const auto& row : rows.parameters) described.push_back(&row.parameter);
  ColumnWriter<FittedParameter> columns(parameters, std::move(described));
  kDescribeParameter(columns);
  write_units(parameters, "value_units", rows.parameters,
              [](const auto& row) { return row.parameter.dimension; });
  write_rows(root, "segments", rows.segments, store::kSceneSegmentsColumns);
  io::Hdf5Group parts = write_rows(root, "parts", rows.parts, store::kScenePartColumns);
  write_units(parts, "abscissa_units", rows.parts,
              [](const auto& row) { return row.target.abscissa_is; });
  write_units(parts, "ordinate_units", rows.parts,
              [](const auto& row) { return row.target.ordinate_is; });
  write_curves(root, rows.parts);
  io::Hdf5Group starts = write_rows(root, "starts", rows.starts, store::kSceneStartColumns);
  io::Ragged<double> from, to;
  for (const store::SceneStartRow& row : rows.starts) {
    from.push_back(row.start.from);
    to.push_back(row.start.to);
  }
  starts.write_ragged("from", from, kPlain);
  starts.write_ragged("to", to, kPlain);
  write_rows(root, "warnings", rows.warnings, store::kSceneWarningColumns);
}

std::vector<store::StoredIntervals> intervals_of(
    const std::vector<const SceneFitRecord*>& records) {
  std::vector<store::StoredIntervals> all;
  for (const SceneFitRecord* record : records) {
    store::StoredIntervals& one = all.emplace_back();
    one.intervals = &record->result.intervals;
    for (const FittedParameter& p : record->result.parameters) one.paths.push_back(p.path);
  }
  return all;
}

}  // namespace

void write_scene_fit_store(const std::string& path, const SceneFitContents& contents,
                           io::Overwrite overwrite) {
  const std::vector<const SceneFitRecord*> records = by_name(contents.records);
  io::Hdf5File file = io::Hdf5File::create(path, overwrite);
  io::Hdf5Group& root = file.root();
  io::write_schema(root, kSceneFitSchema, kSceneFitVersion);
  io::write_run_id(root, contents.run);
  write_rows(root, "fits", records, store::kSceneFitColumns);
  io::Ragged<double> correlation;
  for (const SceneFitRecord* record : records) correlation.push_back(record->result.correlation);
  root.write_ragged("correlation", correlation, {"1", store::kDeflate});
  write_tables(root, rows_of(records));
  store::write_intervals(root, intervals_of(records));
  root.write("options/confidence", contents.confidence, {"1"});
  io::write_inputs(root, contents.inputs);
  io::write_meta(root, contents.meta);
  std::vector<double> seconds;
  for (const SceneFitRecord* record : records) seconds.push_back(record->seconds);
  root.write("meta/fit_seconds", seconds, {"s"});
  file.commit();
}

}  // namespace plastica::calibrate
