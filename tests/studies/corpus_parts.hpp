#pragma once

#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "tests/studies/advice_corpus.hpp"

namespace plastica::studies {

inline CorpusScene corpus_scene(std::string name, std::string group, std::string text,
                                std::optional<ClosedForm> truth = {}) {
  Setup setup = io::parse_scene_file(std::move(text), name + ".toml").setup;
  return {std::move(name), std::move(group), std::move(setup), std::move(truth)};
}

std::vector<CorpusScene> elastic_scenes_at_rest();
std::vector<CorpusScene> yielding_scenes_at_rest();
std::vector<CorpusScene> scenes_in_motion();

}  // namespace plastica::studies
