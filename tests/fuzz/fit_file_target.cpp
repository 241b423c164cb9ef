#include <string>

#include "calibrate/config/fit_file.hpp"
#include "calibrate/config/scene_fit_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Fit files, of curves and through scenes, and the curves that they name.
namespace plastica::fuzz {
namespace {

void read_fit(Bytes bytes) {
  const std::string text(text_of(bytes));
  const std::string name = scratch_path("fuzzed.toml");
  if (const auto file = result_or_refused([&] { return calibrate::parse_fit_file(text, name); })) {
    for (const std::string& note : file->notes) check_refusal(note);
    read_or_refused([&] {
      for (const calibrate::Target& target : calibrate::import_all(*file, 1)) {
        if (target.reason.empty()) continue;
        check_refusal(target.reason);
      }
    });
  }
  if (const auto file =
          result_or_refused([&] { return calibrate::parse_scene_fit_file(text, name); })) {
    read_or_refused([&] { calibrate::check_fits(*file); });
  }
}

const Registered kFitFile{"fit_file", read_fit};

}  // namespace
}  // namespace plastica::fuzz
