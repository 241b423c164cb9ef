#include "sweeps/plan/read_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "plastica/model/check_value.hpp"
#include "plastica/model/region.hpp"
#include "plastica/theory/sampling.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/plan/kind_axes.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

constexpr std::array<std::string_view, 2> kSpacings{"linear", "logarithmic"};
/// The group of axes that are sampled; no `zip` can have its name, for it is no word.
constexpr std::string_view kSampled = " sampled";

/// Ends of a range of numbers.
struct Span {
  double from = 0.0;
  double to = 0.0;
};

/// A value in the middle of a range: rounded for a field of integers.
double between(const Span& span, bool logarithmic, double fraction, const Field& field) {
  double value = logarithmic ? span.from * std::pow(span.to / span.from, fraction)
                             : span.from + (span.to - span.from) * fraction;
  if (fraction == 1.0) value = span.to;
  return field.kind == FieldKind::Integer ? std::round(value) : value;
}

/// A value that a sample draws. Of a field of integers each has the part of the axis that lies half
/// a step to either side of it, ends included: a range that stops at its ends would give these half
/// of that. On a linear axis all are equally likely.
/// @param fraction  coordinate of the sample in [0, 1)
double drawn(const Span& span, bool logarithmic, double fraction, const Field& field) {
  if (field.kind != FieldKind::Integer) return between(span, logarithmic, fraction, field);
  const double low = std::min(span.from, span.to);
  const double high = std::max(span.from, span.to);
  const double u = span.from < span.to ? fraction : 1.0 - fraction;
  // Integers on a logarithmic axis are 1 at least, so that its lower end stays above 0.
  const double value = logarithmic
                           ? std::round((low - 0.5) * std::pow((high + 0.5) / (low - 0.5), u))
                           : std::floor(low + (high - low + 1.0) * u);
  return std::clamp(value, low, high);
}

double read_number(const TomlValue& value, const Field& field, const Setup& base) {
  const FieldValue read = read_field_value(value, field, base);
  if (const double* number = std::get_if<double>(&read)) return *number;
  throw value.error("must be a number");
}

Span read_span(const TomlValue& from, const TomlValue& to, bool logarithmic, const Field& field,
               const Setup& base) {
  if (field.kind == FieldKind::Choice) throw from.error("needs a field of numbers: list its words");
  const Span span{read_number(from, field, base), read_number(to, field, base)};
  if (span.from == span.to) throw to.error("must differ from the other end");
  if (logarithmic && (span.from <= 0.0 || span.to <= 0.0)) {
    throw(span.from <= 0.0 ? from : to).error("must be above 0 on a logarithmic axis");
  }
  return span;
}

/// @param repeats  whether a value may be there more than once
std::vector<FieldValue> read_list(const TomlValue& list, const Field& field, const Setup& base,
                                  bool repeats) {
  std::vector<FieldValue> values;
  for (const TomlValue& item : list.array()) {
    const FieldValue value = read_field_value(item, field, base);
    if (!repeats && std::find(values.begin(), values.end(), value) != values.end()) {
      throw item.error("is there twice");
    }
    values.push_back(value);
  }
  if (values.empty()) throw list.error("must not be empty");
  return values;
}

std::vector<FieldValue> read_range(const TomlValue& range, bool logarithmic, const Field& field,
                                   const Setup& base) {
  const TomlTable table = range.table();
  const Span span = read_span(table.at("from"), table.at("to"), logarithmic, field, base);
  const auto count = table.at("count").integer(2, 1'000'000);
  std::vector<FieldValue> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(count - 1);
    const FieldValue value = between(span, logarithmic, fraction, field);
    if (values.empty() || values.back() != value) values.push_back(value);  // integers repeat
  }
  return values;
}

/// An axis whose values a sample draws.
struct SampledAxis {
  std::size_t axis = 0;
  Span span;
  bool logarithmic = false;
};

std::optional<SampledAxis> read_sampled(const TomlTable& table, const Field& field,
                                        const Setup& base) {
  const auto ends = table.find("sampled");
  const auto spacing = table.find("spacing");
  if (!ends) {
    if (spacing) throw spacing->error("goes with sampled = [from, to]");
    return std::nullopt;
  }
  const auto pair = ends->array();
  if (pair.size() != 2) throw ends->error("must be two values, [from, to]");
  const bool logarithmic = spacing && spacing->word(kSpacings) == 1;
  return SampledAxis{0, read_span(pair[0], pair[1], logarithmic, field, base), logarithmic};
}

std::vector<FieldValue> read_values(const TomlTable& table, const Field& field, const Setup& base) {
  const auto list = table.find("values");
  const auto linear = table.find("linear");
  const auto logarithmic = table.find("logarithmic");
  const int given = (list ? 1 : 0) + (linear ? 1 : 0) + (logarithmic ? 1 : 0) +
                    (table.contains("sampled") ? 1 : 0);
  if (given != 1) {
    throw InputError(table.where(), table.key(), "",
                     "needs one of values, linear, logarithmic and sampled");
  }
  if (list) return read_list(*list, field, base, table.contains("zip"));
  if (linear) return read_range(*linear, false, field, base);
  if (logarithmic) return read_range(*logarithmic, true, field, base);
  return {};
}

