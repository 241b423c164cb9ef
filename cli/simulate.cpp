#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "calibrate/store/fit_store.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/run_files.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/storage_error.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::cli {
namespace {

struct SimulateArguments {
  std::string file;
  std::string output = "-";
  bool dry_run = false;
  bool force = false;
};

std::string_view unit_of(ProbeQuantity quantity, Deformation deformation) {
  switch (quantity) {
    case ProbeQuantity::Strain:
    case ProbeQuantity::PlasticStrain:
    case ProbeQuantity::AccumulatedStrain: return "1";
    case ProbeQuantity::Stress: return "Pa";
    case ProbeQuantity::Load: return deformation == Deformation::Tension ? "N" : "N m";
    case ProbeQuantity::Dissipation: return "J/m^3";
    default: break;  // probes of a chain
  }
  return "";
}

/// A column of the driven strain, then one a probe.
void write_table(std::ostream& out, const Scene& scene, const Response& response) {
  out << "sample,drive [1]";
  for (const Probe& probe : scene.probes) {
    out << ',' << probe.name << " [" << unit_of(probe.quantity, scene.drive.deformation) << ']';
  }
  out << '\n';
  for (std::size_t i = 0; i < response.samples; ++i) {
    out << fmt::format("{},{}", i, scene.drive.strain[i]);
    for (const auto& values : response.probes) out << fmt::format(",{}", values[i]);
    out << '\n';
  }
}

int simulate_file(const SimulateArguments& arguments) {
  const Setup setup = io::read_scene_file(arguments.file).setup;
  const Model model = prepare(setup.scene, setup.solver);
  if (arguments.dry_run) {
    fmt::print("{}: {} samples, {} probes, level coupon: {}\n", arguments.file, model.drive.size(),
               model.probes.size(), model.level_reason);
    return kDone;
  }
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.file);
    calibrate::check_output_path(arguments.output, arguments.force);
  }
  const Response response = simulate(setup.scene, setup.solver);
  if (arguments.output == "-") {
    write_table(std::cout, setup.scene, response);
  } else {
    std::ofstream out(arguments.output, std::ios::binary);
    write_table(out, setup.scene, response);
    out.close();
    if (!out) throw io::StorageError(arguments.output, "cannot be written");
  }
  if (response.event) {
    fmt::print(stderr, "broke at sample {}, strain {:.6g}, permanent strain {:.6g}\n",
               response.event->sample, response.event->strain, response.event->permanent_strain);
  }
  if (!usable(response.status)) {
    fmt::print(stderr, "plastica: {}: {}\n", name_of(response.status), advice(response.status));
    return kNotAcceptable;
  }
  return kDone;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("simulate", "one scene, its probes as a table");
  auto arguments = std::make_shared<SimulateArguments>();
  sub->add_option("file", arguments->file, "scene file")->required();
  sub->add_option("-o,--output", arguments->output, "CSV file, or - for the terminal")
      ->capture_default_str();
  sub->add_flag("--dry-run", arguments->dry_run, "only say what would run");
  sub->add_flag("--force", arguments->force, "overwrite the output");
  sub->footer("Example: plastica init scene && plastica simulate scene.toml");
  sub->callback(
      [&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace plastica::cli
