#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/page_output.hpp"
#include "cli/run_files.hpp"
#include "cli/run_team.hpp"
#include "cli/shard_option.hpp"
#include "cli/tell.hpp"
#include "cli/terminal_line.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/picture.hpp"
#include "sweeps/report/web/scan_page.hpp"
#include "sweeps/stability/point_journal.hpp"
#include "sweeps/stability/scene_scan_text.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::cli {
namespace {

namespace stability = sweeps::stability;

struct StabilityArguments {
  std::string command_line;
  std::string file;
  std::vector<std::string> vary;
  std::string within = "5 %";
  stability::SceneScanOptions options;
  std::string output;
  std::string map;
  std::optional<double> width;  ///< of the map [mm]
  std::string report;
  bool resume = false;
  bool force = false;
  bool quiet = false;
  RunTeam* launched = nullptr;  ///< other processes, which may join; null: none
  Team* team = nullptr;         ///< those that have joined; null: none
};

void check_stability_outputs(const StabilityArguments& arguments) {
  const auto check = [&](std::string_view option, const std::string& path) {
    if (path.empty()) return;
    refuse_input(option, path, arguments.file);
    io::check_output_path(path, arguments.force);
  };
  check("--output", arguments.output);
  require_ending("--output", arguments.output, ".csv", "it has the points");
  check_width(arguments.width, arguments.map);
  if (!arguments.map.empty()) report::check_picture_output(arguments.map, "--map");
  if (arguments.map != "-") check("--map", arguments.map);
  if (!arguments.output.empty() && !arguments.map.empty()) {
    refuse_own_files("--map", arguments.map, arguments.output);
  }
  const std::string drawn = arguments.map == "-" ? "" : arguments.map;
  check_report_option(arguments.report, arguments.force, std::array{arguments.file},
                      std::array{arguments.output, drawn});
}

bool any_undetected(const std::vector<stability::StabilityRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const auto& row) {
    return row.verdict.validity == stability::Validity::Undetected;
  });
}

/// Where the points are kept until the output has them: beside it, so nowhere without one.
std::unique_ptr<stability::PointJournal> open_journal(const StabilityArguments& arguments,
                                                      const io::SceneFile& file, double within,
                                                      const std::string& instruction_set,
                                                      StopFlag stop) {
  const auto require_output = [&](std::string_view option, std::string_view rule) {
    throw InputError({}, option, "", std::string(rule) + ": give -o FILE");
  };
  if (arguments.output.empty()) {
    if (arguments.resume) require_output("--resume", "goes on from what stands beside the output");
    if (arguments.team != nullptr) {
      require_output("--output", "is where processes keep what they have finished");
    }
    return nullptr;
  }
  const io::JournalPolicy policy =
      policy_of(arguments.output, {}, arguments.resume, arguments.force, instruction_set, nullptr,
                arguments.team);
  if (arguments.launched != nullptr) arguments.launched->watch(stop, policy.path, arguments.output);
  auto journal = std::make_unique<stability::PointJournal>(policy, file.setup, within);
  if (journal->journal().dropped_bytes() > 0) {
    tell("plastica: dropped {} bytes of an unfinished record from the journal\n",
         journal->journal().dropped_bytes());
  }
  if (journal->journal().damaged() > 0) tell_of_damage();
  if (!arguments.quiet && journal->resumed() > 0) {
    tell("{} resumed from an earlier run\n", report::counted(journal->resumed(), "point"));
  }
  // Another run may have had the journal until now, and have written the output.
  io::check_output_path(arguments.output, arguments.force);
  return journal;
}

/// What was run of a scene, and what of it the outputs say.
struct Scanned {
  const io::SceneFile& file;
  const stability::SceneScanOptions& options;
  io::RunMeta meta;
  stability::SceneScan scan{};
  stability::PairScan pair{{}, true};

  bool complete() const { return scan.complete && pair.complete; }
  std::vector<stability::StabilityRow> points() const {
    std::vector<stability::StabilityRow> all = scan.rows;
    all.insert(all.end(), pair.rows.begin(), pair.rows.end());
    return all;
  }
};

void write_report(const StabilityArguments& arguments, const Scanned& of) {
  if (arguments.report.empty() || of.points().empty()) return;
  write_page(arguments.report,
             stability::scan_page(of.scan, of.pair.rows, of.options, of.file, of.meta),
             io::overwrite_if(arguments.force));
  tell("wrote {}\n", arguments.report);
}

void draw_map(const StabilityArguments& arguments, const Scanned& of) {
  if (of.pair.rows.empty()) return;
  const auto map = stability::pair_map(of.pair.rows, of.file.setup, *of.scan.fields[0].field,
                                       *of.scan.fields[1].field,
                                       report::sheet_of(arguments.map, arguments.width));
  report::draw_picture(map, arguments.map, std::cout, io::overwrite_if(arguments.force));
  if (arguments.map != "-") tell("wrote {}\n", arguments.map);
}

/// After a stop the points are in the journal, or else in the report, or lost.
int end_stopped(const StabilityArguments& arguments, const Scanned& of,
                stability::PointJournal* journal) {
  if (journal != nullptr) {
    journal->sync();
    tell_interrupted(arguments.output);
    return kInterrupted;
  }
  write_report(arguments, of);
  const std::size_t points = of.points().size();
  const bool lost = arguments.report.empty() && points > 0;
  tell("plastica: interrupted after {}{}\n", report::counted(points, "point"),
       lost ? ", which are lost: -o FILE keeps them" : "");
  return kInterrupted;
}

