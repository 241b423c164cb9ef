#include "calibrate/config/fit_file.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "calibrate/config/read_fit_options.hpp"
#include "calibrate/config/read_parameters.hpp"
#include "calibrate/config/read_target.hpp"
#include "calibrate/config/target_files.hpp"
#include "calibrate/config/unique_names.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "calibrate/target/group_values.hpp"
#include "calibrate/target/plausibility.hpp"
#include "plastica/io/csv.hpp"
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

/// What [target_defaults] says, over what the material does.
TargetBlock read_defaults(const TomlTable& root, const std::string& folder, const FitOptions& fit) {
  TargetBlock defaults;
  if (material_gives(root, "youngs_modulus")) {
    defaults.options.expected_modulus = fit.setup.scene.material.youngs_modulus;
  }
  if (const auto table = root.find_table("target_defaults")) {
    read_target(*table, folder, defaults);
  }
  return defaults;
}

/// Refuses what says where curves are, of curves that a program has.
void check_has_no_columns(const TomlTable& root) {
  const auto table = root.find_table("target_defaults");
  for (const std::string_view key : {"strain", "elongation", "gauge_length", "stress", "force",
                                     "area", "table", "group", "split"}) {
    const auto value = table ? table->find(key) : std::nullopt;
    if (value) throw value->error("is for files: these curves are given as they are");
  }
}

std::vector<TargetBlock> read_targets(const TomlTable& root, const std::string& folder,
                                      const FitOptions& fit) {
  const std::vector<Parameter>& parameters = fit.parameters;
  const TargetBlock defaults = read_defaults(root, folder, fit);
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

/// Reads a fit file. @param read_blocks  its targets, from its root and options
template <class ReadBlocks>
FitFile parse_with(std::string text, const std::string& path, const ReadBlocks& read_blocks) {
  const auto document = io::TomlDocument::parse(std::move(text), path);
  const TomlTable& root = document.root();
  FitFile file{path, document.text(), read_fit_options(root), {}, {}};
  io::refuse_rules_of_chains(root);
  file.targets = read_blocks(root, file.options);
  root.check_unused();
  io::check_section_is_whole(root, file.options.setup);
  file.notes = root.notes();
  return file;
}

}  // namespace

FitFile parse_fit_file(std::string text, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return parse_with(std::move(text), path, [&](const TomlTable& root, const FitOptions& options) {
    return read_targets(root, folder, options);
  });
}

FitFile parse_curve_options(std::string text, const std::string& name) {
  return parse_with(std::move(text), name, [](const TomlTable& root, const FitOptions& options) {
    TargetBlock block = read_defaults(root, {}, options);
    check_has_no_columns(root);
    check_rate(root, block.source, options.setup.scene.material);
    check_material_is_given(root, options.parameters, block.source.test);
    use_fixed_modulus(options.parameters, block);
    return std::vector<TargetBlock>{std::move(block)};
  });
}

FitFile read_fit_file(const std::string& path) {
  return parse_fit_file(io::TomlDocument::read(path).text(), path);
}

std::vector<const TableSource*> tables_of(const FitFile& file) {
  std::vector<const TableSource*> tables;
  for (const TargetBlock& block : file.targets) {
    if (!block.source.table) continue;
    const TableSource& own = *block.source.table;
    const auto is_same = [&](const TableSource* other) {
      return other->file == own.file && other->csv.sheet == own.csv.sheet &&
             other->csv.path == own.csv.path;
    };
    if (std::ranges::none_of(tables, is_same)) tables.push_back(&own);
  }
  return tables;
}

std::vector<io::InputText> input_texts(const FitFile& file) {
  const std::string name = file.path.empty() ? "command-line.toml"
                                             : std::filesystem::path(file.path).filename().string();
  std::vector<io::InputText> texts{{name, file.text}};
  for (const TableSource* table : tables_of(file)) {
    texts.push_back({std::filesystem::path(table->file).filename().string(),
                     io::table_text(table->file, table->csv)});
  }
  return texts;
}

namespace {

constexpr const char* kReadTwice = ", too: two [[target]] blocks read it, and it counts twice";

/// Columns of one file may be two curves; one that is read twice counts twice in its group.
void warn_of_same_curve(const Target& first, Target& target) {
  const Characteristics& a = first.characteristics;
  const Characteristics& b = target.characteristics;
  const bool is_same = a.rm && a.rm == b.rm && a.strain_at_rm == b.strain_at_rm;
  if (first.file != target.file || !is_same) return;
  target.warnings.push_back("its curve is that of " + first.name + kReadTwice);
}

/// A copy under another name counts twice as well.
void warn_of_copies(std::span<Target> targets) {
  std::unordered_map<std::uint64_t, const Target*> first_of;  // by the digest of its curve
  first_of.reserve(targets.size());
  for (Target& target : targets) {
    if (target.status != TargetStatus::Ready) continue;
    const auto [first, is_new] = first_of.emplace(digest_of(target.raw), &target);
    if (is_new || first->second->file == target.file) continue;
    const auto path = [](const Target& of) { return std::filesystem::weakly_canonical(of.file); };
    const bool is_same = path(*first->second) == path(target);
    target.warnings.push_back(
        "its curve is that of " + first->second->name +
        (is_same ? kReadTwice : ", too, in another file: a copy counts twice"));
  }
}

}  // namespace

std::vector<Target> import_all(const FitFile& file, int threads,
                               const std::shared_ptr<CurveSpool>& spool) {
  std::vector<Target> targets;
  UniqueNames names;
  GroupValues groups;
  std::map<std::string, std::size_t> first_of;  // by the name before it is made unique
  for (const TargetBlock& block : file.targets) {
    std::vector<Target> imported = import_targets(block.source, block.options, threads, spool);
    groups.unite(imported);
    check_groups(imported, block.options);
    targets.reserve(targets.size() + imported.size());
    for (Target& target : imported) {
      const auto [first, is_new] = first_of.emplace(target.name, targets.size());
      target.name = names.add(target.name);
      if (!is_new) warn_of_same_curve(targets[first->second], target);
      targets.push_back(std::move(target));
    }
  }
  warn_of_copies(targets);
  return targets;
}

}  // namespace plastica::calibrate
