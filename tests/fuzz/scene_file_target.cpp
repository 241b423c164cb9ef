#include <string>

#include "plastica/io/scene_digest.hpp"
#include "plastica/io/scene_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {
namespace {

/// The same text twice is the same scene.
void read_scene(Bytes bytes) {
  const std::string name = scratch_path("fuzzed.toml");
  const auto read = [&] { return io::parse_scene_file(std::string(text_of(bytes)), name); };
  const auto scene = result_or_refused(read);
  if (!scene) return;
  require(io::scene_digest(scene->setup) == io::scene_digest(read().setup),
          "a scene that reads as another one");
  for (const std::string& note : scene->notes) check_refusal(note);
}

const Registered kSceneFile{"scene_file", read_scene};

}  // namespace
}  // namespace plastica::fuzz
