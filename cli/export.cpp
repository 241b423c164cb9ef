#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <ostream>
#include <string>

#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/store/fit_store.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/run_files.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::cli {
namespace {

struct ExportArguments {
  std::string file;
  std::string to = "csv";
  std::string what = "specimens";
  std::string output = "-";
  bool force = false;
};

void write(const ExportArguments& arguments, const calibrate::FitStoreContents& contents,
           std::ostream& out) {
  if (arguments.to == "json") {
    out << calibrate::json_summary(contents.records) << '\n';
  } else if (arguments.what == "curves") {
    calibrate::write_curves_csv(out, contents.records);
  } else {
    calibrate::write_specimens_csv(out, contents.records);
  }
}

int run_export(const ExportArguments& arguments) {
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.file);
    calibrate::check_output_path(arguments.output, arguments.force);
  }
  const calibrate::FitStoreContents contents = calibrate::read_fit_store(arguments.file);
  if (arguments.output == "-") {
    write(arguments, contents, std::cout);
    return kDone;
  }
  std::ofstream out(arguments.output, std::ios::binary);
  write(arguments, contents, out);
  out.close();
  if (!out) throw io::StorageError(arguments.output, "cannot be written");
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("export", "the numbers of a result file");
  auto arguments = std::make_shared<ExportArguments>();
  sub->add_option("file", arguments->file, "result of `plastica calibrate`")->required();
  sub->add_option("--to", arguments->to, "csv or json")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  sub->add_option("--what", arguments->what, "csv: a row per specimen, or per sample of the curves")
      ->check(CLI::IsMember({"specimens", "curves"}))
      ->capture_default_str();
  sub->add_option("-o,--output", arguments->output, "file, or - for the terminal")
      ->capture_default_str();
  sub->add_flag("--force", arguments->force, "overwrite the output");
  sub->footer("Example: plastica export fit.h5 --to csv -o fit.csv");
  sub->callback([&action, arguments] { action = [arguments] { return run_export(*arguments); }; });
}

}  // namespace plastica::cli
