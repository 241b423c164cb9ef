#include "calibrate/store/stored_options.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "plastica/io/result_file.hpp"

namespace plastica::calibrate::store {
namespace {

/// A parameter as a row of a table.
struct ParameterRow {
  std::string path;
  ParameterRole role = ParameterRole::Free;
  std::optional<double> value;
  std::optional<double> lower;
  std::optional<double> upper;
  ParameterScale scale = ParameterScale::Auto;
  std::string tied_to;
  double factor = 1.0;
  std::string units;
  std::optional<Prior> prior;
};

constexpr auto kParameterColumns = [](auto& columns) {
  columns("path", "", PLASTICA_MEMBER(path));
  columns("role", "", PLASTICA_MEMBER(role));
  columns("value", "", PLASTICA_MEMBER(value));
  columns("lower", "", PLASTICA_MEMBER(lower));
  columns("upper", "", PLASTICA_MEMBER(upper));
  columns("value_units", "", PLASTICA_MEMBER(units));
  columns("scale", "", PLASTICA_MEMBER(scale));
  columns("tied_to", "", PLASTICA_MEMBER(tied_to));
  columns("factor", "1", PLASTICA_MEMBER(factor));
  columns.since(8, [](auto& later) {
    later.optional("has_prior", PLASTICA_MEMBER(prior), [](auto& prior) {
      prior("prior_mean", "", PLASTICA_MEMBER(mean));
      prior("prior_standard_deviation", "", PLASTICA_MEMBER(standard_deviation));
    });
  });
};

void write_parameters(io::Hdf5Group& group, const std::vector<Parameter>& parameters) {
  std::vector<ParameterRow> rows;
  rows.reserve(parameters.size());
  for (const Parameter& p : parameters) {
    rows.push_back({std::string(p.field->path), p.role, p.value, p.lower, p.upper, p.scale,
                    p.tied_to != nullptr ? std::string(p.tied_to->path) : "", p.factor,
                    std::string(si_unit(p.field->dimension)), p.prior});
  }
  ColumnWriter<ParameterRow> columns(group, pointers_to(std::span(std::as_const(rows))));
  kParameterColumns(columns);
}

std::vector<Parameter> read_parameters(const io::Hdf5Group& group, int version) {
  std::vector<ParameterRow> rows(group.read_texts("path").size());
  ColumnReader<ParameterRow> columns(group, pointers_to(std::span(rows)), kFitRules, version);
  kParameterColumns(columns);
  const SourceLocation where{group.file(), 0};
  std::vector<Parameter> parameters;
  for (const ParameterRow& row : rows) {
    Parameter& p = parameters.emplace_back();
    p.field = &find_field(row.path, where);
    p.role = row.role;
    p.value = row.value;
    p.lower = row.lower;
    p.upper = row.upper;
    p.scale = row.scale;
    if (!row.tied_to.empty()) p.tied_to = &find_field(row.tied_to, where);
    p.factor = row.factor;
    p.prior = row.prior;
    p.where = where;
  }
  check_parameters(parameters);
  for (Parameter& p : parameters) p.where = {};  // is not stored
  return parameters;
}

constexpr auto kWeightColumns = [](auto& columns) {
  columns("from", "1", PLASTICA_MEMBER(from));
  columns("weight", "1", PLASTICA_MEMBER(weight));
};

void write_weights(io::Hdf5Group group, const std::vector<WeightStep>& weights) {
  ColumnWriter<WeightStep> columns(group, pointers_to(std::span(weights)));
  kWeightColumns(columns);
}

std::vector<WeightStep> read_weights(const io::Hdf5Group& group) {
  std::vector<WeightStep> weights(group.read<double>("from").size());
  ColumnReader<WeightStep> columns(group, pointers_to(std::span(weights)), kFitRules, kNewest);
  kWeightColumns(columns);
  return weights;
}

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<Parameter> parameters_of(const FitRecord& record, const FitOptions& options) {
  if (options.laws.empty()) return options.parameters;
  const std::vector<Parameter> all = calibrate::parameters_of(options.laws, options.parameters);
  return calibrate::parameters_of(record.result.law, record.target.loading, all,
                                  options.parameters);
}

void write_options(io::Hdf5Group& group, const FitOptions& options) {
  group.write_text("objective", std::string(word_of(options.objective)));
  group.write("noise", options.noise.value_or(kUnset), {"Pa"});
  write_weights(group.group("weights"), options.weights);
  group.write("break_weight", options.break_weight, {"1"});
  group.write("modulus_prior", std::int64_t{options.modulus_prior});
  group.write_text("algorithm", options.algorithm);
  const StoppingRules& stopping = options.stopping;
  group.write("global_evaluations", std::int64_t{stopping.global_evaluations});
  group.write("local_evaluations", std::int64_t{stopping.local_evaluations});
  group.write("parameter_tolerance", stopping.parameter_tolerance, {"1"});
  group.write("cost_tolerance", stopping.cost_tolerance, {"1"});
  std::vector<std::string> laws;
  for (const Law law : options.laws) laws.emplace_back(name_of(law));
  group.write_texts("laws", laws);
  group.write("seed", options.seed);
  group.write("confidence", options.confidence, {"1"});
  const IntervalOptions& intervals = options.intervals;
  group.write("profile", std::int64_t{intervals.profile});
  group.write("bootstrap", std::int64_t{intervals.bootstrap});
  group.write("bootstrap_block", std::int64_t{intervals.block});
  group.write("bootstrap_specimens", std::int64_t{intervals.specimens});
  io::Hdf5Group parameters = group.group("parameters");
  write_parameters(parameters, options.parameters);
  io::write_setup(group, options.setup);
  group.write_texts("stated", options.stated);
}

FitOptions read_options(const io::Hdf5Group& group, int version) {
  FitOptions options;
  options.objective = enumerator_of<Objective>(group, "objective", group.read_text("objective"));
  const auto real = [&](std::string_view name) {
    return io::read_number<double>(group, name, kFitRules);
  };
  const auto count = [&](std::string_view name) {
    return io::read_number<int>(group, name, kFitRules);
  };
  if (const double noise = real("noise"); !std::isnan(noise)) options.noise = noise;
  options.weights = read_weights(group.open_group("weights"));
  options.break_weight = real("break_weight");
  options.modulus_prior = version >= 7 && count("modulus_prior") != 0;
  options.algorithm = group.read_text("algorithm");
  options.stopping = {count("global_evaluations"), count("local_evaluations"),
                      real("parameter_tolerance"), real("cost_tolerance")};
  options.laws = laws_of(group.read_texts("laws"), group.path() + "/laws", {group.file(), 0});
  options.seed = io::read_number<std::uint64_t>(group, "seed", kFitRules);
  options.confidence = real("confidence");
  options.intervals = {count("profile") != 0, count("bootstrap"), count("bootstrap_block"),
                       count("bootstrap_specimens")};
  options.parameters = read_parameters(group.open_group("parameters"), version);
  io::read_setup(group, options.setup);
  if (version >= 10) options.stated = group.read_texts("stated");
  return options;
}

}  // namespace plastica::calibrate::store
