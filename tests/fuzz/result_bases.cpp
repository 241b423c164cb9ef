#include "tests/fuzz/result_bases.hpp"

#include <fcntl.h>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/file_descriptor.hpp"
#include "plastica/io/scene_store.hpp"
#include "sweeps/store/sweep_store.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/calibrate/store/synthetic_scene_fits.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/motion_record.hpp"
#include "tests/support/scene_record.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::fuzz {
namespace {

template <typename Write>
std::string file_of(const Write& write) {
  const std::string path = scratch_path("base.h5");
  write(path);
  return content_of(path);
}

std::string file_of_scene(const io::SceneRecord& record) {
  return file_of([&](const std::string& path) { io::write_scene_store(path, record); });
}

std::string file_of_fits() {
  using namespace calibrate;
  FitStoreContents contents;
  contents.records = {filled_record("a"), rejected_record("b")};
  contents.options = ideal_options();
  return file_of([&](const std::string& path) { write_fit_store(path, contents); });
}

std::string file_of_scene_fits() {
  using namespace calibrate;
  SceneFitContents contents;
  contents.records = {filled_scene_record("a"), failed_scene_record("b")};
  return file_of([&](const std::string& path) { write_scene_fit_store(path, contents); });
}

std::string file_of_sweep() {
  const sweeps::SweepRecord record =
      sweeps::record_of(sweeps::segments_axis("[2, 4]") +
                        "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n" +
                        "[error]\nprobe = \"tip\"\nagainst = \"finest\"\n");
  return file_of([&](const std::string& path) { sweeps::write_sweep_store(path, record); });
}

}  // namespace

const std::vector<std::string>& result_bases() {
  static const std::vector<std::string> bases{
      file_of_fits(),
      file_of_scene_fits(),
      file_of_scene(testing::motion_record({4, 21, 5, 0.2, true})),
      file_of_scene(testing::record_of(testing::coupon_text())),
      file_of_scene(testing::record_of(testing::cantilever_text())),
      file_of_sweep()};
  return bases;
}

ResultChoice result_choice(std::size_t byte) {
  const std::vector<std::string>& bases = result_bases();
  return {bases[byte % bases.size()], byte / bases.size() % 4 == 1};
}

std::string sealed_scratch_file(const std::string& content) {
  std::string path = scratch_file("fuzzed.h5", content);
  const io::FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  io::write_content_digest(file.get(), path);
  return path;
}

}  // namespace plastica::fuzz
