#include "calibrate/store/parameter_tables.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "calibrate/inference/held_out.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/interval_store.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate::store {
namespace {

std::string table_of(const std::string& path) {
  return "parameters/" + std::string(last_part(path));
}

const StoredParameter* find(const std::vector<StoredParameter>& all, const FittedParameter& p) {
  const auto found = std::ranges::find(all, p.path, &StoredParameter::path);
  const bool same = found != all.end() && found->dimension == p.dimension;
  return same ? &*found : nullptr;
}

/// Whether each number below a count is there once.
bool are_all_rows(std::vector<std::int64_t> rows) {
  std::ranges::sort(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] != static_cast<std::int64_t>(i)) return false;
  }
  return true;
}

}  // namespace

std::vector<StoredParameter> parameters_of(std::span<const FitOutcome* const> fits) {
  std::vector<StoredParameter> all;
  for (const FitOutcome* fit : fits) {
    for (const FittedParameter& p : fit->parameters) {
      if (std::ranges::find(all, p.path, &StoredParameter::path) == all.end()) {
        all.push_back({p.path, p.dimension});
      }
    }
  }
  return all;
}

void write_parameters(io::Hdf5Group& root, std::span<const FitOutcome* const> fits,
                      const std::vector<StoredParameter>& all) {
  std::vector<std::string> paths;
  paths.reserve(all.size());
  for (const StoredParameter& parameter : all) paths.push_back(parameter.path);
  for (const FitOutcome* fit : fits) {
    for (const FittedParameter& p : fit->parameters) {
      if (find(all, p) == nullptr) {
        throw std::logic_error("write_parameters: " + p.path + " is not as the file has it");
      }
    }
  }
  root.group("parameters").write_texts("path", paths);
  for (const StoredParameter& parameter : all) {
    std::vector<const FittedParameter*> rows;
    std::vector<std::int64_t> numbers;
    std::vector<std::string> roles;
    for (const FitOutcome* fit : fits) {
      const auto at = std::ranges::find(fit->parameters, parameter.path, &FittedParameter::path);
      const bool there = at != fit->parameters.end();
      rows.push_back(there ? &*at : nullptr);
      numbers.push_back(there ? at - fit->parameters.begin() : -1);
      roles.emplace_back(there ? word_of(at->role) : "");
    }
    const std::string path = table_of(parameter.path);
    io::Hdf5Group table = root.group(path);
    table.write("row", numbers, {{}, kDeflate});
    table.set_attribute("row", "meaning", "which of the fit's parameters it is; -1: none");
    table.write_texts("role", roles);
    table.set_attribute("role", "meaning", "free, fixed or tied; empty: the fit does not have it");
    WrittenRows<FittedParameter>(root, std::move(rows))
        .columns(path, kDescribeParameter, si_unit(parameter.dimension));
    root.set_attribute(path, "path", parameter.path);
  }
}

void read_parameters(const io::Hdf5Group& root, int version, int role_of_each,
                     std::span<FitOutcome* const> fits) {
  const FileToRead file{root, kFitRules, version};
  const std::vector<std::string> paths = root.read_texts("parameters/path");
  std::vector<std::vector<std::int64_t>> rows;
  std::vector<std::vector<std::int64_t>> of_fit(fits.size());
  for (const std::string& path : paths) {
    const std::string table = table_of(path);
    rows.push_back(root.read<std::int64_t>(table + "/row"));
    if (rows.back().size() != fits.size()) file.refuse(table + "/row", "must have one a fit");
    for (std::size_t i = 0; i < fits.size(); ++i) {
      if (rows.back()[i] != -1) of_fit[i].push_back(rows.back()[i]);
    }
  }
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!are_all_rows(of_fit[i])) {
      file.refuse("parameters", "must have each parameter of a fit in a row of its own");
    }
    fits[i]->parameters.resize(of_fit[i].size());
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const Field* field = find_field_or_null(paths[k]);
    if (field == nullptr) io::refuse_value(root, "parameters/path", paths[k], "must be a field");
    const std::string table = table_of(paths[k]);
    const std::vector<std::string> roles =
        version >= role_of_each
            ? root.read_texts(table + "/role")
            : std::vector<std::string>(fits.size(), root.text_attribute(table, "role"));
    if (roles.size() != fits.size()) file.refuse(table + "/role", "must have one a fit");
    std::vector<FittedParameter*> parameters(fits.size(), nullptr);
    for (std::size_t i = 0; i < fits.size(); ++i) {
      if (rows[k][i] == -1) continue;
      parameters[i] = &fits[i]->parameters[static_cast<std::size_t>(rows[k][i])];
      parameters[i]->path = paths[k];
      parameters[i]->dimension = field->dimension;
      parameters[i]->role = enumerator_of<ParameterRole>(root, table + "/role", roles[i]);
    }
    ReadRows<FittedParameter>(file, std::move(parameters)).columns(table, kDescribeParameter);
  }
}

void check_outcome(const io::Hdf5Group& root, const FitOutcome& fit, std::size_t moved) {
  if (!fit.correlation.empty() && fit.correlation.size() != moved * moved) {
    io::refuse_value(root, "correlation", "",
                     "must have a row and a column for each free parameter");
  }
  if (!fit.held_out.empty() && fit.held_out.size() != kParts) {
    io::refuse_value(root, "held_out", "", "must have a number for each part of a fit, or none");
  }
  check_intervals(root, fit);
}

}  // namespace plastica::calibrate::store
