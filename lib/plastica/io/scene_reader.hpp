#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/io/scene_layout.hpp"

namespace plastica::io {

/// Reads what `scene_layout::walk` meets, and refuses what does not fit together; not installed.
class SceneReader {
 public:
  template <class T>
  using Stored = scene_layout::Stored<T>;
  using Shape = scene_layout::Shape;

  explicit SceneReader(const Hdf5Group& root) : root_(root) {}

  void text(std::string_view path, std::string& text) { text = root_.read_text(path); }
  void texts(std::string_view path, std::vector<std::string>& texts) {
    texts = root_.read_texts(path);
  }
  template <class Enum>
  void word(std::string_view path, Enum& value, std::span<const std::string_view> words) {
    value = enumerator<Enum>(path, root_.read_text(path), words);
  }
  template <class T>
  void number(std::string_view path, T& value, std::string_view /*units*/) {
    value = static_cast<T>(root_.read_scalar<Stored<T>>(path));
  }
  void numbers(std::string_view path, std::array<double, 3>& values, std::string_view /*units*/) {
    const auto read = checked<double>(path, {3});
    std::copy(read.begin(), read.end(), values.begin());
  }
  template <class T>
  void array(std::string_view path, std::vector<T>& values, const Shape& shape,
             std::string_view /*units*/) {
    const auto read = shape.empty() ? root_.read<Stored<T>>(path) : checked<Stored<T>>(path, shape);
    values.resize(read.size());
    std::transform(read.begin(), read.end(), values.begin(),
                   [](Stored<T> value) { return static_cast<T>(value); });
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
    for (std::string& name : root_.read_texts(path)) probes.emplace_back().name = std::move(name);
  }
  template <class Row, class Member>
  void column(std::string_view path, std::vector<Row>& rows, const Member& member,
              std::string_view /*units*/) {
    using Value = std::remove_cvref_t<decltype(member(rows[0]))>;
    const auto values = root_.read<Stored<Value>>(path);
    resize(path, rows, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) member(rows[i]) = static_cast<Value>(values[i]);
  }
  template <class Row, class Member>
  void vectors(std::string_view path, std::vector<Row>& rows, const Member& member,
               std::string_view /*units*/) {
    const auto values = checked<double>(path, {rows.size(), 3});
    for (std::size_t i = 0; i < values.size(); ++i) member(rows[i / 3])[i % 3] = values[i];
  }
  void held(std::string_view path, std::vector<Support>& supports) {
    const auto values = checked<std::uint8_t>(path, {supports.size(), 6});
    for (std::size_t i = 0; i < values.size(); ++i) {
      Support& support = supports[i / 6];
      if (!support.hold) support.hold.emplace();
      (*support.hold)[i % 6] = values[i] != 0;
    }
  }
  void optional_places(std::string_view path, std::vector<Load>& loads) {
    const auto values = checked<double>(path, {loads.size()});
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(values[i])) loads[i].to = Place{values[i], {}};
    }
  }
  void optional_place(std::string_view path, std::optional<Place>& place) {
    const auto share = root_.read_scalar<double>(path);
    if (!std::isnan(share)) place = Place{share, {}};
  }
  void points(std::string_view path, std::vector<std::array<double, 3>>& points,
              std::string_view /*units*/) {
    const auto values = root_.read<double>(path);
    points.resize(values.size() / 3);
    for (std::size_t i = 0; i < 3 * points.size(); ++i) points[i / 3][i % 3] = values[i];
  }
  template <class Row>
  void histories(const std::string& path, std::vector<Row>& rows) {
    const auto time = root_.read_ragged<double>(path + "/time");
    const auto factor = root_.read_ragged<double>(path + "/factor");
    if (time.offsets != factor.offsets || time.rows() != rows.size()) {
      refuse(path, "does not have a history for each row");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto t = time.row(i);
      const auto f = factor.row(i);
      rows[i].history = {{t.begin(), t.end()}, {f.begin(), f.end()}};
    }
  }
  void probe_values(SceneRecord& record) {
    const std::size_t probes = record.setup.scene.probes.size();
    const Shape shape = root_.shape("probes/values");
    if (shape.size() != 2 || shape[0] != probes) {
      refuse("probes/values", "does not have a row for each probe");
    }
    const auto values = root_.read<double>("probes/values");
    for (std::size_t p = 0; p < probes; ++p) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(p * shape[1]);
      record.response.probes.emplace_back(row, row + static_cast<std::ptrdiff_t>(shape[1]));
    }
    samples_of_probes_ = shape[1];
  }
  template <class Part, class Walk>
  void part(std::string_view path, std::optional<Part>& part, const Walk& walk) {
    if (root_.exists(path)) walk(part.emplace());
  }

  /// Whether every part has the samples that the file says.
  void check_samples(const SceneRecord& record) const {
    const std::size_t samples = record.response.samples;
    const bool chain = !record.outline.ends.empty();
    if (samples_of_probes_ != samples || (chain && record.response.chain.time.size() != samples)) {
      refuse("outcome/samples", "is not the number of samples of the file");
    }
    if (chain && record.response.chain.energy.size() != samples) {
      refuse("energy", "does not have a row for each sample");
    }
    const auto& frames = record.response.chain.frame_sample;
    const auto falls = std::adjacent_find(frames.begin(), frames.end(), std::greater_equal<>());
    if (falls != frames.end() || (!frames.empty() && frames.back() >= samples)) {
      refuse("path/frame_sample", "must rise and be samples of the file");
    }
  }
  /// Whether every joint and piece of an event is one of the beam.
  void check_events(const SceneRecord& record) const {
    const auto segments = static_cast<int>(record.outline.segments());
    const auto within = [](int value, int first, int last) {
      return value >= first && value <= last;
    };
    for (const ChainBreak& event : record.response.chain.events) {
      for (const BrokenJoint& joint : event.joints) {
        if (!within(joint.joint, 0, segments)) {
          refuse("events/joints/joint", "must be a joint of the beam");
        }
      }
      for (const Piece& piece : event.pieces) {
        if (!within(piece.first, 0, segments - 1) ||
            !within(piece.last, piece.first, segments - 1)) {
          refuse("events/pieces", "must be ranges of the beam's segments");
        }
      }
    }
  }

 private:
  [[noreturn]] void refuse(std::string_view path, const std::string& rule) const {
    throw InputError({root_.file(), 0}, "/" + std::string(path), "", rule);
  }

  template <class T>
  std::vector<T> checked(std::string_view path, const Shape& shape) const {
    if (root_.shape(path) != shape) refuse(path, "does not have the shape of its table");
    return root_.read<T>(path);
  }

  template <class Row>
  void resize(std::string_view path, std::vector<Row>& rows, std::size_t size) const {
    if (rows.empty()) rows.resize(size);
    if (rows.size() != size) refuse(path, "has other rows than the rest of its table");
  }

  template <class Enum>
  Enum enumerator(std::string_view path, const std::string& word,
                  std::span<const std::string_view> words) const {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
      throw InputError({root_.file(), 0}, "/" + std::string(path), word, "is not a word of it");
    }
    return static_cast<Enum>(found - words.begin());
  }

  const Hdf5Group& root_;
  std::size_t samples_of_probes_ = 0;
};

}  // namespace plastica::io
