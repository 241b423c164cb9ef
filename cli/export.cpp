#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "calibrate/report/csv_export.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/export_arguments.hpp"
#include "cli/export_beam.hpp"
#include "cli/export_paraview.hpp"
#include "cli/fit_reports.hpp"
#include "cli/input_kind.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_json.hpp"
#include "sweeps/report/csv.hpp"
#include "sweeps/report/json.hpp"
#include "sweeps/report/markup.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

/// What of a file's kind that was asked for, or its first.
std::string what_of(const ExportArguments& arguments, const std::vector<std::string>& kinds) {
  if (arguments.what.empty()) return kinds.front();
  if (std::find(kinds.begin(), kinds.end(), arguments.what) == kinds.end()) {
    throw InputError({}, "--what", arguments.what,
                     fmt::format("must be {} of this file", fmt::join(kinds, " or ")));
  }
  return arguments.what;
}

/// JSON is one summary, whatever of it is asked for.
void refuse_what_of_json(const ExportArguments& arguments) {
  refuse_option(!arguments.what.empty() && arguments.beam.to == "json", "--what",
                "goes with --to csv");
}

/// Says which of the kept frames a time stands for, if it is another time.
void tell_frame(const io::SceneRecord& record, const std::optional<double>& time) {
  if (!time || report::frames_of(record) == 0) return;
  const double last = record.response.chain.time.back();
  const double shown = report::time_of_frame(record, report::frame_at(record, time));
  if (std::abs(shown - *time) <= 1e-9 * std::abs(last)) return;
  tell("the joints are those at {}, the frame next to {}; solver.frames keeps more of them\n",
       report::time_text(shown, last), report::time_text(*time, last));
}

std::string text_of_scene(const ExportArguments& arguments) {
  const std::string what =
      what_of(arguments, {"probes", "joints", "energies", "events", "fragments", "spectrum"});
  const std::optional<double> time = seconds_of("--time", arguments.time);
  refuse_option(time && what != "joints", "--time", "goes with --what joints only");
  refuse_what_of_json(arguments);
  const io::SceneRecord record = io::read_scene_store(arguments.beam.file);
  if (arguments.beam.to == "json") return report::scene_json(record);
  std::ostringstream out;
  if (what == "probes") report::write_probes_csv(out, record);
  if (what == "joints") {
    report::write_joints_csv(out, record, time);
    tell_frame(record, time);
  }
  if (what == "energies") report::write_energies_csv(out, record);
  if (what == "events") report::write_events_csv(out, record);
  if (what == "fragments") report::write_fragments_csv(out, record);
  if (what == "spectrum") report::write_spectrum_csv(out, record);
  return out.str();
}

/// Of fits of curves, or through scenes. @param kinds  of tables; the first is that of the fits
template <typename Contents>
std::string text_of_fits(const ExportArguments& arguments, const std::vector<std::string>& kinds) {
  const std::string what = what_of(arguments, kinds);
  refuse_what_of_json(arguments);
  using enum calibrate::FitSamples;
  const auto contents = read_fits<Contents>(arguments.beam.file, what == "curves" ? Read : Counted);
  if (arguments.beam.to == "json") return json_of(contents);
  std::ostringstream out;
  if (what == "curves") {
    calibrate::write_curves_csv(out, contents.records);
  } else if (what == kinds.front()) {
    calibrate::write_fits_csv(out, contents.records);
  } else if constexpr (std::is_same_v<Contents, calibrate::SceneFitContents>) {
    calibrate::write_targets_csv(out, contents.records);
  }
  return out.str();
}

std::string text_of_sweep(const ExportArguments& arguments) {
  const std::string what = what_of(arguments, {"cases", "curves"});
  refuse_option(!arguments.what.empty() && arguments.beam.to != "csv", "--what",
                "goes with --to csv");
  const sweeps::SweepRecord record = sweeps::read_sweep_store(arguments.beam.file);
  if (arguments.beam.to == "json") return sweeps::sweep_json(record);
  if (arguments.beam.to == "markdown") return sweeps::markdown_table(record);
  if (arguments.beam.to == "latex") return sweeps::latex_table(record);
  std::ostringstream out;
  if (what == "curves") {
    sweeps::write_sweep_curves_csv(out, record);
  } else {
    sweeps::write_cases_csv(out, record);
  }
  return out.str();
}

std::string text_of(const ExportArguments& arguments, ResultKind kind) {
  using enum ResultKind;
  if (wants_beam(arguments)) return beam_text(arguments.beam, kind);
  switch (kind) {
    case Fits: return text_of_fits<calibrate::FitStoreContents>(arguments, {"specimens", "curves"});
    case Scene: return text_of_scene(arguments);
    case SceneFits:
      return text_of_fits<calibrate::SceneFitContents>(arguments, {"fits", "targets", "curves"});
    case Sweep: break;
  }
  return text_of_sweep(arguments);
}

