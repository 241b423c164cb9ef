#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/version.hpp"

namespace {

using plastica::cli::Action;

constexpr const char* kFooter =
    "Examples:\n"
    "  plastica inspect specimen.csv           what is in the file, and the block to paste\n"
    "  plastica init fit                       a commented fit file that runs as it is\n"
    "  plastica calibrate fit.toml -o fit.h5   fit every target\n"
    "  plastica show fit.h5                    the report\n"
    "  plastica plot fit.h5 -o fit.svg         the picture\n"
    "Exit codes: 0 done, 1 a target has no usable fit, 2 bad input, 3 the machine failed.\n"
    "`plastica COMMAND --help` says more.";

void add_commands(CLI::App& app, const std::string& command_line, Action& action) {
  plastica::cli::add_calibrate(app, command_line, action);
  plastica::cli::add_inspect(app, action);
  plastica::cli::add_init(app, action);
  plastica::cli::add_simulate(app, action);
  plastica::cli::add_show(app, action);
  plastica::cli::add_plot(app, action);
  plastica::cli::add_export(app, action);
  plastica::cli::add_fields(app, action);
}

int complain(std::string_view what, int code) {
  fmt::print(stderr, "plastica: {}\n", what);
  return code;
}

int run(int argc, char** argv) {
  CLI::App app{"Plastica: fits yield stress and break strain of lumped beams to measured curves",
               "plastica"};
  app.set_version_flag("--version", std::string(plastica::version()));
  app.require_subcommand(1);
  app.footer(kFooter);
  std::string command_line;
  for (int i = 0; i < argc; ++i) command_line += (i == 0 ? "" : " ") + std::string(argv[i]);
  Action action;
  add_commands(app, command_line, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain(std::string(error.what()) + " (see plastica --help)", plastica::cli::kBadInput);
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const plastica::InputError& error) {
    return complain(error.what(), plastica::cli::kBadInput);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", plastica::cli::kMachineFailed);
  } catch (const std::exception& error) {
    return complain(error.what(), plastica::cli::kMachineFailed);
  }
}
