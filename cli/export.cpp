#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/engine_world.hpp"
#include "calibrate/report/csv_export.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/export_beam.hpp"
#include "cli/export_paraview.hpp"
#include "cli/fit_reports.hpp"
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

struct ExportArguments {
  BeamRequest beam;  ///< its file, and `to`, empty: what the output's name ends in, else csv
  std::string what;  ///< empty: the first of the file's kind
  std::string time;
  std::string output = "-";
  bool force = false;
};

constexpr std::array<std::string_view, 3> kTables{"json", "markdown", "latex"};

/// What --to may be: the formats of beams, csv the first, the others of tables, and ParaView's.
std::vector<std::string> formats() {
  const auto engines = calibrate::engine_formats();
  std::vector<std::string> words(engines.begin(), engines.end());
  words.insert(words.begin() + 1, kTables.begin(), kTables.end());
  words.insert(words.end(), kParaviewFormats.begin(), kParaviewFormats.end());
  return words;
}

/// The format of a table whose files end so; empty for others.
std::string format_of(const std::string& ending) {
  constexpr std::array<std::array<std::string_view, 2>, 6> kEndings{{{".csv", "csv"},
                                                                     {".json", "json"},
                                                                     {".md", "markdown"},
                                                                     {".tex", "latex"},
                                                                     {".vtkhdf", "vtkhdf"},
                                                                     {".xdmf", "xdmf"}}};
  for (const auto& [end, format] : kEndings) {
    if (ending == end) return std::string(format);
  }
  return {};
}

/// Takes the format from the output's name where none is given. @throws InputError if they differ,
/// or if the name says another format than those of tables
void take_format(ExportArguments& arguments) {
  const std::string& output = arguments.output;
  const std::string ending = std::filesystem::path(output).extension().string();
  const std::string named = output == "-" ? "" : format_of(ending);
  if (!arguments.beam.to.empty()) {
    if (named.empty() || named == arguments.beam.to) return;
    throw InputError({}, "--output", output,
                     fmt::format("must not end in {}: --to is {}", ending, arguments.beam.to));
  }
  if (named.empty() && output != "-" && ending.size() > 1 && ending != ".txt" && ending != ".dat") {
    throw InputError({}, "--output", output,
                     fmt::format("ends in {}, which says no format: give --to", ending));
  }
  arguments.beam.to = named.empty() ? "csv" : named;
}

bool is_table(const std::string& to) {
  return std::find(kTables.begin(), kTables.end(), to) != kTables.end();
}

/// Whether the beam is wanted for an engine, not the numbers of the result.
bool wants_beam(const ExportArguments& arguments) {
  if (arguments.beam.to != "csv") {
    return !is_table(arguments.beam.to) && !is_for_paraview(arguments.beam.to);
  }
  return arguments.what == "beam" || (arguments.what.empty() && !(arguments.beam.scene.empty() &&
                                                                  arguments.beam.target.empty()));
}

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

/// Refuses options that do not go with the file's kind or with what is written.
/// @throws InputError
void check_options(const ExportArguments& arguments, ResultKind kind) {
  using enum ResultKind;
  const bool beam = wants_beam(arguments);
  const std::array options{
      ResultOption{"--time", !arguments.time.empty(), {Scene}},
      ResultOption{"--scene", !arguments.beam.scene.empty(), {Fits, SceneFits}},
      ResultOption{"--target", !arguments.beam.target.empty(), {SceneFits}},
      ResultOption{"--case", !arguments.beam.which.empty(), {Fits, SceneFits}},
      ResultOption{"--what beam", arguments.what == "beam", {Fits, SceneFits, Scene}},
      ResultOption{"--to " + arguments.beam.to, beam, {Fits, SceneFits, Scene}},
      ResultOption{"--to " + arguments.beam.to,
                   arguments.beam.to == "markdown" || arguments.beam.to == "latex",
                   {Sweep}},
      ResultOption{"--to " + arguments.beam.to, is_for_paraview(arguments.beam.to), {Scene}}};
  refuse_options_of_others(kind, options);
  constexpr std::string_view kOfBeams =
      "goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or opensees";
  refuse_option(!beam && !arguments.beam.scene.empty(), "--scene", kOfBeams);
  refuse_option(!beam && !arguments.beam.which.empty(), "--case", kOfBeams);
  refuse_option(!beam && !arguments.beam.target.empty(), "--target", kOfBeams);
  refuse_option(!beam && arguments.beam.segments, "--segments", kOfBeams);
  refuse_option(!beam && !arguments.beam.up.empty(), "--up", kOfBeams);
  refuse_option(!beam && !arguments.beam.gravity.empty(), "--gravity", kOfBeams);
  refuse_option(!beam && !arguments.beam.damping.empty(), "--damping", kOfBeams);
  refuse_option(!beam && !arguments.beam.contacts.empty(), "--contacts", kOfBeams);
  if (beam || is_for_paraview(arguments.beam.to)) {
    refuse_option(!arguments.what.empty() && !(beam && arguments.what == "beam"), "--what",
                  "goes with --to csv or json");
    refuse_option(!arguments.time.empty(), "--time", "goes with --what joints only");
  }
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

std::vector<std::string> list_of(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

/// The words that stand in no file.
void check_words(const ExportArguments& arguments) {
  check_word("--what", arguments.what,
             {"specimens", "fits", "targets", "curves", "probes", "joints", "energies", "events",
              "fragments", "spectrum", "cases", "beam"});
  check_word("--up", arguments.beam.up, list_of(calibrate::up_axes()));
  check_word("--contacts", arguments.beam.contacts, list_of(contact_words()));
}

int run_export(ExportArguments arguments) {
  check_word("--to", arguments.beam.to, formats());
  check_words(arguments);
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.beam.file);
    if (!arguments.beam.scene.empty())
      refuse_input("--output", arguments.output, arguments.beam.scene);
  }
  take_format(arguments);
  const ResultKind kind = kind_of_result(arguments.beam.file);
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
      app.add_subcommand("export", "Write numbers of a result file, or its beam for an engine");
  auto arguments = std::make_shared<ExportArguments>();
  sub->add_option("file", arguments->beam.file, "Result of calibrate, simulate or sweep")
      ->required()
      ->option_text("FILE.h5");
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
      "                       break angles\n"
      "Examples:\n"
      "  plastica export fit.h5 --to csv -o fit.csv\n"
      "  plastica export scene.h5 -o scene.vtkhdf\n"
      "  plastica export fit.h5 --case s355 --scene scene.toml --to mjcf -o beam.xml\n"
      "  plastica export scene.h5 --to mjcf --up z --gravity \"9.81 m/s^2\" -o beam.xml\n"
      "  plastica export scene-fit.h5 --to mjcf -o beam.xml\n"
      "  plastica export joint-fit.h5 --target bend --to mjcf -o bend.xml");
  sub->callback([&action, arguments] { action = [arguments] { return run_export(*arguments); }; });
}

}  // namespace plastica::cli
