#include "cli/common_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"

namespace plastica::cli {

void group_options(CLI::App& sub, const std::string& heading,
                   std::initializer_list<std::string> names) {
  for (const std::string& name : names) sub.get_option(name)->group(heading);
}

void add_json_option(CLI::App& sub, std::string& path) {
  sub.add_option("--json", path, "Also write the summary for scripts")->option_text("FILE");
}

void add_threads_option(CLI::App& sub, int& threads, const std::string& idle) {
  sub.add_option("--threads", threads, "Use N threads; 0: " + idle)
      ->check(CLI::Range(0, 4096))
      ->option_text("N");
}

void add_dry_run_option(CLI::App& sub, bool& dry_run) {
  sub.add_flag("--dry-run", dry_run, "Check inputs, print the plan, run nothing");
}

void add_force_option(CLI::App& sub, bool& force, const std::string& what) {
  sub.add_flag("--force", force, "Overwrite " + what);
}

void add_width_option(CLI::App& sub, std::optional<double>& width) {
  sub.add_option(
         "--width", width,
         "Draw for print: MM wide, 80 to 300, with letters of 8 points; columns and pages of "
         "journals have 85 and 170")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double number = 0.0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), number);
            const bool is_number = error == std::errc() && end == text.data() + text.size();
            if (is_number && number >= 80.0 && number <= 300.0) return std::string();
            return text + (is_number ? " must be 80 to 300" : " is no number of millimetres");
          },
          ""))
      ->option_text("MM");
}

void check_width(const std::optional<double>& width, const std::string& output) {
  if (!width || (!output.empty() && output != "-")) return;
  throw InputError({}, "--width", report::brief(*width), "is of a picture in a file: name one");
}

void add_quiet_option(CLI::App& sub, bool& quiet, const std::string& what) {
  sub.add_flag("--quiet", quiet, "Print " + what);
}

std::vector<std::string> with_new_names(std::vector<std::string> words) {
  struct RenamedValue {
    std::string_view command, option, before, now;
  };
  constexpr std::array kValues{RenamedValue{"export", "--what", "pieces", "fragments"}};
  struct RenamedOption {
    std::string_view command, before, now;
  };
  constexpr std::array kOptions{RenamedOption{"stability", "--most-work", "--max-work"}};
  for (const RenamedOption& one : kOptions) {
    if (words.empty() || words.front() != one.command) continue;
    for (std::string& word : words) {
      if (word.substr(0, word.find('=')) != one.before) continue;
      tell("plastica: {} is now {}\n", one.before, one.now);
      word.replace(0, one.before.size(), one.now);
    }
  }
  for (const RenamedValue& one : kValues) {
    if (words.empty() || words.front() != one.command) continue;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string joined = fmt::format("{}={}", one.option, one.before);
      const bool follows = words[i] == one.before && words[i - 1] == one.option;
      if (!follows && words[i] != joined) continue;
      tell("plastica: {} {} is now {}\n", one.option, one.before, one.now);
      words[i].replace(words[i].size() - one.before.size(), one.before.size(), one.now);
    }
  }
  return words;
}

void add_isa_option(CLI::App& sub, std::string& isa) {
  const std::vector<std::string> words(kInstructionSets.begin(), kInstructionSets.end());
  sub.add_option("--isa", isa,
                 fmt::format("Use a CPU instruction set ({}) in place of solver.isa; results may "
                             "differ in the last digits",
                             fmt::join(words, ", ")))
      ->check(CLI::IsMember(words))
      ->option_text("SET");
}

void take_isa(const std::string& isa, SolverOptions& options) {
  if (isa.empty()) return;
  const auto word = std::find(kInstructionSets.begin(), kInstructionSets.end(), isa);
  options.isa = static_cast<InstructionSet>(word - kInstructionSets.begin());
  if (!has_instruction_set(options.isa)) {
    throw InputError({}, "--isa", isa, "is not what this processor has");
  }
}

}  // namespace plastica::cli
