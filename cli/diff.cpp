#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/result_kind.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/result_difference.hpp"
#include "plastica/io/units.hpp"
#include "plastica/report/format.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

/// Differences that are printed unless all are asked for.
constexpr std::size_t kShown = 20;

struct DiffArguments {
  std::string first;
  std::string second;
  std::string within = "0";
  std::string floor = "0";
  std::vector<std::string> left_out;
  bool all = false;
  bool quiet = false;
};

/// A fraction, "1e-6" or "0.1 %", from 0 on and below 1.
double fraction_from_zero(std::string_view option, const std::string& text) {
  const double value = io::parse_quantity(text, Dimension::Strain, {}, option);
  if (!(value >= 0.0 && value < 1.0)) {
    throw InputError({}, option, text, "must be from 0 on and below 1");
  }
  return value;
}

std::string line_of(const io::ResultDifference& difference) {
  const auto shown = [](const std::string& text) {
    return report::cut(report::printable(text), 60);
  };
  std::string line = "  " + difference.place;
  if (!difference.row.empty()) line += "  " + difference.row;
  line += "  " + shown(difference.first) + ", " + shown(difference.second);
  if (difference.relative) line += fmt::format(": {:.3g}", *difference.relative);
  return line + "\n";
}

void print_differences(const DiffArguments& arguments, const io::ResultComparison& found) {
  std::string all;
  for (const io::ResultDifference& difference : found.differences) all += line_of(difference);
  say(all);
  const std::size_t more = found.differing - found.differences.size();
  if (more > 0) say("  … and {} more: --all shows them\n", more);
  const std::string largest =
      found.largest > 0.0 ? fmt::format(", the largest by {:.3g}", found.largest) : "";
  say("{} and {}: {}{}; {} and {} compared, within {}\n", arguments.first, arguments.second,
      found.differing == 0 ? "equal" : report::counted(found.differing, "difference"), largest,
      report::counted(found.numbers, "number"), report::counted(found.texts, "text"),
      arguments.within);
}

int diff(const DiffArguments& arguments) {
  io::DifferenceRule rule;
  rule.within = fraction_from_zero("--within", arguments.within);
  rule.floor = fraction_from_zero("--floor", arguments.floor);
  rule.left_out = arguments.left_out;
  rule.identities = {std::string(sweeps::kCaseIds)};
  if (!arguments.all) rule.kept = kShown;
  kind_of_result(arguments.first);
  kind_of_result(arguments.second);
  const io::ResultComparison found = compare_results(arguments.first, arguments.second, rule);
  if (!arguments.quiet) {
    for (const std::string& note : found.notes) say("note: {}\n", note);
    print_differences(arguments, found);
  }
  return found.differing == 0 ? kDone : kNotAcceptable;
}

}  // namespace

void add_diff(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("diff", "Compare two results of the same kind");
  auto arguments = std::make_shared<DiffArguments>();
  sub->add_option("first", arguments->first, "A result of calibrate, simulate or sweep")
      ->required()
      ->option_text("A.h5");
  sub->add_option("second", arguments->second, "Another one")->required()->option_text("B.h5");
  sub->add_option("--within", arguments->within,
                  "Take numbers for equal whose difference is at most so much of the larger: "
                  "1e-6, \"0.1 %\"; default: 0")
      ->option_text("FRACTION");
  sub->add_option("--floor", arguments->floor,
                  "Take numbers for equal, too, that are both at most so much of the largest of "
                  "their dataset; default: 0")
      ->option_text("FRACTION");
  sub->add_option("--ignore", arguments->left_out,
                  "Leave out a group, a dataset or an attribute: /inputs, /fits/cost, @version")
      ->allow_extra_args(false)
      ->option_text("PATH");
  sub->add_flag("--all", arguments->all,
                fmt::format("Print all differences, not the first {} alone", kShown));
  add_quiet_option(*sub, arguments->quiet, "nothing");
  sub->footer(
      "Example:\n"
      "  plastica diff before.h5 after.h5 --within 1e-6\n"
      "Left out are times, threads, host and versions (/meta), digests of who ran\n"
      "what, and the surface for ParaView (/VTKHDF). Exit code 0 if the results are\n"
      "equal, 1 if they differ, 2 for bad input.");
  sub->callback([&action, arguments] { action = [arguments] { return diff(*arguments); }; });
}

}  // namespace plastica::cli