int scan_file(const StabilityArguments& arguments) {
  expect_input(arguments.file, {InputKind::Scene});
  io::SceneFile file = io::read_scene_file(arguments.file);
  tell_notes(file.notes);
  stability::SceneScanOptions options = arguments.options;
  options.within = fraction_of("--within", arguments.within);
  const auto fields = stability::scanned_fields(file.setup, arguments.vary);
  if (!arguments.map.empty() && arguments.vary.size() != 2) {
    throw InputError({}, "--map", arguments.map, "is of two fields: name them by --vary");
  }
  check_stability_outputs(arguments);
  const auto begin = std::chrono::steady_clock::now();
  Scanned of{file, options, io::begin_meta(arguments.command_line, options.threads)};
  of.meta.instruction_set = name_of(resolved(file.setup.solver.isa));
  const InterruptGuard interrupt;
  options.stop = &interrupt.flag();
  const auto journal =
      open_journal(arguments, file, options.within, of.meta.instruction_set, options.stop);
  options.journal = journal.get();
  if (journal) of.meta.resumptions = journal->journal().resumptions();
  TerminalLine line(arguments.quiet);
  options.progress = [&line](std::size_t points) {
    if (line.is_due()) line.draw(fmt::format("scanning: {} points", points));
  };
  const std::string& name = file.setup.scene.name;
  of.scan = io::with_place_in(
      file, [&] { return stability::scan_scene(name, file.setup, fields, options); });
  const bool valid = of.scan.own.validity == stability::Validity::Valid;
  if (!arguments.map.empty() && valid && of.scan.complete) {
    of.pair = stability::scan_pair(name, file.setup, of.scan.fields[0], of.scan.fields[1], options);
  }
  line.clear();
  of.meta.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (arguments.team != nullptr && !arguments.team->leads()) return kDone;
  if (!of.complete()) return end_stopped(arguments, of, journal.get());

  if (!arguments.output.empty()) {
    io::write_text_file(arguments.output, stability::rows_csv(of.points()),
                        io::overwrite_if(arguments.force));
    tell("wrote {}\n", arguments.output);
  }
  write_report(arguments, of);
  draw_map(arguments, of);
  if (const std::size_t others = journal ? journal->finish() : 0; others > 0) {
    tell("its journal has {} of another scan, and is kept\n", report::counted(others, "point"));
  }
  if (!arguments.quiet) say(stability::scene_scan_text(of.scan, options));
  return valid && !any_undetected(of.points()) ? kDone : kNotAcceptable;
}

}  // namespace

void add_stability(CLI::App& app, const Invocation& invocation, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "stability", "Find how far the numbers of a scene may go until a result is not valid");
  auto arguments = std::make_shared<StabilityArguments>();
  arguments->command_line = invocation.command_line;
  stability::SceneScanOptions& options = arguments->options;
  sub->add_option("file", arguments->file, "Scene file")->required()->option_text("SCENE.toml");
  sub->add_option("--vary", arguments->vary,
                  "Vary these: beam.segments,material.yield_stress; default: all numbers of the "
                  "scene")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("FIELD,...");
  sub->add_option("--within", arguments->within,
                  "Take a result for valid up to this deviation from a finer run; default: 5 %")
      ->option_text("ERROR");
  sub->add_option("--reach", options.reach, "Vary by factors up to N; default: 1000")
      ->check(CLI::Range(1.01, 1e9))
      ->option_text("N");
  sub->add_option("--max-work", options.max_work,
                  "Leave out runs of more than N times the work of the scene as it is; default: 64")
      ->check(CLI::Range(1.0, 1e9))
      ->option_text("N");
  sub->add_option("-o,--output", arguments->output, "Write every point as CSV")
      ->option_text("FILE");
  add_width_option(*sub, arguments->width);
  sub->add_option("--map", arguments->map,
                  "Draw the map of two fields: .svg, .png, .pdf or .gp, - for the terminal")
      ->option_text("FILE");
  add_report_option(*sub, arguments->report);
  add_threads_option(*sub, options.threads);
  sub->add_flag("--resume", arguments->resume,
                "Run only what an interrupted run has not kept beside the output");
  add_force_option(*sub, arguments->force, "files that are there, and an interrupted run");
  add_quiet_option(*sub, arguments->quiet, "no table, no progress");
  group_options(*sub, "What to vary, and how far", {"--vary", "--reach", "--within", "--max-work"});
  group_options(*sub, "Results",
                {"--output", "--map", "--width", "--report", "--resume", "--force"});
  sub->footer(
      "Example:\n"
      "  plastica stability scene.toml --vary beam.segments,beam.length --map m.svg\n"
      "  mpirun -np 64 plastica stability scene.toml -o p.csv   # share a run\n"
      "Exit code 1 if the scene's own result is not valid, or one has an undetected\n"
      "error; 130 after Ctrl-C: with -o, --resume goes on.");
  arguments->launched = invocation.team;
  sub->callback([&action, arguments] {
    action = [arguments] {
      arguments->team =
          join_team(arguments->launched, arguments->command_line, arguments->options.threads);
      return scan_file(*arguments);
    };
  });
}

}  // namespace plastica::cli
