#include "plastica/io/scene_store.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "plastica/io/region_store.hpp"
#include "plastica/io/scene_layout.hpp"
#include "plastica/io/scene_reader.hpp"
#include "plastica/io/scene_rules.hpp"
#include "plastica/io/scene_writer.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/run/chain_shape.hpp"
#include "plastica/run/run_warnings.hpp"

namespace plastica::io {

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
  for (const ShapeValue& value : kShapeValues) {
    std::vector<double>& numbers = chain.*value.values;
    numbers.resize(numbers.size() / all * frames);
  }
}

std::span<const std::string_view> scene_layout::choices_of(std::string_view field) {
  return find_field_or_null(field)->choices;
}

SceneRecord make_scene_record(const SceneFile& file, const Model& model, Response response) {
  SceneRecord record;
  record.setup = file.setup;
  record.level = model.level;
  record.level_reason = model.level_reason;
  record.warnings = run_warnings(file.setup.scene, file.setup.solver, model, response);
  record.outline = beam_outline(model);
  record.inputs = {{std::filesystem::path(file.path).filename().string(), file.text}};
  keep_valid_samples(response);
  record.response = std::move(response);
  const auto put = [&](Place& place) {
    if (!record.outline.ends.empty()) place = {fraction_of(place, record.outline.ends), {}};
  };
  Scene& scene = record.setup.scene;
  for (Support& support : scene.supports) {
    put(support.at);
    if (support.to) put(*support.to);
    support.hold = support.held();
  }
  for (Load& load : scene.loads) {
    put(load.at);
    if (load.to) put(*load.to);
  }
  for (PointMass& mass : scene.masses) put(mass.at);
  for (Probe& probe : scene.probes) put(probe.at);
  for (InitialMotion& motion : scene.initial_motions) {
    for (Place* place : {&motion.from, &motion.to, &motion.about}) put(*place);
  }
  for (Cut& cut : scene.cuts) put(cut.at);
  for (Region& region : scene.regions) {
    put(region.from);
    put(region.to);
  }
  if (auto& at = record.setup.solver.control_at) put(*at);
  return record;
}

void write_scene_store(const std::string& path, const SceneRecord& record, Overwrite overwrite,
                       const std::function<void(Hdf5Group& root)>& write_more) {
  Hdf5File file = Hdf5File::create(path, overwrite, record.meta.threads);
  Hdf5Group& root = file.root();
  write_schema(root, kSceneSchema, kSceneVersion);
  SceneWriter writer(root);
  scene_layout::traverse(writer, record);
  Hdf5Group options = root.group("options");
  write_setup(options, record.setup);
  Hdf5Group regions = root.group("regions");
  write_regions(regions, record.setup.scene.regions);
  write_inputs(root, record.inputs);
  if (write_more) write_more(root);
  write_meta(root, record.meta);
  root.write("meta/run_seconds", record.response.seconds, {"s"});
  file.commit();
}

SceneRecord read_scene_store(const std::string& path) {
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  (void)check_schema(root, kSceneSchema, kOldestScene, kSceneVersion);
  SceneRecord record;
  read_setup(root.open_group("options"), record.setup);
  SceneReader reader(root);
  scene_layout::traverse(reader, record);
  record.setup.scene.regions = read_regions(root.open_group("regions"));
  record.response.chain.joints = record.outline.ends.size();
  record.response.chain.supports = record.setup.scene.supports.size();
  record.inputs = read_inputs(root);
  record.meta = read_meta(root);
  reader.number("meta/run_seconds", record.response.seconds, "s");
  check_agreement(root, record);
  return record;
}

}  // namespace plastica::io
