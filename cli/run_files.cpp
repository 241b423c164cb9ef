#include "cli/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/base/team.hpp"
#include "plastica/io/case_journal.hpp"
#include "plastica/io/durable_file.hpp"
#include "plastica/io/nearest_word.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::cli {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<std::string> files_read(const calibrate::FitFile& file) {
  std::vector<std::string> files;
  for (const calibrate::TableSource* table : tables_of(file)) files.push_back(table->file);
  if (!file.path.empty()) files.push_back(file.path);
  for (const calibrate::TargetBlock& block : file.targets) {
    files.insert(files.end(), block.source.files.begin(), block.source.files.end());
  }
  return files;
}

void refuse_input(std::string_view option, const std::string& output, const std::string& input) {
  std::error_code ignored;
  if (!fs::equivalent(output, input, ignored)) return;
  throw InputError({}, option, output, "is a file that this run reads");
}

void refuse_own_files(std::string_view option, const std::string& path, const std::string& output) {
  // Neither need be there yet: their folders are compared as they are on the disk.
  const auto place = [](const std::string& file) {
    std::error_code ignored;
    const fs::path whole = fs::path(file).lexically_normal();
    return fs::weakly_canonical(io::folder_of(whole.string()), ignored) / whole.filename();
  };
  const auto refuse = [&](const std::string& other, std::string_view rule) {
    if (place(path) == place(other)) throw InputError({}, option, path, rule);
  };
  refuse(output, "is the output, too");
  refuse(io::journal_path(output), "is where the journal of the run goes");
  refuse(io::lock_path(output), "is where the lock of the result file goes");
}

void refuse_other_format(const std::string& output) {
  constexpr std::array<std::string_view, 10> kOthers{".csv", ".json", ".md",  ".pdf", ".png",
                                                     ".svg", ".tex",  ".txt", ".xls", ".xlsx"};
  const std::string ending = fs::path(output).extension().string();
  if (std::ranges::find(kOthers, ending) == kOthers.end()) return;
  throw InputError({}, "--output", output,
                   "is written as HDF5: must end in .h5; plastica export and plot make other files "
                   "of it");
}

void require_ending(std::string_view option, const std::string& output, std::string_view ending,
                    std::string_view kind) {
  if (output.empty() || fs::path(output).extension() == ending) return;
  throw InputError({}, option, output, fmt::format("must end in {}: {}", ending, kind));
}

void refuse_option(bool given, std::string_view option, std::string_view rule) {
  if (given) throw InputError({}, option, "", rule);
}

void check_word(std::string_view option, const std::string& value,
                const std::vector<std::string>& words) {
  if (value.empty() || std::ranges::find(words, value) != words.end()) return;
  std::string rule = fmt::format("must be one of {}", fmt::join(words, ", "));
  if (const auto nearest = io::nearest_word(value, words))
    rule += "; did you mean " + *nearest + "?";
  throw InputError({}, option, value, rule);
}

std::optional<double> seconds_of(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return io::parse_quantity(text, Dimension::Time, {}, option);
}

double fraction_of(std::string_view option, const std::string& text) {
  if (text.find_first_not_of("0123456789.eE+-") == std::string::npos) {
    throw InputError({}, option, text, "needs a unit: \"1 %\"");
  }
  const double value = io::parse_quantity(text, Dimension::Strain, {}, option);
  if (!(value > 0.0)) throw InputError({}, option, text, "must be above 0");
  if (value >= 1.0) throw InputError({}, option, text, "must be below 100 %");
  return value;
}

bool finds_output(bool resume, bool force, const std::string& output, Team* team) {
  std::error_code ignored;
  const bool found = resume && !force && fs::is_regular_file(output, ignored);
  if (team != nullptr) team->agree(found ? 1 : 0, "output: they need one folder");
  return found;
}

void refuse_other_output(const std::string& output, bool journal_is_ours) {
  throw InputError(
      {output, 0}, "", "",
      journal_is_ours
          ? "exists already and is of another run, while its journal is of this one: use --resume "
            "--force to go on and overwrite it"
          : "exists already, and is of other curves, options, version or instruction set: use "
            "--force to overwrite it");
}

void tell_interrupted(const std::string& output) {
  static std::atomic<bool> told = false;
  if (told.exchange(true)) return;
  std::error_code ignored;
  tell("plastica: interrupted; what is finished is kept: --resume{} goes on\n",
       fs::exists(output, ignored) ? " --force" : "");
}

void check_outputs(const calibrate::FitFile& file, const std::string& output,
                   const std::string& json, bool force, bool found) {
  check_outputs(files_read(file), output, json, force, found);
}

void check_outputs(std::span<const std::string> read, const std::string& output,
                   const std::string& json, bool force, bool found) {
  const auto check = [&](std::string_view option, const std::string& path) {
    for (const std::string& input : read) refuse_input(option, path, input);
  };
  check("--output", output);
  refuse_other_format(output);
  io::check_output_path(output, force || found);
  if (json.empty()) return;
  check("--json", json);
  refuse_own_files("--json", json, output);
  // What is made of an output that is there may be replaced by the same.
  io::check_output_path(json, force || found);
}

}  // namespace plastica::cli
