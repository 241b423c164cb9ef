#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/io/units.hpp"
#include "sweeps/store/sweep_store.hpp"
#include "sweeps/trade/recommend_text.hpp"

namespace plastica::cli {
namespace {

struct RecommendArguments {
  std::string file;
  std::string within;
  std::string budget;
  std::string by;
  std::string output;
  std::string next;  ///< where the scene of the next cheaper setting goes
  bool force = false;
};

double positive(std::string_view option, const std::string& text, Dimension dimension) {
  const double value = io::parse_quantity(text, dimension, {}, option);
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw InputError({}, option, text, "must be above 0");
  }
  return value;
}

bool is_plain_number(const std::string& text) {
  return text.find_first_not_of("0123456789.eE+-") == std::string::npos;
}

/// A budget without a unit is one of segment-iterations.
sweeps::CostKind cost_kind(const RecommendArguments& arguments, const sweeps::SweepRecord& record) {
  const bool timed = record.timed_runs > 0;
  const auto refuse_untimed = [&](std::string_view option, const std::string& value) {
    if (!timed) {
      throw InputError({}, option, value, "needs a sweep that timed its cases: [cost] timed_runs");
    }
  };
  if (!arguments.budget.empty()) {
    if (!arguments.by.empty()) {
      throw InputError({}, "--by", arguments.by, "is said by the unit of --budget");
    }
    if (is_plain_number(arguments.budget)) return sweeps::CostKind::Work;
    refuse_untimed("--budget", arguments.budget);
    return sweeps::CostKind::Seconds;
  }
  if (arguments.by == "work") return sweeps::CostKind::Work;
  if (arguments.by == "time") refuse_untimed("--by", arguments.by);
  return timed ? sweeps::CostKind::Seconds : sweeps::CostKind::Work;
}

sweeps::Wish wish_of(const RecommendArguments& arguments, sweeps::CostKind cost) {
  if (arguments.within.empty() == arguments.budget.empty()) {
    throw InputError({}, "recommend", "", "needs one of --within and --budget");
  }
  sweeps::Wish wish;
  if (!arguments.within.empty()) {
    wish.within = fraction_of("--within", arguments.within);
  } else {
    wish.budget = positive("--budget", arguments.budget,
                           cost == sweeps::CostKind::Seconds ? Dimension::Time : Dimension::None);
  }
  return wish;
}

/// Writes the scene of a case. Tables that it names are looked for beside the result.
void write_scene(const RecommendArguments& arguments, const sweeps::SweepRecord& record,
                 std::size_t index, const std::string& path) {
  const std::string folder = std::filesystem::path(arguments.file).parent_path().string();
  const std::string text = sweeps::scene_with_setting(record, index, folder, path);
  io::write_text_file(path, text, io::overwrite_if(arguments.force));
  tell("wrote {}\n", path);
}

int recommend(const RecommendArguments& arguments) {
  kind_of_result(arguments.file);
  const sweeps::SweepRecord record = sweeps::read_sweep_store(arguments.file);
  const sweeps::CostKind cost = cost_kind(arguments, record);
  const sweeps::Wish wish = wish_of(arguments, cost);
  if (record.against.empty()) {
    throw InputError({arguments.file, 0}, "", "", "has no errors: its sweep has no error.against");
  }
  for (const auto& [option, path] :
       {std::pair<std::string_view, std::string>("--output", arguments.output),
        std::pair<std::string_view, std::string>("--next", arguments.next)}) {
    if (path.empty()) continue;
    refuse_input(option, path, arguments.file);
    require_ending(option, path, ".toml", option == "--next" ? "it is a sweep" : "it is the scene");
    io::check_output_path(path, arguments.force);
  }
  if (!arguments.next.empty() && !arguments.output.empty()) {
    refuse_own_files("--next", arguments.next, arguments.output);
  }
  sweeps::check_settings(record);
  const auto points = sweeps::promised_points(record, cost);
  const sweeps::Recommendation choice = wish.within
                                            ? sweeps::recommend_for_error(points, *wish.within)
                                            : sweeps::recommend_for_budget(points, *wish.budget);
  if (choice.chosen && !arguments.output.empty()) {
    write_scene(arguments, record, *choice.chosen, arguments.output);
  }
  if (choice.next && !arguments.next.empty()) {
    write_scene(arguments, record, *choice.next, arguments.next);
  }
  fmt::print("{}", sweeps::recommendation_text(record, cost, wish, choice));
  for (const std::string& warning : record.warnings) say("warning: {}\n", warning);
  if (!choice.chosen) return kNotAcceptable;
  return kDone;
}

}  // namespace

void add_recommend(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("recommend",
                                     "Find the cheapest setting of a sweep that meets an accuracy");
  auto arguments = std::make_shared<RecommendArguments>();
  sub->add_option("file", arguments->file, "Result of `plastica sweep`, with errors")
      ->required()
      ->option_text("SWEEP.h5");
  sub->add_option("--within", arguments->within, "Meet this error: \"1 %\"")->option_text("ERROR");
  sub->add_option("--budget", arguments->budget,
                  "Cost at most this: \"2 ms\", or a number of segment-iterations")
      ->option_text("COST");
  sub->add_option("--by", arguments->by,
                  "Count time or work as cost of --within; default: time, where the sweep has it")
      ->check(CLI::IsMember({"time", "work"}))
      ->option_text("COST");
  sub->add_option("-o,--output", arguments->output, "Also write the scene with that setting")
      ->option_text("FILE");
  sub->add_option("--next", arguments->next,
                  "Also write the scene of the setting that is named next, if there is one")
      ->option_text("FILE");
  add_force_option(*sub, arguments->force, "a scene that is there");
  sub->footer(
      "Example:\n"
      "  plastica recommend sweep.h5 --within \"1 %\" -o scene.toml\n"
      "Exit code 1 if no case meets it, or if no error can be promised.");
  sub->callback([&action, arguments] { action = [arguments] { return recommend(*arguments); }; });
}

}  // namespace plastica::cli
