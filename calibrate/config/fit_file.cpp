#include "calibrate/config/fit_file.hpp"

#include <filesystem>
#include <utility>

#include "calibrate/config/read_fit_options.hpp"
#include "calibrate/config/read_parameters.hpp"
#include "calibrate/config/read_target.hpp"
#include "calibrate/config/target_files.hpp"
#include "calibrate/config/unique_names.hpp"
#include "calibrate/target/plausibility.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;

/// A modulus that the fit holds fixed is also that of the characteristics, unless the target says
/// otherwise: a proof stress should not be found with another one.
void use_fixed_modulus(const std::vector<Parameter>& parameters, TargetBlock& block) {
  const auto wanted = block.source.test == Deformation::Torsion ? MaterialField::ShearModulus
                                                                : MaterialField::YoungsModulus;
  const TargetOptions& options = block.options;
  if (options.youngs_modulus || options.modulus_window) return;
  for (const Parameter& parameter : parameters) {
    if (parameter.field->material == wanted && parameter.role == ParameterRole::Fixed) {
      block.options.youngs_modulus = parameter.value;
    }
  }
}

/// A rate of the tests moves nothing in a material without a law of it.
void check_rate(const TomlTable& table, const TargetSource& source, const Material& material) {
  if (!source.strain_rate || material.rate.law != RateLaw::None) return;
  throw InputError(source.strain_rate->where, table.key() + ".strain_rate", "",
                   "is of no use without a law, material.rate.law: it would move nothing");
}

std::vector<TargetBlock> read_targets(const TomlTable& root, const std::string& folder,
                                      const FitOptions& fit) {
  const std::vector<Parameter>& parameters = fit.parameters;
  TargetBlock defaults;
  if (material_gives(root, "youngs_modulus")) {
    defaults.options.expected_modulus = fit.setup.scene.material.youngs_modulus;
  }
  if (const auto table = root.find_table("target_defaults")) {
    read_target(*table, folder, defaults);
  }
  const std::vector<TomlTable> tables = root.find_tables("target");
  if (tables.empty()) {
    root.check_unused();
    throw InputError({root.where().file, 0}, "target", "",
                     "is missing: a fit needs at least one [[target]]");
  }
  std::vector<TargetBlock> blocks;
  for (const TomlTable& table : tables) {
    TargetBlock block = defaults;
    block.source.where = table.where();
    read_target(table, folder, block);
    block.source.files = target_files(table, folder);
    table.check_unused();
    check_target(table, block.source);
    check_rate(table, block.source, fit.setup.scene.material);
    check_material_is_given(root, parameters, block.source.test);
    use_fixed_modulus(parameters, block);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace

FitFile parse_fit_file(std::string text, const std::string& path) {
  const auto document = io::TomlDocument::parse(std::move(text), path);
  const TomlTable& root = document.root();
  const std::string folder = std::filesystem::path(path).parent_path().string();
  FitFile file{path, document.text(), read_fit_options(root), {}, {}};
  io::refuse_rules_of_chains(root);
  file.targets = read_targets(root, folder, file.options);
  root.check_unused();
  io::check_section_is_whole(root, file.options.setup);
  file.notes = root.notes();
  return file;
}

FitFile read_fit_file(const std::string& path) {
  return parse_fit_file(io::TomlDocument::read(path).text(), path);
}

std::vector<Target> import_all(const FitFile& file, int threads,
                               const std::shared_ptr<CurveSpool>& spool) {
  std::vector<Target> targets;
  UniqueNames names;
  for (const TargetBlock& block : file.targets) {
    std::vector<Target> imported = import_targets(block.source, block.options, threads, spool);
    check_groups(imported, block.options);
    for (Target& target : imported) {
      target.name = names.add(target.name);
      targets.push_back(std::move(target));
    }
  }
  return targets;
}

}  // namespace plastica::calibrate
