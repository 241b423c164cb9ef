#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/report/plot.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_plot.hpp"
#include "sweeps/report/plot.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

struct PlotArguments {
  std::vector<std::string> files;
  calibrate::PlotRequest request;
  std::optional<int> joint;
  std::string probe;
  std::string time;
  std::optional<int> film_frames;
  std::string film_from;
  std::string film_to;
  bool list = false;
  bool force = false;
};

void list(const PlotArguments& arguments) {
  const auto print = [](const auto& kinds) {
    for (const auto& kind : kinds) fmt::print("{:<12} {}\n", kind.name, kind.doc);
  };
  if (arguments.files.empty()) {
    fmt::print("of fits:\n");
    print(calibrate::plot_kinds());
    fmt::print("of fits through scenes:\n");
    print(calibrate::scene_fit_plot_kinds());
    fmt::print("of a simulated scene:\n");
    print(report::scene_plot_kinds());
    fmt::print("of a sweep:\n");
    print(sweeps::sweep_plot_kinds());
    return;
  }
  switch (kind_of_result(arguments.files.front())) {
    case ResultKind::Fits: print(calibrate::plot_kinds()); break;
    case ResultKind::SceneFits: print(calibrate::scene_fit_plot_kinds()); break;
    case ResultKind::Scene:
      print(report::scene_plot_kinds_of(io::read_scene_store(arguments.files.front())));
      break;
    case ResultKind::Sweep:
      print(sweeps::sweep_plot_kinds_of(sweeps::read_sweep_store(arguments.files.front())));
      break;
  }
}

void check_options(ResultKind kind, const PlotArguments& arguments) {
  using enum ResultKind;
  const std::array options{
      ResultOption{"--case", !arguments.request.specimen.empty(), {Fits, SceneFits, Sweep}},
      ResultOption{"--law", !arguments.request.law.empty(), {Fits, SceneFits}},
      ResultOption{"--joint", arguments.joint.has_value(), {Scene}},
      ResultOption{"--probe", !arguments.probe.empty(), {Scene}},
      ResultOption{"--time", !arguments.time.empty(), {Scene}},
      ResultOption{"--frames", arguments.film_frames.has_value(), {Scene}},
      ResultOption{"--from", !arguments.film_from.empty(), {Scene}},
      ResultOption{"--to", !arguments.film_to.empty(), {Scene}}};
  refuse_options_of_others(kind, options);
}

void draw_scenes(const PlotArguments& arguments) {
  std::vector<io::SceneRecord> records;
  for (const std::string& file : arguments.files) records.push_back(io::read_scene_store(file));
  report::ScenePlotRequest request{arguments.request.what, arguments.joint, arguments.probe,
                                   arguments.request.output, arguments.request.overwrite};
  request.width = arguments.request.width;
  request.time = seconds_of("--time", arguments.time);
  request.film_frames = arguments.film_frames;
  request.film_from = seconds_of("--from", arguments.film_from);
  request.film_to = seconds_of("--to", arguments.film_to);
  report::draw_scene_plot(records, request, std::cout);
}

void refuse_second_file(const PlotArguments& arguments, std::string_view why) {
  if (arguments.files.size() == 1) return;
  throw InputError({}, "plot", arguments.files[1], fmt::format("must not be there: {}", why));
}

void draw_sweep(const PlotArguments& arguments) {
  refuse_second_file(arguments, "a sweep is drawn of one file");
  const auto record = sweeps::read_sweep_store(arguments.files.front());
  sweeps::draw_sweep_plot(
      record,
      {arguments.request.what, arguments.request.specimen, arguments.request.output,
       arguments.request.overwrite, arguments.request.width},
      std::cout);
}

int plot(const PlotArguments& arguments) {
  if (arguments.list) {
    list(arguments);
    return kDone;
  }
  const std::string& file = arguments.files.front();
  const ResultKind kind = kind_of_result(file);
  check_options(kind, arguments);
  const std::string& output = arguments.request.output;
  check_width(arguments.request.width, output);
  if (output != "-") {
    for (const std::string& read : arguments.files) refuse_input("--output", output, read);
    io::check_output_path(output, arguments.force);
  }
  constexpr std::string_view kOneOfFits = "fits are drawn of one file";
  switch (kind) {
    case ResultKind::Fits:
      refuse_second_file(arguments, kOneOfFits);
      calibrate::draw_plot(calibrate::read_fit_store(file).records, arguments.request, std::cout);
      break;
    case ResultKind::SceneFits:
      refuse_second_file(arguments, kOneOfFits);
      calibrate::draw_plot(calibrate::read_scene_fit_store(file).records, arguments.request,
                           std::cout);
      break;
    case ResultKind::Scene: draw_scenes(arguments); break;
    case ResultKind::Sweep: draw_sweep(arguments); break;
  }
  if (output != "-") say("wrote {}\n", output);
  return kDone;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("plot", "Draw a picture of a result file");
  auto arguments = std::make_shared<PlotArguments>();
  sub->add_option(
         "files", arguments->files,
         "Result of calibrate, sweep or simulate; several scenes are drawn over each other")
      ->option_text("FILE.h5...");
  sub->add_option("-o,--output", arguments->request.output,
                  "Write .svg, .png or .pdf; .gp: script and data; - (the default): the terminal")
      ->option_text("FILE");
  add_width_option(*sub, arguments->request.width);
  sub->add_option("--what", arguments->request.what, "Draw this picture; see --list")
      ->option_text("NAME");
  sub->add_flag("--list", arguments->list, "List the pictures there are");
  add_force_option(*sub, arguments->force, "a picture that is there");
  const char* fits = "Fits and sweeps";
  sub->add_option("--case", arguments->request.specimen,
                  "Draw this specimen, or this case of a sweep: an id, or \"AXIS = VALUE, AXIS = "
                  "VALUE\"")
      ->option_text("CASE")
      ->group(fits);
  sub->add_option("--law", arguments->request.law,
                  "Draw the fits of this law, where laws are compared; default: the advised one")
      ->option_text("LAW")
      ->group(fits);
  const char* scenes = "Scenes";
  sub->add_option("--joint", arguments->joint, "Draw this joint (picture \"joint\")")
      ->option_text("N")
      ->group(scenes);
  sub->add_option("--probe", arguments->probe,
                  "Draw this probe (pictures \"load\", \"history\", \"spectrum\")")
      ->option_text("NAME")
      ->group(scenes);
  sub->add_option("--time", arguments->time,
                  "Draw the beam at this time (pictures \"shape\", \"moment\"): \"12 ms\"")
      ->option_text("TIME")
      ->group(scenes);
  sub->add_option("--frames", arguments->film_frames, "Draw N shapes, 1 to 100 (picture \"film\")")
      ->check(CLI::Range(1, 100))
      ->option_text("N")
      ->group(scenes);
  sub->add_option("--from", arguments->film_from, "Begin the film at this time: \"12 ms\"")
      ->option_text("TIME")
      ->group(scenes);
  sub->add_option("--to", arguments->film_to, "End the film at this time: \"20 ms\"")
      ->option_text("TIME")
      ->group(scenes);
  arguments->request.output = "-";
  sub->footer(
      "Examples:\n"
      "  plastica plot fit.h5 -o fit.svg\n"
      "  plastica plot scene.h5 --what film -o film.svg");
  sub->callback([&action, arguments] {
    if (arguments->files.empty() && !arguments->list) throw CLI::RequiredError("files");
    arguments->request.overwrite = io::overwrite_if(arguments->force);
    action = [arguments] { return plot(*arguments); };
  });
}

}  // namespace plastica::cli
