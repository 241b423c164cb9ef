#include "sweeps/stability/stability.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/picture.hpp"
#include "sweeps/stability/stability_map.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::cli {
namespace {

namespace stability = sweeps::stability;

struct StabilityArguments {
  stability::StabilityOptions options;
  std::string output;
  std::string map;
  bool force = false;
  bool quiet = false;
};

void write_file(const std::string& path, const std::string& text, io::Overwrite overwrite) {
  io::write_text_file(path, text, overwrite);
  tell("wrote {}\n", path);
}

int run_study(const StabilityArguments& arguments) {
  for (const std::string& path : {arguments.output, arguments.map}) {
    if (!path.empty()) io::check_output_path(path, arguments.force);
  }
  if (!arguments.output.empty() && !arguments.map.empty()) {
    refuse_own_files("--map", arguments.map, arguments.output);
  }
  const InterruptGuard interrupt;
  stability::StabilityOptions options = arguments.options;
  options.stop = &interrupt.flag();
  std::unique_ptr<ProgressBar> bar;
  options.progress = [&](const stability::StabilityRow& /*row*/, std::size_t finished,
                         std::size_t all) {
    if (!bar) bar = std::make_unique<ProgressBar>("scanning", all, arguments.quiet);
    bar->update(finished, 0);
  };
  std::vector<stability::StabilityRow> rows = stability::run_stability(options);
  if (bar) bar->clear();
  std::erase_if(rows, [](const auto& row) { return !row.begun; });
  if (rows.empty() && !interrupt.flag()) {
    const bool limited =
        options.max_segment_steps < stability::StabilityOptions{}.max_segment_steps;
    throw InputError(
        {}, "--only", fmt::format("{}", fmt::join(options.only, ", ")),
        limited ? "is in the name of no point within --max-work" : "is in the name of no point");
  }
  // What was scanned is kept, whether all was or not.
  const io::Overwrite overwrite = io::overwrite_if(arguments.force);
  if (!arguments.output.empty()) write_file(arguments.output, stability::rows_csv(rows), overwrite);
  if (!arguments.map.empty()) {
    report::draw_picture(stability::stability_map(rows), arguments.map, std::cout, overwrite);
    tell("wrote {}\n", arguments.map);
  }
  if (!arguments.quiet) fmt::print("{}", stability::summary_text(rows));
  if (interrupt.flag()) {
    tell("plastica: interrupted after {} points\n", rows.size());
    return kInterrupted;
  }
  const bool any_undetected = std::any_of(rows.begin(), rows.end(), [](const auto& row) {
    return row.verdict.validity == stability::Validity::Undetected;
  });
  return any_undetected ? kNotAcceptable : kDone;
}

}  // namespace

void add_stability(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "stability", "Run scenes up to the limits of the library, and judge each result");
  auto arguments = std::make_shared<StabilityArguments>();
  stability::StabilityOptions& options = arguments->options;
  sub->add_option("--only", options.only,
                  "Run points with this in their name: planar, \"time step\", \"twist spin/\"")
      ->option_text("TEXT...");
  sub->add_option("--sample", options.sample, "Draw N points at random; 0: all")
      ->check(CLI::Range(0, 1'000'000))
      ->option_text("N");
  sub->add_option("--seed", options.seed, "Seed of the sample")->option_text("N");
  sub->add_option("--max-work", options.max_segment_steps, "Leave out points of more segment-steps")
      ->option_text("N");
  sub->add_option("-o,--output", arguments->output, "Write every point as CSV")
      ->option_text("FILE");
  sub->add_option("--map", arguments->map, "Draw the map: .svg, .png, .pdf or .gp")
      ->option_text("FILE");
  add_threads_option(*sub, options.threads);
  add_force_option(*sub, arguments->force, "files that are there");
  add_quiet_option(*sub, arguments->quiet, "no tables, no progress");
  sub->footer(
      "Example:\n"
      "  plastica stability --sample 100 --max-work 2e4 -o points.csv --map map.svg\n"
      "All points take some 10 minutes on two cores. Exit code 1 if a point has an\n"
      "undetected error.");
  sub->callback([&action, arguments] { action = [arguments] { return run_study(*arguments); }; });
}

}  // namespace plastica::cli
