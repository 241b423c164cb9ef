#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/advise_for_engine.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/io/toml_edit.hpp"
#include "plastica/report/picture.hpp"
#include "sweeps/advise/advice_json.hpp"
#include "sweeps/advise/advice_plot.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/trade/written_scene.hpp"

namespace plastica::cli {
namespace {

struct AdviseArguments {
  std::string scene;
  std::string engine;
  std::string within;
  std::string budget;
  std::string output;
  std::string json;
  std::string plot;
  std::optional<double> width;  ///< of the plot [mm]
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

/// The scene with lengths of graded segments, as fractions of the beam's.
std::string with_lengths(const std::string& text, const io::SceneFile& file,
                         const std::vector<double>& fractions, const std::string& output) {
  if (fractions.empty()) return text;
  const auto refusal = InputError({file.path, 0}, "beam.segment_lengths", "",
                                  "cannot be written into the scene's file: do it by hand");
  std::string written;
  try {
    written = io::set_toml_value(text, "beam.segment_lengths",
                                 fmt::format("[{:.12g}]", fmt::join(fractions, ", ")));
  } catch (const InputError&) {
    throw refusal;
  }
  const Setup after = io::parse_scene_file(written, output).setup;
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-11; };
  if (!std::ranges::equal(after.scene.beam.segment_fractions, fractions, same)) throw refusal;
  return written;
}

std::string advised_scene(const io::SceneFile& file, const sweeps::Advice& advice,
                          const std::string& output) {
  std::vector<std::pair<const Field*, FieldValue>> values;
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    values.emplace_back(advice.axes[k].field, advice.setting[k]);
  }
  const Setup wanted = sweeps::advised_setup(file.setup, advice);
  for (const sweeps::WordAxis& axis : advice.word_axes) {
    for (const auto& [field, word] : axis.choices.front().values) {
      const FieldValue value = field->get(wanted);
      if (value != field->get(file.setup)) values.emplace_back(field, value);
    }
  }
  return with_lengths(sweeps::scene_with_values(file.text, values, wanted, file.path, output), file,
                      advice.fractions, output);
}

/// Fills in what is asked for: an error or a time.
void take_wish(AdviseArguments& arguments) {
  if (arguments.within.empty() == arguments.budget.empty()) {
    throw InputError({}, "advise", "", "needs one of --within and --budget");
  }
  if (!arguments.within.empty()) {
    arguments.options.within = fraction_of("--within", arguments.within);
    return;
  }
  arguments.options.budget = seconds_of("--budget", arguments.budget).value_or(0.0);
  if (!(arguments.options.budget > 0.0)) {
    throw InputError({}, "--budget", arguments.budget, "must be above 0 s");
  }
}

void check_outputs_of(const AdviseArguments& arguments) {
  check_width(arguments.width, arguments.plot);
  const std::array<std::pair<std::string_view, const std::string*>, 3> outputs{
      {{"-o", &arguments.output}, {"--json", &arguments.json}, {"--plot", &arguments.plot}}};
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, path] = outputs[i];
    if (path->empty() || (option == "--plot" && *path == "-")) continue;
    if (option == "--plot") report::check_picture_output(*path, option);
    refuse_input(option, *path, arguments.scene);
    io::check_output_path(*path, arguments.force);
    for (std::size_t k = 0; k < i; ++k) {
      if (!outputs[k].second->empty()) refuse_own_files(option, *path, *outputs[k].second);
    }
  }
}

void write_reports(const AdviseArguments& arguments, const sweeps::Advice& advice,
                   const std::string& name) {
  const io::Overwrite overwrite = io::overwrite_if(arguments.force);
  if (!arguments.json.empty()) {
    io::write_text_file(arguments.json, sweeps::advice_json(advice, arguments.options, name),
                        overwrite);
    tell("wrote {}\n", arguments.json);
  }
  if (arguments.plot.empty()) return;
  sweeps::draw_advice(advice, arguments.options, name, arguments.plot, std::cout, overwrite,
                      arguments.width);
  if (arguments.plot != "-") tell("wrote {}\n", arguments.plot);
}

/// What goes with an engine, and no other. @throws InputError
EngineAdviceRequest engine_request(const AdviseArguments& arguments) {
  EngineAdviceRequest request{arguments.engine,  arguments.scene, arguments.output, arguments.json,
                              arguments.options, arguments.force, arguments.quiet};
  check_engine_request(request);
  refuse_option(!arguments.budget.empty(), "--budget",
                "does not go with --for: what a step takes is the engine's affair");
  refuse_option(!arguments.plot.empty(), "--plot", "does not go with --for");
  refuse_option(arguments.width.has_value(), "--width", "does not go with --for");
  return request;
}

