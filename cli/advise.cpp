#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/trade/written_scene.hpp"

namespace plastica::cli {
namespace {

struct AdviseArguments {
  std::string scene;
  std::string within;
  std::string output;
  sweeps::AdviceOptions options;
  bool force = false;
  bool quiet = false;
};

sweeps::Advice advise_with_progress(const Setup& setup, sweeps::AdviceOptions options, bool quiet) {
  const InterruptGuard interrupt;
  options.stop = &interrupt.flag();
  ProgressBar bar("runs, at most", static_cast<std::size_t>(options.max_runs), quiet);
  options.progress = [&](int runs) { bar.update(static_cast<std::size_t>(runs), 0); };
  sweeps::Advice advice = sweeps::advise(setup, options);
  bar.clear();
  return advice;
}

std::string advised_scene(const io::SceneFile& file, const sweeps::Advice& advice) {
  std::vector<std::pair<const Field*, FieldValue>> values;
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    values.emplace_back(advice.axes[k].field, advice.setting[k]);
  }
  return sweeps::scene_with_values(file.text, values,
                                   sweeps::setup_at(file.setup, advice.axes, advice.setting));
}

int advise(AdviseArguments arguments) {
  arguments.options.within = fraction_of("--within", arguments.within);
  if (!arguments.output.empty()) {
    refuse_input("-o", arguments.output, arguments.scene);
    io::check_output_path(arguments.output, arguments.force);
  }
  const io::SceneFile file = io::read_scene_file(arguments.scene);
  for (const std::string& note : file.notes) tell("note: {}\n", note);
  const sweeps::Advice advice =
      advise_with_progress(file.setup, arguments.options, arguments.quiet);
  const std::string name = std::filesystem::path(arguments.scene).filename().string();
  fmt::print("{}", sweeps::advice_text(advice, arguments.options, name));
  if (advice.end == sweeps::AdviceEnd::Interrupted) return kInterrupted;
  if (advice.end != sweeps::AdviceEnd::Found) return kNotAcceptable;
  if (!arguments.output.empty()) {
    io::write_text_file(arguments.output, advised_scene(file, advice),
                        io::overwrite_if(arguments.force));
    tell("wrote {}\n", arguments.output);
  }
  return kDone;
}

}  // namespace

void add_advise(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "advise", "Choose segments, time step and fibres of a scene for an error that is allowed");
  auto arguments = std::make_shared<AdviseArguments>();
  sub->add_option("scene", arguments->scene, "Scene file")->required()->option_text("FILE");
  sub->add_option("--within", arguments->within, "The error that is allowed: \"1 %\"")
      ->required()
      ->option_text("ERROR");
  sub->add_option("--of", arguments->options.probes,
                  "Look at these probes; without it at all of the scene")
      ->option_text("PROBE...");
  sub->add_option("-o,--output", arguments->output, "Write the scene with what is advised")
      ->option_text("FILE");
  sub->add_option("--max-runs", arguments->options.max_runs, "Run the scene at most N times")
      ->check(CLI::Range(4, 10'000))
      ->option_text("N")
      ->capture_default_str();
  sub->add_option("--max-work", arguments->options.max_work,
                  "Let all runs together take at most N segment-iterations")
      ->check(CLI::PositiveNumber)
      ->option_text("N")
      ->capture_default_str();
  add_threads_option(*sub, arguments->options.threads);
  add_force_option(*sub, arguments->force, "a file that is there");
  add_quiet_option(*sub, arguments->quiet, "no progress");
  sub->footer(
      "Example:\n"
      "  plastica advise scene.toml --within \"1 %\" -o advised.toml\n"
      "Exit code 1 if no setting is within the error, or none was found within\n"
      "--max-runs and --max-work.");
  sub->callback([&action, arguments] { action = [arguments] { return advise(*arguments); }; });
}

}  // namespace plastica::cli
