#include "sweeps/store/sweep_store.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/io/hdf5.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/plan/refining.hpp"
#include "sweeps/store/sweep_layout.hpp"
#include "sweeps/store/sweep_rules.hpp"

namespace plastica::sweeps {
namespace {

using io::Hdf5Group;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers_of(const std::vector<std::optional<double>>& values) {
  std::vector<double> numbers;
  numbers.reserve(values.size());
  for (const auto& value : values) numbers.push_back(value.value_or(kNoNumber));
  return numbers;
}

std::vector<std::optional<double>> optionals_of(const std::vector<double>& numbers) {
  std::vector<std::optional<double>> values;
  values.reserve(numbers.size());
  for (const double number : numbers) {
    values.push_back(number == number ? std::optional(number) : std::nullopt);
  }
  return values;
}

/// Values of an axis: numbers, or words; NaN where an optional field is not set.
void write_values(Hdf5Group& group, const std::string& path, const Field& field,
                  const std::vector<FieldValue>& values) {
  if (field.kind == FieldKind::Choice) {
    std::vector<std::string> words;
    words.reserve(values.size());
    for (const FieldValue& value : values) words.push_back(std::get<std::string>(value));
    group.write_texts(path, words);
    return;
  }
  std::vector<double> numbers;
  numbers.reserve(values.size());
  for (const FieldValue& value : values) {
    const auto* number = std::get_if<double>(&value);
    numbers.push_back(number != nullptr ? *number : kNoNumber);
  }
  group.write(path, numbers, {si_unit(field.dimension), kDeflate});
}

void write_axes(Hdf5Group& root, const SweepRecord& record) {
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    const Axis& axis = record.axes[a];
    Hdf5Group group = root.group("axes/" + std::to_string(a));
    group.set_attribute(".", "field", axis.field->path);
    group.set_attribute(".", "moves_with", axis.group);
    if (axis.apart) group.set_attribute(".", "apart", 1);
    write_values(group, "values", *axis.field, axis.values);
    std::vector<FieldValue> of_cases;
    for (std::size_t i = 0; i < record.cases(); ++i) of_cases.push_back(record.at(i, a));
    Hdf5Group cases = root.group("cases/axes");
    write_values(cases, std::string(axis.field->path), *axis.field, of_cases);
  }
}

std::vector<Axis> read_axes(const Hdf5Group& root) {
  std::vector<Axis> axes;
  if (!root.exists("axes")) return axes;
  const Hdf5Group all = root.open_group("axes");
  for (std::size_t a = 0; all.exists(std::to_string(a)); ++a) {
    const Hdf5Group group = all.open_group(std::to_string(a));
    Axis axis;
    axis.field = &find_axis_field(group.text_attribute(".", "field"), {root.file(), 0});
    axis.group = group.text_attribute(".", "moves_with");
    axis.apart = group.has_attribute(".", "apart");
    if (axis.field->kind == FieldKind::Choice) {
      for (std::string& word : group.read_texts("values")) axis.values.emplace_back(word);
    } else {
      for (const double number : io::read_numbers<double>(group, "values", kSweepRules)) {
        axis.values.push_back(number == number ? FieldValue(number) : FieldValue());
      }
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

void write_position(Hdf5Group& root, const SweepRecord& record) {
  if (record.axes.empty()) return;
  const std::vector<std::uint64_t> position(record.position.begin(), record.position.end());
  root.write_table("cases/position", std::span<const std::uint64_t>(position), record.axes.size(),
                   {{}, kDeflate});
}

void read_position(const Hdf5Group& root, SweepRecord& record) {
  if (record.axes.empty()) return;
  const std::array shape{record.cases(), record.axes.size()};
  const auto position = root.read_array<std::uint64_t>("cases/position", shape);
  for (std::size_t k = 0; k < position.size(); ++k) {
    const std::size_t axis = k % record.axes.size();
    if (position[k] >= record.axes[axis].values.size()) {
      throw InputError({root.file(), 0}, "/cases/position", std::to_string(position[k]),
                       "must be below the number of the axis's values");
    }
    record.position.push_back(position[k]);
  }
}

void write_comparison(Hdf5Group& root, const SweepRecord& record) {
  const Comparison& comparison = record.comparison;
  root.write("cases/reference", numbers_of(comparison.reference), {record.quantity.unit, kDeflate});
  root.write("cases/error", numbers_of(comparison.error), {"1", kDeflate});
  root.write_texts("cases/error_reason", comparison.reason);
  root.write_texts("cases/error_lacks", comparison.lacks);
  root.write_texts("cases/coarser_in", comparison.coarser_in);
  root.write("cases/reference_error", numbers_of(comparison.reference_error), {"1", kDeflate});
  root.write_texts("sweep/error_notes", comparison.notes);
  root.write_texts("sweep/warnings", record.warnings);
  io::Ragged<std::uint64_t> cases;
  io::Ragged<double> sizes;
  std::vector<std::string> labels;
  for (const RefinementGroup& group : record.groups) {
    cases.push_back(std::vector<std::uint64_t>(group.cases.begin(), group.cases.end()));
    sizes.push_back(group.size);
    labels.push_back(group.label);
  }
  root.write_texts("groups/label", labels);
  root.write_ragged("groups/cases", cases, {{}, kDeflate});
  root.write_ragged("groups/size", sizes, {{}, kDeflate});
}

/// Older files took the finest, or the extrapolated, of the refined axis alone.
void find_what_errors_lack(SweepRecord& record) {
  Comparison& comparison = record.comparison;
  comparison.lacks.resize(record.cases());
  comparison.coarser_in.resize(record.cases());
  comparison.reference_error.resize(record.cases());
  if (!record.refined || (record.against != "finest" && record.against != "richardson")) return;
  const std::string& group = record.axes[*record.refined].group;
  std::string others;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    const Axis& axis = record.axes[a];
    const bool along = a == *record.refined || (!group.empty() && axis.group == group);
    if (along || axis.values.size() < 2 || role_of(*axis.field) != AxisRole::Number) continue;
    others += (others.empty() ? "" : ", ") + std::string(axis.field->path);
  }
  if (others.empty()) return;
  comparison.lacks.assign(record.cases(), others);
  comparison.notes.push_back(error_alone(record.axes[*record.refined].field->path, others) +
                             ": the file is of an older version; run the sweep again");
}

void read_what_errors_lack(const Hdf5Group& root, SweepRecord& record) {
  Comparison& comparison = record.comparison;
  comparison.lacks = root.read_texts("cases/error_lacks");
  comparison.coarser_in = root.read_texts("cases/coarser_in");
  comparison.reference_error =
      optionals_of(io::read_numbers<double>(root, "cases/reference_error", kSweepRules));
  comparison.notes = root.read_texts("sweep/error_notes");
  const std::size_t n = record.cases();
  if (comparison.lacks.size() != n || comparison.coarser_in.size() != n ||
      comparison.reference_error.size() != n) {
    throw InputError({root.file(), 0}, "/cases/error_lacks", "",
                     "does not go with the number of cases");
  }
  const bool lacking = std::any_of(comparison.lacks.begin(), comparison.lacks.end(),
                                   [](const std::string& lacks) { return !lacks.empty(); });
  if (lacking && !record.refined) {
    throw InputError({root.file(), 0}, "/cases/error_lacks", "",
                     "does not go without an axis that refines");
  }
}

void read_comparison(const Hdf5Group& root, SweepRecord& record) {
  Comparison& comparison = record.comparison;
  comparison.reference =
      optionals_of(io::read_numbers<double>(root, "cases/reference", kSweepRules));
  comparison.error = optionals_of(io::read_numbers<double>(root, "cases/error", kSweepRules));
  comparison.reason = root.read_texts("cases/error_reason");
  const auto cases = root.read_ragged<std::uint64_t>("groups/cases");
  const auto sizes = io::read_lists(root, "groups/size", cases.rows(), kSweepRules);
  const auto labels = root.read_texts("groups/label");
  const auto refuse = [&](const std::string& what) {
    throw InputError({root.file(), 0}, what, "", "does not go with the number of cases");
  };
  if (comparison.reference.size() != record.cases() || comparison.error.size() != record.cases() ||
      comparison.reason.size() != record.cases()) {
    refuse("/cases/error");
  }
  if (sizes.offsets != cases.offsets || labels.size() != cases.rows()) refuse("/groups");
  for (std::size_t g = 0; g < cases.rows(); ++g) {
    RefinementGroup group{labels[g], {}, {}};
    if (cases.row(g).empty()) refuse("/groups/cases");
    for (const std::uint64_t index : cases.row(g)) {
      if (index >= record.cases()) refuse("/groups/cases");
      group.cases.push_back(index);
    }
    group.size.assign(sizes.row(g).begin(), sizes.row(g).end());
    record.groups.push_back(std::move(group));
  }
}

void write_head(Hdf5Group& root, const SweepRecord& record) {
  const Quantity& quantity = record.quantity;
  Hdf5Group head = root.group("sweep");
  head.set_attribute(".", "name", record.name);
  head.set_attribute(".", "scene", record.scene_name);
  head.set_attribute(".", "quantity_kind", word_at(kQuantityKinds, quantity.kind));
  head.set_attribute(".", "probe", static_cast<std::int64_t>(quantity.probe));
  head.set_attribute(".", "take", word_at(kTakes, quantity.take));
  head.set_attribute(".", "mode", quantity.mode);
  head.set_attribute(".", "parameter", quantity.parameter);
  head.set_attribute(".", "quantity", quantity.name);
  head.set_attribute(".", "unit", quantity.unit);
  head.set_attribute(".", "dimension", name_of(quantity.dimension));
  head.set_attribute(".", "against", record.against);
  head.set_attribute(".", "timed_runs", record.timed_runs);
  if (record.error_scale) head.set_attribute(".", "error_scale", *record.error_scale);
  if (record.refined) {
    head.set_attribute(".", "refined_axis", static_cast<std::int64_t>(*record.refined));
  }
}

Dimension dimension_of(const std::string& name, const std::string& file) {
  for (int k = 0; k <= static_cast<int>(kLastDimension); ++k) {
    if (name_of(static_cast<Dimension>(k)) == name) return static_cast<Dimension>(k);
  }
  throw InputError({file, 0}, "/sweep/dimension", name, "is no word of this file");
}

void read_head(const Hdf5Group& root, SweepRecord& record) {
  const Hdf5Group head = root.open_group("sweep");
  Quantity& quantity = record.quantity;
  record.name = head.text_attribute(".", "name");
  record.scene_name = head.text_attribute(".", "scene");
  const auto word = [&](const std::string& name) { return head.text_attribute(".", name); };
  const auto number = [&](const std::string& name) {
    const std::int64_t value = head.integer_attribute(".", name);
    if (value >= 0 && value <= std::numeric_limits<int>::max()) return static_cast<int>(value);
    throw InputError({root.file(), 0}, "/sweep/" + name, std::to_string(value),
                     "must be a number from 0 on");
  };
  quantity.kind = enumerator_at<QuantityKind>(kQuantityKinds, word("quantity_kind"), root.file());
  quantity.take = enumerator_at<Take>(kTakes, word("take"), root.file());
  quantity.probe = static_cast<std::size_t>(number("probe"));
  quantity.mode = number("mode");
  quantity.parameter = word("parameter");
  quantity.name = word("quantity");
  quantity.unit = word("unit");
  quantity.dimension = dimension_of(word("dimension"), root.file());
  record.against = word("against");
  record.timed_runs = number("timed_runs");
  if (head.has_attribute(".", "error_scale")) {
    record.error_scale = head.real_attribute(".", "error_scale");
    if (!(*record.error_scale > 0.0) || std::isinf(*record.error_scale)) {
      throw InputError({root.file(), 0}, "/sweep/error_scale",
                       model_detail::number_text(*record.error_scale), "must be above 0");
    }
  }
  if (head.has_attribute(".", "refined_axis")) {
    record.refined = static_cast<std::size_t>(number("refined_axis"));
  }
}

}  // namespace

void write_sweep_store(const std::string& path, const SweepRecord& record,
                       io::Overwrite overwrite) {
  io::Hdf5File file = io::Hdf5File::create(path, overwrite, record.meta.threads);
  Hdf5Group& root = file.root();
  io::write_schema(root, kSweepSchema, kSweepVersion);
  write_head(root, record);
  root.write_texts(kCaseIds, record.ids);
  write_axes(root, record);
  write_position(root, record);
  write_results(root, record);
  write_comparison(root, record);
  io::write_inputs(root, record.inputs);
  io::write_meta(root, record.meta);
  write_case_seconds(root, record);
  file.commit();
}

namespace {

/// @param version  is set to the file's
SweepRecord read_store(const std::string& path, int& version) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  version = io::check_schema(root, kSweepSchema, kOldestSweepVersion, kSweepVersion);
  SweepRecord record;
  read_head(root, record);
  record.ids = root.read_texts(kCaseIds);
  record.axes = read_axes(root);
  if (record.refined && *record.refined >= record.axes.size()) {
    throw InputError({path, 0}, "/sweep/refined_axis", std::to_string(*record.refined),
                     "must be the number of an axis");
  }
  read_position(root, record);
  read_results(root, record);
  read_comparison(root, record);
  if (version < 3) {
    find_what_errors_lack(record);
  } else {
    read_what_errors_lack(root, record);
  }
  if (root.exists("sweep/warnings")) record.warnings = root.read_texts("sweep/warnings");
  record.inputs = io::read_inputs(root);
  record.meta = io::read_meta(root);
  return record;
}

}  // namespace

SweepRecord read_sweep_store(const std::string& path) {
  int version = 0;
  return read_store(path, version);
}

EarlierResults earlier_results(const std::string& path) {
  int version = 0;
  SweepRecord record = read_store(path, version);
  EarlierResults earlier;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    // Older files do not say which joint broke.
    if (version < 3 && record.results[i].status == Status::Broken) continue;
    earlier.insert_or_assign(std::move(record.ids[i]), std::move(record.results[i]));
  }
  return earlier;
}

}  // namespace plastica::sweeps