void draw_samples(const TomlTable& root, const std::vector<SampledAxis>& sampled,
                  std::vector<Axis>& axes) {
  const auto table = root.find_table("sample");
  if (sampled.empty()) {
    if (table) throw InputError(table->where(), "sample", "", "needs an axis with sampled");
    return;
  }
  if (!table) {
    throw InputError({root.where().file, 0}, "sample", "",
                     "is missing: an axis has sampled; it takes method, count and seed");
  }
  constexpr std::array<std::string_view, 2> kMethods{"latin_hypercube", "sobol"};
  const std::size_t method = table->at("method").word(kMethods);
  const auto count = static_cast<std::size_t>(table->at("count").integer(1, 10'000'000));
  const auto seed_value = table->find("seed");
  const auto seed = static_cast<std::uint64_t>(
      seed_value ? seed_value->integer(0, std::numeric_limits<std::int64_t>::max()) : 1);
  if (method == 1 && sampled.size() > theory::kSobolDimensions) {
    throw table->at("method").error("takes at most " + std::to_string(theory::kSobolDimensions) +
                                    " sampled axes");
  }
  const std::vector<double> points = method == 0
                                         ? theory::latin_hypercube(count, sampled.size(), seed)
                                         : theory::sobol(count, sampled.size(), seed);
  for (std::size_t d = 0; d < sampled.size(); ++d) {
    Axis& axis = axes[sampled[d].axis];
    for (std::size_t i = 0; i < count; ++i) {
      axis.values.emplace_back(drawn(sampled[d].span, sampled[d].logarithmic,
                                     points[i * sampled.size() + d], *axis.field));
    }
  }
}

/// No number is set by two fields, be it in [set] or by axes.
/// @param settings  how many axes are those of [set]
void check_numbers(const std::vector<Axis>& axes, std::size_t settings) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!set_one_number(*axes[a].field, *axes[b].field)) continue;
      throw InputError(axes[a].where, std::string(axes[a].field->path), "",
                       "sets the same number as " + std::string(axes[b].field->path) +
                           ", which has " + (b < settings ? "a value in [set]" : "an axis"));
    }
  }
}

/// Axes that move together have the same number of values, and no field has two axes.
/// @param axes  those of [set], then one of each table
void check_groups(const std::vector<TomlTable>& tables, const std::vector<Axis>& axes) {
  std::size_t cases = 1;
  std::set<std::string> seen;
  const std::size_t settings = axes.size() - tables.size();
  for (std::size_t a = settings; a < axes.size(); ++a) {
    const TomlTable& table = tables[a - settings];
    for (std::size_t b = 0; b < a; ++b) {
      if (axes[a].field == axes[b].field) {
        throw table.at("field").error(b < settings ? "is fixed by [set]" : "has an axis already");
      }
      if (axes[a].group.empty() || axes[a].group != axes[b].group) continue;
      if (axes[a].values.size() != axes[b].values.size()) {
        throw table.at("zip").error("moves axes together that have " +
                                    std::to_string(axes[b].values.size()) + " and " +
                                    std::to_string(axes[a].values.size()) + " values");
      }
    }
    const bool turns = axes[a].group.empty() || seen.insert(axes[a].group).second;
    if (turns) cases *= axes[a].values.size();
    if (cases > kMaxCases) {
      throw InputError(table.where(), "axis", "",
                       "makes more than " + std::to_string(kMaxCases) + " cases");
    }
  }
}

}  // namespace

FieldValue read_field_value(const TomlValue& value, const Field& field, const Setup& base) {
  Setup scratch = base;
  const bool unset = value.is_string() && value.string() == "unset";
  const bool optional = std::holds_alternative<std::monostate>(field.get(Setup{}));
  if (unset && optional) return std::monostate{};
  FieldValue read;
  std::string shown = value.written();
  if (field.kind == FieldKind::Choice) {
    read = value.string();
    shown = value.string();
  } else {
    read = field.kind == FieldKind::Integer || field.dimension == Dimension::None
               ? value.number()
               : value.quantity(field.dimension);
    if (value.is_string()) shown = value.string();
  }
  try {
    set_field(scratch, field, read, value.where(), shown);
  } catch (const InputError& error) {
    throw InputError(value.where(), value.key(), shown, error.rule());
  }
  return read;
}

void read_axes(const TomlTable& root, Sweep& sweep) {
  const std::vector<TomlTable> tables = root.find_tables("axis");
  std::vector<Axis>& axes = sweep.axes;
  std::vector<SampledAxis> sampled;
  for (const TomlTable& table : tables) {
    const TomlValue name = table.at("field");
    Axis axis{.where = name.where()};
    try {
      axis.field = &find_axis_field(name.new_path(name.string()), name.where());
    } catch (const InputError& error) {
      throw name.error(error.rule());
    }
    axis.values = read_values(table, *axis.field, sweep.setup);
    const auto zip = table.find("zip");
    if (zip) axis.group = zip->string();
    if (auto drawn = read_sampled(table, *axis.field, sweep.setup)) {
      if (zip) throw zip->error("does not go with sampled: all sampled axes move together");
      drawn->axis = axes.size();
      axis.group = kSampled;
      axis.sampled = true;
      sampled.push_back(*drawn);
    }
    axes.push_back(std::move(axis));
  }
  draw_samples(root, sampled, axes);
  check_numbers(axes, axes.size() - tables.size());
  check_groups(tables, axes);
}

void apply(Setup& setup, const std::vector<const Field*>& fields,
           const std::vector<FieldValue>& values) {
  const auto rank = [](const Field& field) {
    if (field.path == "material.name") return 0;
    if (field.path == "beam.segment_depth") return 3;  // the length must stand
    return find_field_or_null(field.path) == nullptr ? 2 : 1;
  };
  for (int turn = 0; turn < 4; ++turn) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (rank(*fields[i]) != turn) continue;
      fields[i]->set(setup, values[i]);
      // With other dimensions it is no more the profile that has a name.
      if (is_section_dimension(*fields[i])) setup.scene.section.name.clear();
    }
  }
  follow_beam(setup.scene);
}

}  // namespace plastica::sweeps
