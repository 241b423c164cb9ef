#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/export_paraview.hpp"
#include "cli/frame_progress.hpp"
#include "cli/frequency_line.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/motion_progress.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "cli/terminal.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "plastica/report/vtk/vtkhdf_file.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/run/response_size.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::cli {
namespace {

struct SimulateArguments {
  std::string file;
  std::string output = "-";
  std::string json;
  bool dry_run = false;
  bool force = false;
  bool quiet = false;
  bool paraview = false;
  std::string isa;
  std::string command_line;
};

/// Of result files that ParaView is to take by their name.
constexpr std::string_view kParaviewEnding = ".vtkhdf";

std::string ending_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

/// What --paraview does not go with, and an ending that needs it. @throws InputError
void check_paraview(const SimulateArguments& arguments) {
  const std::string ending = arguments.output == "-" ? "" : ending_of(arguments.output);
  refuse_option(arguments.paraview && ending != ".h5" && ending != kParaviewEnding, "--paraview",
                "goes with a result file: -o FILE.h5 or -o FILE.vtkhdf");
  if (ending == kParaviewEnding && !arguments.paraview) {
    throw InputError({}, "--output", arguments.output,
                     "must end in .h5 or .csv, or be -; with --paraview .vtkhdf does, too");
  }
}

void check_outputs(const SimulateArguments& arguments) {
  const auto check = [&](std::string_view option, const std::string& path) {
    refuse_input(option, path, arguments.file);
    io::check_output_path(path, arguments.force);
  };
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.file);
    const std::string ending = ending_of(arguments.output);
    if (ending != ".h5" && ending != ".csv" && ending != kParaviewEnding) {
      throw InputError({}, "--output", arguments.output, "must end in .h5 or .csv, or be -");
    }
    check("--output", arguments.output);
  }
  if (arguments.json.empty()) return;
  check("--json", arguments.json);
  if (arguments.output != "-") refuse_own_files("--json", arguments.json, arguments.output);
}

/// The scheme and the step of a motion, and how many it will take at least.
std::string motion_label(const Setup& setup, const ChainModel& chain) {
  const SolverOptions& solver = setup.solver;
  const bool adaptive = solver.step_error > 0.0;
  const FixedSteps fixed = fixed_steps({chain.stops, chain.recorded}, solver.time_step);
  // What ran and why is the same in the report: scene_motion_text.cpp.
  const bool cut = !adaptive && fixed.longest < solver.time_step * (1.0 - 1e-9);
  return fmt::format("{}, {} s in {}{:.0f} steps of {}{:.5g} s{}\n",
                     std::get<std::string>(find_field("solver.scheme").get(setup)),
                     chain.stops.back(), adaptive ? "at least " : "", fixed.count,
                     adaptive ? "at most " : "", fixed.longest,
                     cut ? fmt::format(" ({} s cut to samples that are {:.5g} s apart)",
                                       solver.time_step, fixed.samples)
                         : std::string());
}

int print_dry_run(const SimulateArguments& arguments, const Setup& setup, const Model& model) {
  const ResponseSize size = response_size(model);
  // The reason begins with the level's name.
  say("{}: level {}\n", arguments.file, model.level_reason);
  if (model.chain) {
    say("{}, {}, {}, ", report::counted(size.segments, "segment"),
        report::counted(setup.scene.supports.size(), "support"),
        report::counted(setup.scene.loads.size(), "load"));
    if (const std::size_t masses = setup.scene.masses.size(); masses > 0) {
      say("{} point {}, ", masses, masses == 1 ? "mass" : "masses");
    }
  }
  say("{}, ", report::counted(size.samples, "sample"));
  if (model.chain && size.frames < size.samples) {
    say("{}, ", report::counted(size.frames, "frame"));
  }
  say("{}, about {:.1f} MB\n", report::counted(model.probes.size(), "probe"),
      static_cast<double>(size.bytes()) / 1e6);
  if (is_motion(model)) {
    say("{}{}", motion_label(setup, *model.chain), frequency_line(model, setup));
  }
  for (const std::string& warning : scene_warnings(model)) {
    say("warning: {}\n", warning);
  }
  try {
    check_memory(setup.scene, setup.solver);
  } catch (const InputError& error) {
    say("a run is refused: {}\n", error.what());
  }
  say("nothing was run; the result would be {}\n",
      arguments.output == "-" ? "a table on the terminal" : arguments.output);
  return kDone;
}

/// Writes the frames for ParaView into the result. What was computed is written, whenever Ctrl-C
/// comes: nothing stops it.
void write_surface(const io::SceneRecord& record, bool quiet, io::Hdf5Group& root) {
  const std::size_t frames = report::frames_of(record);
  if (frames == 0) {
    tell("note: the run ended before the first frame: the result has nothing for ParaView\n");
    return;
  }
  FrameProgress progress(frames, quiet);
  report::write_vtkhdf(root, record, {nullptr, [&](std::size_t done) { progress.update(done); }});
}