int run_export(ExportArguments arguments) {
  check_words(arguments);
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.beam.file);
    if (!arguments.beam.scene.empty())
      refuse_input("--output", arguments.output, arguments.beam.scene);
  }
  take_format(arguments);
  expect_input(arguments.beam.file, {InputKind::Result, InputKind::Scene});
  arguments.is_scene_file = kind_of_input(arguments.beam.file) == InputKind::Scene;
  const ResultKind kind =
      arguments.is_scene_file ? ResultKind::Scene : kind_of_result(arguments.beam.file);
  check_options(arguments, kind);
  if (is_for_paraview(arguments.beam.to)) {
    return write_for_paraview(arguments.beam.file, arguments.beam.to, arguments.output,
                              arguments.force);
  }
  const std::string text = text_of(arguments, kind);
  if (arguments.output == "-") {
    put(text);
    return kDone;
  }
  io::check_output_path(arguments.output, arguments.force);
  io::write_text_file(arguments.output, text, io::overwrite_if(arguments.force));
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  CLI::App* sub =
      app.add_subcommand("export", "Write numbers of a result, or the beam of a scene or a fit");
  auto arguments = std::make_shared<ExportArguments>();
  sub->add_option("file", arguments->beam.file,
                  "Result of calibrate, simulate or sweep, or a scene for its beam")
      ->required()
      ->option_text("FILE.h5|SCENE.toml");
  sub->add_option(
         "--to", arguments->beam.to,
         "Write csv or json; of a sweep also markdown or latex; of a scene vtkhdf (ParaView from "
         "5.12 on) or xdmf (older ones); the beam as mjcf (MuJoCo), "
         "agx, bullet, chrono or opensees; default: as the output's name ends, else csv")
      ->option_text("FORMAT");
  sub->add_option("--what", arguments->what, "Write these numbers as CSV; names below")
      ->option_text("NAME");
  sub->add_option("--time", arguments->time,
                  "Write joints at this time: \"12 ms\"; default: the last frame")
      ->option_text("TIME");
  sub->add_option("-o,--output", arguments->output, "Write here; - (the default): the terminal")
      ->option_text("FILE");
  add_force_option(*sub, arguments->force, "the output");
  const char* beam = "Beam of a fit";
  sub->add_option(
         "--scene", arguments->beam.scene,
         "Take this scene, with the fitted material; of a fit through several scenes: its name")
      ->option_text("SCENE.toml")
      ->group(beam);
  sub->add_option("--case", arguments->beam.which, "Take this specimen's fit")
      ->option_text("NAME")
      ->group(beam);
  sub->add_option("--target", arguments->beam.target,
                  "Take the scene and the law of this target of a fit through several scenes")
      ->option_text("NAME")
      ->group(beam);
  sub->add_option("--segments", arguments->beam.segments, "Divide the beam into N segments")
      ->option_text("N")
      ->group(beam);
  const char* world = "World of an engine (mjcf, agx, bullet, chrono)";
  sub->add_option("--up", arguments->beam.up,
                  "Turn what is up in the scene (against its gravity, else y) to this axis")
      ->option_text("z|y|x|-z|-y|-x")
      ->group(world);
  sub->add_option("--gravity", arguments->beam.gravity,
                  "Let gravity pull down so: \"9.81 m/s^2\"; default: the scene's")
      ->option_text("G")
      ->group(world);
  sub->add_option("--damping", arguments->beam.damping,
                  "mjcf, bullet, chrono: damp each joint by this time its stiffness: \"0.5 ms\"; "
                  "default: the scene's; in mjcf else a tenth of the step")
      ->option_text("TIME")
      ->group(world);
  sub->add_option("--contacts", arguments->beam.contacts,
                  "mjcf: let segments touch none (the default), others but each other, or all")
      ->option_text("WORD")
      ->group(world);
  sub->footer(
      "Names of --what, by the kind of result:\n"
      "  fits of curves       specimens; curves, a row per sample\n"
      "  fits through scenes  fits, targets, curves\n"
      "  scene                probes, energies (a row per sample), joints, events,\n"
      "                       fragments, spectrum\n"
      "  sweep                cases, curves\n"
      "  scene, fit           beam: a row per joint with stiffness, yield moments,\n"
      "                       break angles; of a scene's file as well\n"
      "Examples:\n"
      "  plastica export scene.toml --to mjcf -o beam.xml\n"
      "  plastica export fit.h5 --to csv -o fit.csv\n"
      "  plastica export scene.h5 -o scene.vtkhdf\n"
      "  plastica export fit.h5 --case s355 --scene scene.toml --to mjcf -o beam.xml\n"
      "  plastica export scene.h5 --to mjcf --up z --gravity \"9.81 m/s^2\" -o beam.xml\n"
      "  plastica export scene-fit.h5 --to mjcf -o beam.xml\n"
      "  plastica export joint-fit.h5 --target bend --to mjcf -o bend.xml");
  sub->callback([&action, arguments] { action = [arguments] { return run_export(*arguments); }; });
}

}  // namespace plastica::cli
