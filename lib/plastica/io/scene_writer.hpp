#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "plastica/io/scene_layout.hpp"

namespace plastica::io {

/// Writes what `scene_layout::traverse` meets; not installed.
class SceneWriter {
 public:
  template <class T>
  using Stored = scene_layout::Stored<T>;
  using Shape = scene_layout::Shape;

  explicit SceneWriter(Hdf5Group& root) : root_(root) {}

  void text(std::string_view path, const std::string& text) { root_.write_text(path, text); }
  void texts(std::string_view path, const std::vector<std::string>& texts) {
    root_.write_texts(path, texts);
  }
  template <class Enum>
  void word(std::string_view path, Enum value, std::span<const std::string_view> words) {
    root_.write_text(path, std::string(words[static_cast<std::size_t>(value)]));
  }
  template <class T>
  void number(std::string_view path, T value, std::string_view units) {
    root_.write(path, static_cast<Stored<T>>(value), {units});
  }
  template <class T>
  void number_since(std::string_view path, T value, std::string_view units) {
    number(path, value, units);
  }
  void numbers(std::string_view path, const std::array<double, 3>& values, std::string_view units) {
    root_.write(path, std::span<const double>(values), {units});
  }
  /// @param shape  empty: as many as there are
  template <class T>
  void array(std::string_view path, const std::vector<T>& values, const Shape& shape,
             std::string_view units) {
    const std::vector<Stored<T>> stored(values.begin(), values.end());
    const Shape own{values.size()};
    root_.write_array<Stored<T>>(path, stored, shape.empty() ? own : shape, {units, kDeflate});
  }
  /// Files of before lack it, and those in which it is empty.
  template <class T>
  void array_since(std::string_view path, const std::vector<T>& values, const Shape& shape,
                   std::string_view units) {
    if (!values.empty()) array(path, values, shape, units);
  }
  template <class Row>
  bool has_rows(std::string_view /*path*/, const std::vector<Row>& rows) const {
    return !rows.empty();
  }
  template <class Row, class Member>
  void words(std::string_view path, const std::vector<Row>& rows, const Member& member,
             std::span<const std::string_view> words) {
    std::vector<std::string> texts;
    texts.reserve(rows.size());
    for (const Row& row : rows) texts.emplace_back(words[static_cast<std::size_t>(member(row))]);
    root_.write_texts(path, texts);
  }
  void names(std::string_view path, const std::vector<Probe>& probes) {
    std::vector<std::string> texts;
    texts.reserve(probes.size());
    for (const Probe& probe : probes) texts.push_back(probe.name);
    root_.write_texts(path, texts);
  }
  template <class Row, class Member>
  void column(std::string_view path, const std::vector<Row>& rows, const Member& member,
              std::string_view units, const Range* /*range*/ = nullptr) {
    using Value = Stored<std::remove_cvref_t<decltype(member(rows[0]))>>;
    std::vector<Value> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(static_cast<Value>(member(row)));
    root_.write(path, values, {units, kDeflate});
  }
  template <class Row, class Member>
  void vectors(std::string_view path, const std::vector<Row>& rows, const Member& member,
               std::string_view units, const Range* /*range*/ = nullptr) {
    std::vector<double> values;
    for (const Row& row : rows) {
      values.insert(values.end(), member(row).begin(), member(row).end());
    }
    root_.write_table<double>(path, values, 3, {units});
  }
  void held(std::string_view path, const std::vector<Support>& supports) {
    std::vector<std::uint8_t> values;
    for (const Support& support : supports) {
      for (const bool held : support.held()) values.push_back(held ? 1 : 0);
    }
    root_.write_table<std::uint8_t>(path, values, 6);
  }
  /// The `to` of each row; NaN: none.
  template <class Row>
  void optional_places(std::string_view path, const std::vector<Row>& rows) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) {
      values.push_back(row.to ? row.to->fraction : std::numeric_limits<double>::quiet_NaN());
    }
    root_.write(path, values, {"1"});
  }
  void optional_place(std::string_view path, const std::optional<Place>& place) {
    root_.write(path, place ? place->fraction : std::numeric_limits<double>::quiet_NaN(), {"1"});
  }
  void points(std::string_view path, const std::vector<std::array<double, 3>>& points,
              std::string_view units) {
    std::vector<double> values;
    for (const auto& point : points) values.insert(values.end(), point.begin(), point.end());
    root_.write_table<double>(path, values, 3, {units});
  }
  template <class Row>
  void histories(const std::string& path, const std::vector<Row>& rows) {
    Ragged<double> time;
    Ragged<double> factor;
    Ragged<double> slope;
    std::vector<std::uint8_t> continues;
    for (const Row& row : rows) {
      time.push_back(row.history.time);
      factor.push_back(row.history.factor);
      slope.push_back(row.history.slope);
      continues.push_back(row.history.continues ? 1 : 0);
    }
    root_.write_ragged(path + "/time", time, {"s"});
    root_.write_ragged(path + "/factor", factor, {"1"});
    root_.write_ragged(path + "/slope", slope, {"1/s"});
    root_.write(path + "/continues", continues);
  }
  void slopes(std::string_view path, const History& history) {
    root_.write(path, history.slope, {"1/s"});
  }
  void goes_on(std::string_view path, const History& history) {
    root_.write(path, static_cast<std::uint8_t>(history.continues ? 1 : 0));
  }
  void probe_values(const SceneRecord& record) {
    const Scene& scene = record.setup.scene;
    std::vector<std::string> units;
    for (const Probe& probe : scene.probes) {
      units.emplace_back(si_unit(dimension_of(probe.quantity, scene.drive.deformation)));
    }
    root_.write_texts("probes/value_units", units);
    std::vector<double> values;
    for (const auto& row : record.response.probes) {
      values.insert(values.end(), row.begin(), row.end());
    }
    const Shape shape{record.response.probes.size(), record.response.samples};
    root_.write_array<double>("probes/values", values, shape, {{}, kDeflate});
  }
  template <class Value, class Visit>
  void optional(std::string_view /*path*/, const std::optional<Value>& value, const Visit& visit) {
    if (value) visit(*value);
  }

 private:
  static constexpr int kDeflate = 1;

  Hdf5Group& root_;
};

}  // namespace plastica::io
