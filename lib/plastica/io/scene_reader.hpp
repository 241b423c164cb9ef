#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/renamed.hpp"
#include "plastica/io/scene_layout.hpp"
#include "plastica/io/scene_rules.hpp"

namespace plastica::io {

/// Reads what `scene_layout::traverse` meets, and refuses what does not fit together; not
/// installed.
class SceneReader {
 public:
  template <class T>
  using Stored = scene_layout::Stored<T>;
  using Shape = scene_layout::Shape;

  explicit SceneReader(const Hdf5Group& root) : root_(root) {}

  /// What an older version did not write is left empty.
  void text(std::string_view path, std::string& text) {
    if (root_.exists(path)) text = root_.read_text(path);
  }
  void texts(std::string_view path, std::vector<std::string>& texts) {
    texts = root_.read_texts(path);
  }
  template <class Enum>
  void word(std::string_view path, Enum& value, std::span<const std::string_view> words) {
    value = enumerator<Enum>(path, root_.read_text(path), words);
  }
  template <class T>
  void number(std::string_view path, T& value, std::string_view /*units*/) {
    value = static_cast<T>(values_of<T>(path, {})[0]);
  }
  /// One that files of older versions do not have: it stays as it is.
  template <class T>
  void number_since(std::string_view path, T& value, std::string_view units) {
    if (root_.exists(path)) number(path, value, units);
  }
  void numbers(std::string_view path, std::array<double, 3>& values, std::string_view /*units*/) {
    const auto read = values_of<double>(path, {3});
    std::copy(read.begin(), read.end(), values.begin());
  }
  template <class T>
  void array(std::string_view path, std::vector<T>& values, const Shape& shape,
             std::string_view /*units*/) {
    const auto read = values_of<T>(path, shape.empty() ? kRow : shape);
    values.resize(read.size());
    std::transform(read.begin(), read.end(), values.begin(),
                   [](Stored<T> value) { return static_cast<T>(value); });
  }
  template <class T>
  void array_since(std::string_view path, std::vector<T>& values, const Shape& shape,
                   std::string_view units) {
    if (root_.exists(path)) array(path, values, shape, units);
  }
  /// Whether there is a table that files of older versions do not have, nor those without rows.
  template <class Row>
  bool has_rows(std::string_view path, const std::vector<Row>& /*rows*/) const {
    return root_.exists(path);
  }
  template <class Row, class Member>
  void words(std::string_view path, std::vector<Row>& rows, const Member& member,
             std::span<const std::string_view> words) {
    const std::vector<std::string> texts = root_.read_texts(path);
    resize(path, rows, texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      using Enum = std::remove_cvref_t<decltype(member(rows[0]))>;
      member(rows[i]) = enumerator<Enum>(path, texts[i], words);
    }
  }
  void names(std::string_view path, std::vector<Probe>& probes) {
    probes.clear();
    begun_ = &probes;
    for (std::string& name : root_.read_texts(path)) probes.emplace_back().name = std::move(name);
  }
  template <class Row, class Member>
  void column(std::string_view path, std::vector<Row>& rows, const Member& member,
              std::string_view /*units*/, const Range* range = nullptr) {
    using Value = std::remove_cvref_t<decltype(member(rows[0]))>;
    const auto values = values_of<Value>(path, kRow);
    if constexpr (std::is_same_v<Value, double>) {
      if (range) check_values(root_, path, values, {path, *range});
    }
    resize(path, rows, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) member(rows[i]) = static_cast<Value>(values[i]);
  }
  template <class Row, class Member>
  void vectors(std::string_view path, std::vector<Row>& rows, const Member& member,
               std::string_view /*units*/, const Range* range = nullptr) {
    const auto values = values_of<double>(path, {rows.size(), 3});
    if (range) check_values(root_, path, values, {path, *range});
    for (std::size_t i = 0; i < values.size(); ++i) member(rows[i / 3])[i % 3] = values[i];
  }
  void held(std::string_view path, std::vector<Support>& supports) {
    const auto values = values_of<bool>(path, {supports.size(), 6});
    for (std::size_t i = 0; i < values.size(); ++i) {
      Support& support = supports[i / 6];
      if (!support.hold) support.hold.emplace();
      (*support.hold)[i % 6] = values[i] != 0;
    }
  }
  /// What an older version did not write is at one place.
  template <class Row>
  void optional_places(std::string_view path, std::vector<Row>& rows) {
    if (!root_.exists(path)) return;
    const auto values = values_of<double>(path, {rows.size()});
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(values[i])) rows[i].to = Place{values[i], {}};
    }
  }
  void optional_place(std::string_view path, std::optional<Place>& place) {
    const auto fraction = values_of<double>(path, {})[0];
    if (!std::isnan(fraction)) place = Place{fraction, {}};
  }
  void points(std::string_view path, std::vector<std::array<double, 3>>& points,
              std::string_view /*units*/) {
    const auto values = values_of<double>(path, {Hdf5Group::kAnyExtent, 3});
    points.resize(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) points[i / 3][i % 3] = values[i];
  }
  template <class Row>
  void histories(const std::string& path, std::vector<Row>& rows) {
    const auto time = root_.read_ragged<double>(path + "/time");
    const auto factor = root_.read_ragged<double>(path + "/factor");
    if (time.offsets != factor.offsets || time.rows() != rows.size()) {
      refuse_value(root_, path, "", "does not have a history for each row");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto t = time.row(i);
      const auto f = factor.row(i);
      if (t.empty()) refuse_value(root_, path, "", "must have a time for each row");
      check_values(root_, path + "/time", t, kTimes);
      check_values(root_, path + "/factor", f, {});
      rows[i].history = {{t.begin(), t.end()}, {f.begin(), f.end()}};
    }
    // Files of older versions have straight segments alone.
    if (root_.exists(path + "/slope")) {
      const auto slope = root_.read_ragged<double>(path + "/slope");
      if (slope.rows() != rows.size()) {
        refuse_value(root_, path + "/slope", "", "does not have a history for each row");
      }
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto of_row = slope.row(i);
        set_slopes(path + "/slope", {of_row.begin(), of_row.end()}, rows[i].history);
      }
    }
    const std::string continues = path + "/continues";
    const bool says = root_.exists(continues);
    std::vector<Stored<bool>> values;
    if (says) values = values_of<bool>(continues, {rows.size()});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].history.continues = says ? values[i] != 0 : went_on(rows[i].history);
      check_line(continues, rows[i].history);
    }
  }
  void slopes(std::string_view path, History& history) {
    if (!root_.exists(path)) return;
    const auto values = values_of<double>(path, kRow);
    set_slopes(path, {values.begin(), values.end()}, history);
  }
  void goes_on(std::string_view path, History& history) {
    history.continues = root_.exists(path) ? values_of<bool>(path, {})[0] != 0 : went_on(history);
    check_line(path, history);
  }
  void probe_values(SceneRecord& record) {
    const std::size_t probes = record.setup.scene.probes.size();
    const auto values = values_of<double>("probes/values", {probes, Hdf5Group::kAnyExtent});
    const std::size_t samples = root_.shape("probes/values")[1];
    for (std::size_t p = 0; p < probes; ++p) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(p * samples);
      record.response.probes.emplace_back(row, row + static_cast<std::ptrdiff_t>(samples));
    }
  }
  void check_events(const EventTable& table) const {
    const auto known = [&](const auto& row) {
      return static_cast<std::size_t>(row.event) < table.time.size();
    };
    for (const auto& [path, holds] :
         {std::pair("events/joints/event", std::ranges::all_of(table.joints, known)),
          std::pair("events/fragments/event", std::ranges::all_of(table.fragments, known))}) {
      if (!holds) refuse_value(root_, path, "", "must be the number of an event");
    }
  }
  template <class Value, class Visit>
  void optional(std::string_view path, std::optional<Value>& value, const Visit& visit) {
    if (root_.exists(path)) visit(value.emplace());
  }

 private:
  static inline const Shape kRow{Hdf5Group::kAnyExtent};
  static constexpr ValueRule kTimes{{}, kNotNegative, Order::RisesStrictly};

  /// Whether a history went on after its end when files did not say: one from 0 to 1 in a second.
  static bool went_on(const History& history) {
    const std::vector<double> from_0_to_1{0.0, 1.0};
    return history.time == from_0_to_1 && history.factor == from_0_to_1;
  }

  void set_slopes(std::string_view path, std::vector<double> slope, History& history) const {
    check_values(root_, path, slope, {});
    if (!slope.empty() && (slope.size() != history.time.size() || slope.size() < 2)) {
      refuse_value(root_, path, "", "must have a slope for each time, or none");
    }
    history.slope = std::move(slope);
  }

  void check_line(std::string_view path, const History& history) const {
    if (history.continues && !history.slope.empty()) {
      refuse_value(root_, path, "1", "must be 0 of a history with slopes");
    }
    if (!history.continues || history.time.size() > 1) return;
    refuse_value(root_, path, "1", "needs two times at least, which make the line");
  }

  /// The numbers of a dataset, of a shape and as `kSceneRules` want them.
  template <class T>
  std::vector<Stored<T>> values_of(std::string_view path, const Shape& shape) const {
    auto values = root_.read_array<Stored<T>>(path, shape);
    check_numbers<T>(root_, path, values, rule_of(kSceneRules, path));
    return values;
  }

  template <class Row>
  void resize(std::string_view path, std::vector<Row>& rows, std::size_t size) {
    if (begun_ != &rows) rows.resize(size);
    begun_ = &rows;
    if (rows.size() != size) {
      refuse_value(root_, path, "", "has other rows than the rest of its table");
    }
  }

  template <class Enum>
  Enum enumerator(std::string_view path, const std::string& word,
                  std::span<const std::string_view> words) const {
    const auto found = std::find(words.begin(), words.end(), new_name(kRenamedWords, word));
    if (found == words.end()) refuse_value(root_, path, word, "is not a word of it");
    return static_cast<Enum>(found - words.begin());
  }

  const Hdf5Group& root_;
  const void* begun_ = nullptr;  // the table that was sized by its first column
};

}  // namespace plastica::io