int advise(AdviseArguments arguments) {
  const bool for_engine = !arguments.engine.empty();
  if (!for_engine) require_ending("-o", arguments.output, ".toml", "it is the scene");
  if (for_engine) (void)engine_request(arguments);
  take_wish(arguments);
  expect_input(arguments.scene, {InputKind::Scene});
  const io::SceneFile file = io::read_scene_file(arguments.scene);
  tell_notes(file.notes);
  check_outputs_of(arguments);
  if (for_engine) return advise_for_engine(engine_request(arguments), file);
  const sweeps::Advice advice = io::with_place_in(
      file, [&] { return advise_with_progress(file.setup, arguments.options, arguments.quiet); });
  const std::string name = std::filesystem::path(arguments.scene).filename().string();
  fmt::print("{}", sweeps::advice_text(advice, arguments.options, name));
  if (advice.end == sweeps::AdviceEnd::Interrupted) return kInterrupted;
  write_reports(arguments, advice, name);
  if (advice.end != sweeps::AdviceEnd::Found) return kNotAcceptable;
  if (!arguments.output.empty()) {
    io::write_text_file(arguments.output, advised_scene(file, advice, arguments.output),
                        io::overwrite_if(arguments.force));
    tell("wrote {}\n", arguments.output);
  }
  return kDone;
}

}  // namespace

void add_advise(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "advise", "Choose model, segments and time step of a scene for an error or a time");
  auto arguments = std::make_shared<AdviseArguments>();
  sub->add_option("scene", arguments->scene, "Scene file")->required()->option_text("FILE");
  sub->add_option("--within", arguments->within, "Take the cheapest within this error: \"1 %\"")
      ->option_text("ERROR");
  sub->add_option("--budget", arguments->budget,
                  "Take the most accurate whose run takes no more CPU time: \"2 ms\"")
      ->option_text("TIME");
  sub->add_option("--for", arguments->engine,
                  "Choose segments, joints and step for this engine: mujoco, bullet, or chrono, by "
                  "its published rule (not verified in Chrono)")
      ->option_text("ENGINE");
  sub->add_option("--of", arguments->options.probes,
                  "Look at these probes; without it at all of the scene")
      ->option_text("PROBE...");
  sub->add_option("-o,--output", arguments->output,
                  "Write the scene with what is advised; with --for the beam, .xml or .hpp")
      ->option_text("FILE");
  add_json_option(*sub, arguments->json);
  sub->add_option("--plot", arguments->plot,
                  "Also draw error over cost of all runs: .svg, .png, .pdf, .gp, - (terminal)")
      ->option_text("FILE");
  add_width_option(*sub, arguments->width);
  sub->add_option(
         "--max-runs", arguments->options.max_runs,
         fmt::format("Run the scene at most N times; default: {}", arguments->options.max_runs))
      ->check(CLI::Range(4, 10'000))
      ->option_text("N");
  sub->add_option(
         "--max-work", arguments->options.max_work,
         fmt::format("Let all runs together cost at most N segment-iterations, default: {:g}; "
                     "stop a run that takes more than is left, or 200 times what was "
                     "foreseen",
                     arguments->options.max_work))
      ->check(CLI::PositiveNumber)
      ->option_text("N");
  add_threads_option(*sub, arguments->options.threads);
  add_force_option(*sub, arguments->force, "a file that is there");
  add_quiet_option(*sub, arguments->quiet, "no progress");
  group_options(*sub, "Goal", {"--within", "--budget", "--for", "--of"});
  group_options(*sub, "Results", {"--output", "--json", "--plot", "--width", "--force"});
  group_options(*sub, "Limits of the search", {"--max-runs", "--max-work", "--threads"});
  sub->footer(
      "Example:\n"
      "  plastica advise scene.toml --within \"1 %\" -o advised.toml\n"
      "  plastica advise scene.toml --budget \"2 ms\" --plot trade.svg\n"
      "  plastica advise scene.toml --within \"1 %\" --for mujoco -o beam.xml\n"
      "Exit code 1 if no setting is within the error or the time, or none was found\n"
      "within --max-runs and --max-work.");
  sub->callback([&action, arguments] { action = [arguments] { return advise(*arguments); }; });
}

}  // namespace plastica::cli
