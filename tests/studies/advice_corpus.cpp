#include "tests/studies/advice_corpus.hpp"

#include <algorithm>
#include <filesystem>

#include "tests/studies/corpus_parts.hpp"

namespace plastica::studies {
namespace {

std::vector<CorpusScene> shipped_scenes() {
  std::vector<CorpusScene> scenes;
  const std::filesystem::path folder = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    Setup setup = io::read_scene_file(entry.path().string()).setup;
    if (setup.scene.is_coupon()) continue;
    scenes.push_back({entry.path().stem().string(), "shipped", std::move(setup)});
  }
  std::ranges::sort(scenes, {}, &CorpusScene::name);
  return scenes;
}

}  // namespace

std::vector<CorpusScene> advice_corpus() {
  std::vector<CorpusScene> all = shipped_scenes();
  for (const auto& part :
       {elastic_scenes_at_rest(), yielding_scenes_at_rest(), scenes_in_motion()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace plastica::studies
