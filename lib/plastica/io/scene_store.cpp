#include "plastica/io/scene_store.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <type_traits>

#include "plastica/io/scene_layout.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/scene_warnings.hpp"

namespace plastica::io {
namespace {

constexpr int kDeflate = 1;
using Shape = std::vector<std::size_t>;

/// The element type of a number in the file.
template <class T>
using Stored = std::conditional_t<
    std::is_floating_point_v<T>, double,
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
                       std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>>;

class Writer {
 public:
  explicit Writer(Hdf5Group& root) : root_(root) {}

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
  template <class Row, class Member>
  void words(std::string_view path, const std::vector<Row>& rows, const Member& member,
             std::span<const std::string_view> words) {
    std::vector<std::string> texts;
    for (const Row& row : rows) texts.emplace_back(words[static_cast<std::size_t>(member(row))]);
    root_.write_texts(path, texts);
  }
  void names(std::string_view path, const std::vector<Probe>& probes) {
    std::vector<std::string> texts;
    for (const Probe& probe : probes) texts.push_back(probe.name);
    root_.write_texts(path, texts);
  }
  template <class Row, class Member>
  void column(std::string_view path, const std::vector<Row>& rows, const Member& member,
              std::string_view units) {
    using Value = Stored<std::remove_cvref_t<decltype(member(rows[0]))>>;
    std::vector<Value> values;
    for (const Row& row : rows) values.push_back(static_cast<Value>(member(row)));
    root_.write(path, values, {units, kDeflate});
  }
  template <class Row, class Member>
  void vectors(std::string_view path, const std::vector<Row>& rows, const Member& member,
               std::string_view units) {
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
  void optional_places(std::string_view path, const std::vector<Load>& loads) {
    std::vector<double> values;
    for (const Load& load : loads) {
      values.push_back(load.to ? load.to->fraction : std::numeric_limits<double>::quiet_NaN());
    }
    root_.write(path, values, {"1"});
  }
  template <class Row>
  void histories(const std::string& path, const std::vector<Row>& rows) {
    Ragged<double> time;
    Ragged<double> factor;
    for (const Row& row : rows) {
      time.push_back(row.history.time);
      factor.push_back(row.history.factor);
    }
    root_.write_ragged(path + "/time", time, {"s"});
    root_.write_ragged(path + "/factor", factor, {"1"});
  }
  void probe_values(const SceneRecord& record) {
    const Scene& scene = record.setup.scene;
    std::vector<std::string> units;
    for (const Probe& probe : scene.probes) {
      units.emplace_back(unit_of(probe.quantity, scene.drive.deformation));
    }
    root_.write_texts("probes/value_units", units);
    std::vector<double> values;
    for (const auto& row : record.response.probes) {
      values.insert(values.end(), row.begin(), row.end());
    }
    const Shape shape{record.response.probes.size(), record.response.samples};
    root_.write_array<double>("probes/values", values, shape, {{}, kDeflate});
  }
  template <class Part, class Walk>
  void part(std::string_view /*path*/, const std::optional<Part>& part, const Walk& walk) {
    if (part) walk(*part);
  }

 private:
  Hdf5Group& root_;
};

class Reader {
 public:
  explicit Reader(const Hdf5Group& root) : root_(root) {}

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

/// Cuts a response off behind its last valid sample.
void keep_valid_samples(Response& response) {
  const std::size_t samples = response.samples;
  for (auto& values : response.probes) values.resize(samples);
  ChainHistory& chain = response.chain;
  if (chain.time.empty()) return;
  chain.time.resize(samples);
  chain.factor.resize(samples);
  chain.energy.resize(samples);
  chain.iterations.resize(samples);
  const std::size_t all = chain.frame_sample.size();
  const auto end = std::lower_bound(chain.frame_sample.begin(), chain.frame_sample.end(), samples);
  const auto frames = static_cast<std::size_t>(end - chain.frame_sample.begin());
  chain.frame_sample.resize(frames);
  for (auto* values :
       {&chain.position, &chain.moment, &chain.force, &chain.angle, &chain.plastic_angle,
        &chain.rotation, &chain.plastic_strain, &chain.stress, &chain.reaction}) {
    values->resize(values->size() / all * frames);
  }
}

}  // namespace

std::span<const std::string_view> scene_layout::statuses() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> all;
    for (int i = 0; i <= static_cast<int>(Status::NotConverged); ++i) {
      all.push_back(name_of(static_cast<Status>(i)));
    }
    return all;
  }();
  return words;
}

std::span<const std::string_view> scene_layout::choices_of(std::string_view field) {
  return find_field_or_null(field)->choices;
}

SceneRecord make_scene_record(const SceneFile& file, const Model& model, Response response) {
  SceneRecord record;
  record.setup = file.setup;
  record.level = model.level;
  record.level_reason = model.level_reason;
  record.warnings = scene_warnings(file.setup.scene, file.setup.solver);
  record.outline = beam_outline(model);
  record.inputs = {{std::filesystem::path(file.path).filename().string(), file.text}};
  keep_valid_samples(response);
  record.response = std::move(response);
  const auto put = [&](Place& place) {
    if (!record.outline.ends.empty()) place = {share_of(place, record.outline.ends), {}};
  };
  Scene& scene = record.setup.scene;
  for (Support& support : scene.supports) {
    put(support.at);
    support.hold = support.held();
  }
  for (Load& load : scene.loads) {
    put(load.at);
    if (load.to) put(*load.to);
  }
  for (Probe& probe : scene.probes) put(probe.at);
  return record;
}

void write_scene_store(const std::string& path, const SceneRecord& record) {
  Hdf5File file = Hdf5File::create(path);
  Hdf5Group& root = file.root();
  write_schema(root, kSceneSchema, kSceneVersion);
  Writer writer(root);
  scene_layout::walk(writer, record);
  Hdf5Group options = root.group("options");
  write_setup(options, record.setup);
  write_inputs(root, record.inputs);
  write_meta(root, record.meta);
  root.write("meta/run_seconds", record.response.seconds, {"s"});
  file.commit();
}

SceneRecord read_scene_store(const std::string& path) {
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  check_schema(root, kSceneSchema, kSceneVersion);
  SceneRecord record;
  read_setup(root.open_group("options"), record.setup);
  Reader reader(root);
  scene_layout::walk(reader, record);
  reader.check_samples(record);
  record.response.chain.joints = record.outline.ends.size();
  record.response.chain.supports = record.setup.scene.supports.size();
  record.inputs = read_inputs(root);
  record.meta = read_meta(root);
  record.response.seconds = root.read_scalar<double>("meta/run_seconds");
  return record;
}

}  // namespace plastica::io
