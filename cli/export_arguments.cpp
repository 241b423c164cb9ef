#include "cli/export_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string_view>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/engine_world.hpp"
#include "cli/common_options.hpp"
#include "cli/export_paraview.hpp"
#include "cli/run_files.hpp"
#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

constexpr std::array<std::string_view, 3> kTables{"json", "markdown", "latex"};

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

bool is_table(const std::string& to) {
  return std::find(kTables.begin(), kTables.end(), to) != kTables.end();
}

std::vector<std::string> list_of(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

}  // namespace

std::vector<std::string> export_formats() {
  const auto engines = calibrate::engine_formats();
  std::vector<std::string> words(engines.begin(), engines.end());
  words.insert(words.begin() + 1, kTables.begin(), kTables.end());
  words.insert(words.end(), kParaviewFormats.begin(), kParaviewFormats.end());
  return words;
}

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

bool wants_beam(const ExportArguments& arguments) {
  if (arguments.beam.to != "csv") {
    return !is_table(arguments.beam.to) && !is_for_paraview(arguments.beam.to);
  }
  if (!arguments.what.empty()) return arguments.what == "beam";
  return arguments.is_scene_file || !arguments.beam.scene.empty() || !arguments.beam.target.empty();
}

void check_words(const ExportArguments& arguments) {
  check_word("--to", arguments.beam.to, export_formats());
  check_word("--what", arguments.what,
             {"specimens", "fits", "targets", "curves", "probes", "joints", "energies", "events",
              "fragments", "spectrum", "cases", "beam"});
  check_word("--up", arguments.beam.up, list_of(calibrate::up_axes()));
  check_word("--contacts", arguments.beam.contacts, list_of(contact_words()));
}

void check_options(const ExportArguments& arguments, ResultKind kind) {
  using enum ResultKind;
  const bool beam = wants_beam(arguments);
  if (arguments.is_scene_file && !beam) {
    throw InputError({arguments.beam.file, 0}, "", "",
                     "is a scene, which has a beam alone: what it does is in the result of "
                     "plastica simulate");
  }
  constexpr std::string_view kOfResults = "is for results; this is a scene";
  refuse_option(arguments.is_scene_file && !arguments.time.empty(), "--time", kOfResults);
  refuse_option(arguments.is_scene_file && !arguments.beam.scene.empty(), "--scene", kOfResults);
  refuse_option(arguments.is_scene_file && !arguments.beam.target.empty(), "--target", kOfResults);
  refuse_option(arguments.is_scene_file && !arguments.beam.which.empty(), "--case", kOfResults);
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

}  // namespace plastica::cli
