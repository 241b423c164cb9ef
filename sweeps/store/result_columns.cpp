#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "sweeps/store/sweep_layout.hpp"
#include "sweeps/store/sweep_rules.hpp"

namespace plastica::sweeps {
namespace {

using io::Hdf5Group;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::span<const std::string_view> level_words() {
  return find_field_or_null("solver.level")->choices;
}

template <class Enum>
std::span<const std::string_view> words_of() {
  if constexpr (std::is_same_v<Enum, Status>) {
    return io::status_words();
  } else {
    static_assert(std::is_same_v<Enum, Level>);
    return level_words();
  }
}

/// A column of /cases that is written from, or read into, a member of the results.
class Writer {
 public:
  Writer(Hdf5Group& group, const std::vector<CaseResult>& results)
      : group_(group), results_(results) {}

  template <class Member>
  void operator()(const std::string& name, std::string_view units, Member member) {
    using Value = std::remove_cvref_t<decltype(results_[0].*member)>;
    if constexpr (std::is_same_v<Value, std::string> || std::is_enum_v<Value>) {
      std::vector<std::string> texts;
      for (const CaseResult& result : results_) texts.push_back(text(result.*member));
      group_.write_texts(name, texts);
    } else {
      using Stored = std::conditional_t<std::is_integral_v<Value>, std::int64_t, double>;
      std::vector<Stored> values;
      for (const CaseResult& result : results_) values.push_back(number<Stored>(result.*member));
      group_.write(name, values, {units, kDeflate});
    }
  }

 private:
  static std::string text(const std::string& value) { return value; }
  template <class Enum>
  static std::string text(Enum value) {
    return std::string(words_of<Enum>()[static_cast<std::size_t>(value)]);
  }
  template <class Stored, class Value>
  static Stored number(const Value& value) {
    if constexpr (std::is_same_v<Value, std::optional<double>>) {
      return value.value_or(kNone);
    } else {
      return static_cast<Stored>(value);
    }
  }

  Hdf5Group& group_;
  const std::vector<CaseResult>& results_;
};

class Reader {
 public:
  Reader(const Hdf5Group& group, std::vector<CaseResult>& results)
      : group_(group), results_(results) {}

  template <class Member>
  void operator()(const std::string& name, std::string_view /*units*/, Member member) {
    using Value = std::remove_cvref_t<decltype(results_[0].*member)>;
    if constexpr (std::is_same_v<Value, std::string> || std::is_enum_v<Value>) {
      const auto texts = checked(name, group_.read_texts(name));
      for (std::size_t i = 0; i < texts.size(); ++i) set(results_[i].*member, name, texts[i]);
    } else {
      using Stored = std::conditional_t<std::is_integral_v<Value>, std::int64_t, double>;
      const auto values = checked(name, group_.read<Stored>(name));
      using Wanted = std::conditional_t<std::is_integral_v<Value>, Value, double>;
      io::ValueRule rule = io::rule_of(kSweepRules, "cases/" + name);
      if constexpr (std::is_same_v<Value, std::optional<double>>) rule.may_lack = true;
      io::check_numbers<Wanted>(group_, name, values, rule);
      for (std::size_t i = 0; i < values.size(); ++i) set(results_[i].*member, values[i]);
    }
  }

 private:
  template <class Values>
  Values checked(const std::string& name, Values values) const {
    if (values.size() == results_.size()) return values;
    throw InputError({group_.file(), 0}, "/cases/" + name, std::to_string(values.size()) + " rows",
                     "must have " + std::to_string(results_.size()) + ", as there are ids");
  }
  static void set(std::string& value, const std::string&, const std::string& text) { value = text; }
  template <class Enum>
  void set(Enum& value, const std::string& name, const std::string& text) const {
    const auto words = words_of<Enum>();
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] != text) continue;
      value = static_cast<Enum>(i);
      return;
    }
    throw InputError({group_.file(), 0}, "/cases/" + name, text, "is no word of this column");
  }
  static void set(std::optional<double>& value, double number) {
    value.reset();
    if (number == number) value = number;  // NaN: there is none
  }
  template <class Value, class Number>
  static void set(Value& value, Number number) {
    value = static_cast<Value>(number);
  }

  const Hdf5Group& group_;
  std::vector<CaseResult>& results_;
};

/// Which columns there are, said once for both directions.
template <class Columns>
void traverse(Columns& column, const std::string& unit) {
  column("status", "", &CaseResult::status);
  column("reason", "", &CaseResult::reason);
  column("level", "", &CaseResult::level);
  column("value", unit, &CaseResult::value);
  column("standard_error", unit, &CaseResult::standard_error);
  column("last_time", "s", &CaseResult::last_time);
  column("last_value", unit, &CaseResult::last_value);
  column("segments", "1", &CaseResult::segments);
  column("iterations", "1", &CaseResult::iterations);
  column("cutbacks", "1", &CaseResult::cutbacks);
  column("energy_balance_error", "1", &CaseResult::energy_balance_error);
}

/// Those that files before version 3 do not have.
template <class Columns>
void traverse_breaks(Columns& column) {
  column("break_joint", "", &CaseResult::break_joint);
  column("break_place", "1", &CaseResult::break_place);
}