void write_result(const SimulateArguments& arguments, const io::SceneRecord& record,
                  io::Overwrite overwrite) {
  const std::string& output = arguments.output;
  if (output == "-") {
    std::ostringstream table;
    report::write_probes_csv(table, record);
    put(table.str());
    std::fflush(stdout);
  } else if (arguments.paraview) {
    io::write_scene_store(output, record, overwrite, [&](io::Hdf5Group& root) {
      write_surface(record, arguments.quiet, root);
    });
    tell_of_numbered_steps(record);
  } else if (ending_of(output) == ".h5") {
    io::write_scene_store(output, record, overwrite);
  } else {
    std::ostringstream table;
    report::write_probes_csv(table, record);
    io::write_text_file(output, table.str(), overwrite);
  }
}

/// Runs until it is stopped, and tells how far a motion is.
void run_scene(const Model& model, StopFlag stop, bool quiet, Response& response) {
  Workspace workspace = make_workspace(model);
  workspace.stop = stop;
  if (!is_motion(model)) {
    run(model, {}, workspace, response);
    return;
  }
  MotionProgress progress(model.chain->stops.back(), quiet);
  workspace.on_progress = [&](double time) {
    progress.update(time);
    return true;
  };
  run(model, {}, workspace, response);
}

int exit_code_of(const Response& response, bool in_motion, const std::string& output) {
  const Status status = response.status;
  if (usable(status)) return kDone;
  if (status == Status::Interrupted) {
    tell("plastica: interrupted at {:.5g} s: {} holds what was computed up to there\n",
         response.chain.time.empty() ? 0.0 : response.chain.time.back(),
         output == "-" ? "the table" : output);
    return kInterrupted;
  }
  tell("plastica: {}: {}\n", name_of(status), advice(status, in_motion));
  return kNotAcceptable;
}

int simulate_file(const SimulateArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  check_paraview(arguments);
  expect_input(arguments.file, {InputKind::Scene});
  io::SceneFile file = io::read_scene_file(arguments.file);
  refuse_option(arguments.paraview && file.setup.scene.is_coupon(), "--paraview",
                "needs a beam: a coupon has none to show");
  tell_notes(file.notes);
  take_isa(arguments.isa, file.setup.solver);
  const Model model = io::with_place_in(file, [&] {
    if (!arguments.dry_run) check_memory(file.setup.scene, file.setup.solver);
    return prepare(file.setup.scene, file.setup.solver);
  });
  if (arguments.dry_run) return print_dry_run(arguments, file.setup, model);
  check_outputs(arguments);
  // To the end: what has been computed is written, whenever Ctrl-C comes.
  const InterruptGuard interrupt;
  std::optional<io::OutputLock> lock;
  if (arguments.output != "-") {
    lock.emplace(arguments.output);
    io::check_output_path(arguments.output, arguments.force);  // another run has had the lock
  }
  io::RunMeta meta = io::begin_meta(arguments.command_line, 1);
  meta.instruction_set = name_of(resolved(file.setup.solver.isa));
  Response response = make_response(model);
  run_scene(model, &interrupt.flag(), arguments.quiet, response);
  if (response.status == Status::Interrupted && !is_motion(model)) {
    tell("plastica: interrupted; nothing is written of a path\n");
    return kInterrupted;
  }
  io::SceneRecord record = io::make_scene_record(file, model, std::move(response));
  meta.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record.meta = std::move(meta);

  const io::Overwrite overwrite = io::overwrite_if(arguments.force);
  write_result(arguments, record, overwrite);
  if (!arguments.json.empty()) {
    io::write_text_file(arguments.json, report::scene_json(record), overwrite);
  }
  if (!arguments.quiet) {
    // A table on the standard output is left alone: it goes on to another program.
    const bool table = arguments.output == "-";
    const bool color = has_color(table ? STDERR_FILENO : STDOUT_FILENO);
    const std::string report = report::scene_report(record, color);
    if (table) {
      std::fputs(report.c_str(), stderr);
    } else {
      fmt::print("{}", report);
      std::fflush(stdout);  // one file may take both
      tell("wrote {}\n", arguments.output);
    }
  }
  return exit_code_of(record.response, is_motion(model), arguments.output);
}

}  // namespace

void add_simulate(CLI::App& app, const Invocation& invocation, Action& action) {
  CLI::App* sub = app.add_subcommand("simulate", "Simulate a scene: what the beam does");
  auto arguments = std::make_shared<SimulateArguments>();
  sub->add_option("file", arguments->file, "Scene file")->required()->option_text("SCENE.toml");
  sub->add_option("-o,--output", arguments->output,
                  "Write a result file (.h5), or the probes (.csv, or - for the terminal: the "
                  "default)")
      ->option_text("FILE");
  add_json_option(*sub, arguments->json);
  add_isa_option(*sub, arguments->isa);
  add_dry_run_option(*sub, arguments->dry_run);
  sub->add_flag("--paraview", arguments->paraview,
                "Put the beam's surface at each frame into the result file, too, which ParaView "
                "from 5.12 on then opens by the ending .vtkhdf; the surface takes 0.3 to 17 times "
                "the size of the rest");
  add_force_option(*sub, arguments->force, "the output");
  add_quiet_option(*sub, arguments->quiet, "no summary");
  sub->footer("Example:\n  plastica init scene && plastica simulate scene.toml -o scene.h5");
  arguments->command_line = invocation.command_line;
  sub->callback(
      [&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace plastica::cli
