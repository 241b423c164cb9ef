#include <algorithm>
#include <filesystem>
#include <map>

#include "plastica/io/read_input.hpp"
#include "plastica/io/toml.hpp"
#include "sweeps/check/claim.hpp"
#include "sweeps/compare/comparison.hpp"
#include "sweeps/plan/read_axes.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

std::string sweep_path(const TomlValue& name, const std::string& check_path) {
  const auto path = std::filesystem::path(check_path).parent_path() / name.string();
  if (!io::is_file(path)) {
    throw name.error("is not a file in the folder of " + check_path + io::why_no_file(path));
  }
  return path.lexically_normal().string();
}

/// Fractions are numbers or percents; a value has the quantity's unit.
double read_limit(const TomlValue& value, const Claim& claim, const Sweep* sweep) {
  if (claim.kind == ClaimKind::Value) return value.quantity(sweep->quantity.dimension);
  const bool is_error = claim.kind == ClaimKind::Error ||
                        claim.kind == ClaimKind::ExtrapolatedError || claim.kind == ClaimKind::Gci;
  return is_error || value.is_string() ? value.quantity(Dimension::Strain) : value.number();
}

void read_stability(const TomlTable& scan, Claim& claim) {
  stability::StabilityOptions& options = claim.scan.emplace();
  if (const auto only = scan.find("only")) options.only = only->strings();
  if (const auto sample = scan.find("sample")) {
    options.sample = static_cast<std::size_t>(sample->integer(0, 1'000'000));
  }
  if (const auto seed = scan.find("seed")) {
    options.seed = static_cast<std::uint64_t>(seed->integer(0, 1'000'000'000));
  }
  if (const auto work = scan.find("max_work")) {
    options.max_segment_steps = work->number_within(0.0, 1e9, true);
  }
}

/// @param sweep  null for a claim about a scan
void read_kind(const TomlTable& table, const Sweep* sweep, Claim& claim) {
  std::optional<TomlValue> limits;
  for (std::size_t k = 0; k < kClaimKinds.size(); ++k) {
    const auto found = table.find(kClaimKinds[k]);
    if (!found) continue;
    if (limits) throw found->error("is a second claim: one table makes one");
    limits = found;
    claim.kind = static_cast<ClaimKind>(k);
  }
  if (!limits) {
    std::string all;
    for (const std::string_view word : kClaimKinds) {
      all.append(all.empty() ? "" : ", ").append(word);
    }
    throw InputError(table.where(), table.key(), "", "claims nothing: it needs one of " + all);
  }
  const bool of_scan = claim.kind == ClaimKind::Undetected || claim.kind == ClaimKind::Invalid;
  if (of_scan != (sweep == nullptr)) {
    throw limits->error(of_scan ? "is about stability = { … }, not about a sweep"
                                : "is about a sweep, not about stability");
  }
  const TomlTable range = limits->table();
  if (const auto low = range.find("at_least")) claim.at_least = read_limit(*low, claim, sweep);
  if (const auto high = range.find("at_most")) claim.at_most = read_limit(*high, claim, sweep);
  if (!claim.at_least && !claim.at_most) throw limits->error("needs at_least or at_most");
  if (claim.at_least && claim.at_most && *claim.at_least > *claim.at_most) {
    throw limits->error("at_least must not be above at_most");
  }
  if (of_scan) return;
  const bool of_errors = claim.kind == ClaimKind::Order || claim.kind == ClaimKind::Correlation ||
                         claim.kind == ClaimKind::Error ||
                         claim.kind == ClaimKind::ExtrapolatedError;
  if (of_errors && sweep->against.kind == AgainstKind::Nothing) {
    throw limits->error("needs error.against in the sweep");
  }
  const bool of_sizes = claim.kind == ClaimKind::Order || claim.kind == ClaimKind::Correlation ||
                        claim.kind == ClaimKind::Gci || claim.kind == ClaimKind::ExtrapolatedError;
  if (of_sizes && !sweep->refined) throw limits->error("needs an axis that refines in the sweep");
}

void read_only(const TomlTable& where, const std::string& prefix, const Sweep& sweep,
               Claim& claim) {
  for (const std::string& key : where.keys()) {
    const TomlValue value = where.at(key);
    if (value.is_table()) {
      read_only(value.table(), prefix + key + ".", sweep, claim);
      continue;
    }
    const std::string path = value.new_path(prefix + key);
    const auto axis = std::find_if(sweep.axes.begin(), sweep.axes.end(),
                                   [&](const Axis& a) { return a.field->path == path; });
    if (axis == sweep.axes.end()) throw value.error("is not the field of an axis of the sweep");
    std::vector<FieldValue> wanted;
    for (const TomlValue& one : value.is_array() ? value.array() : std::vector{value}) {
      wanted.push_back(read_field_value(one, *axis->field, sweep.setup));
      if (std::find(axis->values.begin(), axis->values.end(), wanted.back()) ==
          axis->values.end()) {
        throw one.error("is not a value of the axis");
      }
    }
    claim.only.emplace_back(static_cast<std::size_t>(axis - sweep.axes.begin()), std::move(wanted));
  }
}

}  // namespace

CheckFile read_check_file(const std::string& path) {
  const io::TomlDocument document = io::TomlDocument::read(path);
  CheckFile file;
  file.path = path;
  std::map<std::string, std::size_t> known;
  std::map<std::string, int> names;
  for (const TomlTable& table : document.root().find_tables("claim")) {
    Claim claim;
    claim.where = table.where();
    claim.name = table.at("name").string();
    const auto [earlier, is_first] = names.emplace(claim.name, claim.where.line);
    if (!is_first) {
      throw table.at("name").error("is the name of the claim in line " +
                                   std::to_string(earlier->second) + ": each has its own");
    }
    if (const auto scan = table.find_table("stability")) {
      read_stability(*scan, claim);
      read_kind(table, nullptr, claim);
      file.claims.push_back(std::move(claim));
      continue;
    }
    const std::string of = sweep_path(table.at("sweep"), path);
    const auto [place, is_new] = known.emplace(of, file.sweeps.size());
    if (is_new) {
      file.sweeps.push_back(read_sweep_file(of));
      check_reference(file.sweeps.back(), CaseTable(file.sweeps.back()));
    }
    claim.sweep = place->second;
    read_kind(table, &file.sweeps[claim.sweep], claim);
    if (const auto where = table.find_table("where")) {
      read_only(*where, "", file.sweeps[claim.sweep], claim);
    }
    file.claims.push_back(std::move(claim));
  }
  document.root().check_unused();
  for (const Sweep& sweep : file.sweeps) {
    file.notes.insert(file.notes.end(), sweep.notes.begin(), sweep.notes.end());
  }
  const std::vector<std::string>& own = document.root().notes();
  file.notes.insert(file.notes.end(), own.begin(), own.end());
  if (file.claims.empty()) throw InputError({path, 0}, "claim", "", "is missing: nothing to check");
  return file;
}

}  // namespace plastica::sweeps