/// The cases that were watched, and the warnings of these: a row each, with the number of its case.
void write_case_warnings(Hdf5Group& cases, const std::vector<CaseResult>& results) {
  std::vector<std::uint64_t> watched;
  std::vector<std::uint64_t> warned;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].warnings) continue;
    watched.push_back(i);
    warned.insert(warned.end(), results[i].warnings->size(), i);
    texts.insert(texts.end(), results[i].warnings->begin(), results[i].warnings->end());
  }
  cases.write("watched", watched, {{}, kDeflate});
  cases.write("warned", warned, {{}, kDeflate});
  cases.write_texts("warning", texts);
}

/// Files of before have none.
void read_case_warnings(const Hdf5Group& cases, std::vector<CaseResult>& results) {
  if (!cases.exists("watched")) return;
  for (const std::uint64_t i : cases.read<std::uint64_t>("watched")) {
    if (i >= results.size()) {
      io::refuse_value(cases, "watched", std::to_string(i), "must be the number of a case");
    }
    results[i].warnings.emplace();
  }
  const auto warned = cases.read<std::uint64_t>("warned");
  std::vector<std::string> texts = cases.read_texts("warning");
  if (texts.size() != warned.size()) {
    io::refuse_value(cases, "warning", std::to_string(texts.size()),
                     "must have as many rows as warned");
  }
  for (std::size_t k = 0; k < warned.size(); ++k) {
    if (warned[k] >= results.size() || !results[warned[k]].warnings) {
      io::refuse_value(cases, "warned", std::to_string(warned[k]),
                       "must be the number of a case that was watched");
    }
    results[warned[k]].warnings->push_back(std::move(texts[k]));
  }
}

std::vector<double> row_of(const io::Ragged<double>& rows, std::size_t i) {
  const auto row = rows.row(i);
  return {row.begin(), row.end()};
}

/// Those of curves; files of version 1 have none.
void read_references(const Hdf5Group& root, SweepRecord& record) {
  record.comparison.reference_curve.resize(record.cases());
  if (!root.exists("curves/reference")) return;
  const auto reference = io::read_lists(root, "curves/reference", record.cases(), kSweepRules);
  for (std::size_t i = 0; i < record.cases(); ++i) {
    std::vector<double> curve = row_of(reference, i);
    if (!curve.empty() && curve.size() != record.results[i].time.size()) {
      io::refuse_value(root, "curves/reference", "", "must have a value for each time, or none");
    }
    record.comparison.reference_curve[i] = std::move(curve);
  }
}

}  // namespace

void write_results(Hdf5Group& root, const SweepRecord& record) {
  Hdf5Group cases = root.group("cases");
  Writer writer(cases, record.results);
  traverse(writer, record.quantity.unit);
  traverse_breaks(writer);
  write_case_warnings(cases, record.results);
  std::vector<std::int64_t> work;
  for (const CaseResult& result : record.results) work.push_back(result.segment_iterations());
  cases.write("segment_iterations", work, {"1", kDeflate});
  if (!record.quantity.is_curve()) return;
  io::Ragged<double> time;
  io::Ragged<double> value;
  io::Ragged<double> reference;
  for (const CaseResult& result : record.results) {
    time.push_back(result.time);
    value.push_back(result.curve);
  }
  root.write_ragged("curves/time", time, {"s", kDeflate});
  root.write_ragged("curves/value", value, {record.quantity.unit, kDeflate});
  for (const std::vector<double>& curve : record.comparison.reference_curve) {
    reference.push_back(curve);
  }
  root.write_ragged("curves/reference", reference, {record.quantity.unit, kDeflate});
}

void read_results(const Hdf5Group& root, SweepRecord& record) {
  record.results.resize(record.cases());
  const Hdf5Group cases = root.open_group("cases");
  Reader reader(cases, record.results);
  traverse(reader, record.quantity.unit);
  if (cases.exists("break_joint")) traverse_breaks(reader);
  read_case_warnings(cases, record.results);
  for (const CaseResult& result : record.results) {
    if (result.segments > 0 && result.iterations > kMaxWork / result.segments) {
      io::refuse_value(cases, "iterations", std::to_string(result.iterations),
                       "must be fewer for so many segments");
    }
  }
  const auto seconds = io::read_numbers<double>(root, "meta/case_seconds", kSweepRules);
  if (seconds.size() != record.cases()) {
    throw InputError({root.file(), 0}, "/meta/case_seconds", std::to_string(seconds.size()),
                     "must have as many rows as there are ids");
  }
  for (std::size_t i = 0; i < seconds.size(); ++i) record.results[i].seconds = seconds[i];
  if (!record.quantity.is_curve()) return;
  const auto time = io::read_lists(root, "curves/time", record.cases(), kSweepRules);
  const auto value = io::read_lists(root, "curves/value", record.cases(), kSweepRules);
  if (time.offsets != value.offsets) {
    io::refuse_value(root, "curves/value", "", "must have a value for each time");
  }
  for (std::size_t i = 0; i < record.cases(); ++i) {
    record.results[i].time = row_of(time, i);
    record.results[i].curve = row_of(value, i);
  }
  read_references(root, record);
}

void write_case_seconds(Hdf5Group& root, const SweepRecord& record) {
  std::vector<double> seconds;
  for (const CaseResult& result : record.results) seconds.push_back(result.seconds);
  root.write("meta/case_seconds", seconds, {"s", kDeflate});
}

}  // namespace plastica::sweeps
