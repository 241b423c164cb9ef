#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

#include "calibrate/problem/law.hpp"
#include "calibrate/problem/parameter.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/check/claim.hpp"
#include "sweeps/check/read_limits.hpp"
#include "sweeps/compare/comparison.hpp"
#include "sweeps/plan/read_axes.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

std::string file_of(const TomlValue& name, const std::string& check_path) {
  const auto path = std::filesystem::path(check_path).parent_path() / name.string();
  if (!io::is_file(path)) {
    throw name.error("is not a file in the folder of " + check_path + io::why_no_file(path));
  }
  return path.lexically_normal().string();
}

void read_stability(const TomlTable& scan, Claim& claim) {
  stability::StabilityOptions& options = claim.scan.emplace();
  if (const auto only = scan.find("only")) options.only = only->strings();
  if (const auto sample = scan.find("sample")) {
    options.sample = static_cast<std::size_t>(sample->integer(0, 1'000'000));
  }
  if (const auto seed = scan.find("seed")) {
    options.seed = static_cast<std::uint64_t>(seed->integer(0, 1'000'000'000));
  }
  if (const auto work = scan.find("max_work")) {
    options.max_segment_steps = work->number_within(0.0, 1e9, true);
  }
}

void read_only(const TomlTable& where, const std::string& prefix, const Sweep& sweep,
               Claim& claim) {
  for (const std::string& key : where.keys()) {
    const TomlValue value = where.at(key);
    if (value.is_table()) {
      read_only(value.table(), prefix + key + ".", sweep, claim);
      continue;
    }
    const std::string path = value.new_path(prefix + key);
    const auto axis = std::find_if(sweep.axes.begin(), sweep.axes.end(),
                                   [&](const Axis& a) { return a.field->path == path; });
    if (axis == sweep.axes.end()) throw value.error("is not the field of an axis of the sweep");
    std::vector<FieldValue> wanted;
    for (const TomlValue& one : value.is_array() ? value.array() : std::vector{value}) {
      wanted.push_back(read_field_value(one, *axis->field, sweep.setup));
      if (std::find(axis->values.begin(), axis->values.end(), wanted.back()) ==
          axis->values.end()) {
        throw one.error("is not a value of the axis");
      }
    }
    claim.only.emplace_back(static_cast<std::size_t>(axis - sweep.axes.begin()), std::move(wanted));
  }
}

/// How many cases a claim is about.
std::size_t chosen_cases(const Sweep& sweep, const Claim& claim) {
  const CaseTable cases(sweep);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::vector<std::size_t> at = cases.position(i);
    const bool chosen = std::all_of(claim.only.begin(), claim.only.end(), [&](const auto& wanted) {
      const FieldValue& value = sweep.axes[wanted.first].values[at[wanted.first]];
      return std::find(wanted.second.begin(), wanted.second.end(), value) != wanted.second.end();
    });
    count += chosen ? 1 : 0;
  }
  return count;
}

/// Which fits a claim is about, and what of them.
void read_fits(const TomlTable& table, const FitSubject& fits, Claim& claim) {
  if (const auto cases = table.find("case")) {
    claim.cases = cases->strings();
    const std::vector<std::string> names = fits.names();
    for (const std::string& name : claim.cases) {
      if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw cases->error("is no fit of " + fits.path);
      }
    }
  }
  if (const auto law = table.find("law")) {
    claim.law = calibrate::law_names()[law->word(calibrate::law_names())];
  }
  const auto parameter = table.find("parameter");
  const auto truth = table.find("truth");
  const bool of_parameter = claim.kind == ClaimKind::Value || claim.kind == ClaimKind::Error ||
                            claim.kind == ClaimKind::Interval;
  if (!of_parameter && parameter) throw parameter->error("goes with value, error or interval");
  if (truth && claim.kind != ClaimKind::Error) throw truth->error("goes with error");
  if (!of_parameter) return;
  const TomlValue name = table.at("parameter");
  try {
    const Field& field = find_field(name.string());
    claim.parameter = field.path;
    claim.dimension = field.dimension;
  } catch (const InputError& error) {
    throw name.error(error.rule());
  }
  if (claim.kind != ClaimKind::Error) return;
  claim.truth = table.at("truth").quantity(claim.dimension);
  if (claim.truth == 0.0) throw truth->error("must not be 0: the error is a fraction of it");
}

/// A sweep without axes: the scene's own run, and what of it is claimed.
Sweep read_scene(const TomlTable& table, const std::string& path, const Claim& claim) {
  Sweep scene;
  scene.path = table.where().file;
  scene.scene = io::read_scene_file(path);
  scene.name = path;
  scene.setup = scene.scene.setup;
  scene.notes = scene.scene.notes;
  prepare(scene.setup.scene, scene.setup.solver);  // refuses what cannot run
  const bool of_quantity = claim.kind == ClaimKind::Value || claim.kind == ClaimKind::Error;
  if (!of_quantity) {
    scene.quantity.kind = QuantityKind::EnergyBalanceError;
    return scene;
  }
  read_compared(table, scene);
  if (scene.quantity.kind == QuantityKind::Fit) {
    throw table.at("quantity").error("is none of a scene's own: name the fit file by fit");
  }
  if (claim.kind == ClaimKind::Value && scene.quantity.is_curve()) {
    throw table.at("take").error("is no number; a value is one");
  }
  check_reference(scene, CaseTable(scene));
  return scene;
}

/// Reads the claims of a file one after another.
class CheckReader {
 public:
  CheckReader(std::string path, const std::function<void(const std::string&)>& before_result)
      : before_result_(before_result) {
    file_.path = std::move(path);
  }

  void read(const TomlTable& table) {
    Claim claim;
    claim.where = table.where();
    claim.name = table.at("name").string();
    const auto [earlier, is_first] = names_.emplace(claim.name, claim.where.line);
    if (!is_first) {
      throw table.at("name").error("is the name of the claim in line " +
                                   std::to_string(earlier->second) + ": each has its own");
    }
    read_subject(table, claim);
    file_.claims.push_back(std::move(claim));
  }

  CheckFile file() && { return std::move(file_); }

 private:
  /// Whose claim it is, and all that it says of it.
  void read_subject(const TomlTable& table, Claim& claim) {
    constexpr std::array<std::string_view, 5> kKeys{"sweep", "scene", "fit", "result", "stability"};
    std::optional<TomlValue> named;
    for (const std::string_view key : kKeys) {
      const auto found = table.find(key);
      if (!found) continue;
      if (named) throw found->error("is a second one that the claim is about");
      named = found;
      if (key == "sweep") read_sweep(table, *found, claim);
      if (key == "scene") read_scene_claim(table, *found, claim);
      if (key == "fit" || key == "result") read_fit_claim(table, *found, key == "result", claim);
      if (key != "stability") continue;
      claim.subject = ClaimSubject::Scan;
      read_stability(found->table(), claim);
      read_claim_kind(table, claim);
      read_limits(table, nullptr, claim);
      const std::size_t sample = claim.scan->sample;
      refuse_sure(table, claim, sample > 0 ? sample : std::numeric_limits<std::size_t>::max());
    }
    if (!named) {
      throw InputError(table.where(), table.key(), "",
                       "is about nothing: it needs one of sweep, scene, fit, result, stability");
    }
  }

  void read_sweep(const TomlTable& table, const TomlValue& name, Claim& claim) {
    const std::string of = file_of(name, file_.path);
    const auto [place, is_new] = sweeps_.emplace(of, file_.sweeps.size());
    if (is_new) {
      file_.sweeps.push_back(read_sweep_file(of));
      check_reference(file_.sweeps.back(), CaseTable(file_.sweeps.back()));
      add_notes(file_.sweeps.back().notes);
    }
    claim.of = place->second;
    const Sweep& sweep = file_.sweeps[claim.of];
    read_claim_kind(table, claim);
    read_limits(table, &sweep, claim);
    if (const auto where = table.find_table("where")) read_only(*where, "", sweep, claim);
    refuse_sure(table, claim, chosen_cases(sweep, claim));
  }

  void read_scene_claim(const TomlTable& table, const TomlValue& name, Claim& claim) {
    claim.subject = ClaimSubject::Scene;
    const std::string of = file_of(name, file_.path);
    read_claim_kind(table, claim);
    claim.of = file_.scenes.size();
    file_.scenes.push_back(read_scene(table, of, claim));
    if (scenes_.emplace(of, claim.of).second) add_notes(file_.scenes.back().notes);
    read_limits(table, &file_.scenes.back(), claim);
    refuse_sure(table, claim, 1);
  }

  void read_fit_claim(const TomlTable& table, const TomlValue& name, bool is_result, Claim& claim) {
    claim.subject = ClaimSubject::Fit;
    const std::string of = file_of(name, file_.path);
    const auto [place, is_new] = fits_.emplace(of, file_.fits.size());
    if (is_new) {
      if (is_result && before_result_) before_result_(of);
      file_.fits.push_back(is_result ? read_fit_result(of) : read_fit_subject(of));
      add_notes(file_.fits.back().notes());
    }
    claim.of = place->second;
    read_claim_kind(table, claim);
    read_fits(table, file_.fits[claim.of], claim);
    read_limits(table, nullptr, claim);
    const std::size_t named = claim.cases.size();
    refuse_sure(table, claim, named > 0 ? named : file_.fits[claim.of].names().size());
  }

  void add_notes(const std::vector<std::string>& notes) {
    file_.notes.insert(file_.notes.end(), notes.begin(), notes.end());
  }

  const std::function<void(const std::string&)>& before_result_;
  CheckFile file_;
  std::map<std::string, std::size_t> sweeps_;  ///< by path, as the next two
  std::map<std::string, std::size_t> scenes_;
  std::map<std::string, std::size_t> fits_;
  std::map<std::string, int> names_;
};

}  // namespace

CheckFile read_check_file(const std::string& path,
                          const std::function<void(const std::string&)>& before_result) {
  const io::TomlDocument document = io::TomlDocument::read(path);
  CheckReader reader(path, before_result);
  for (const TomlTable& table : document.root().find_tables("claim")) reader.read(table);
  document.root().check_unused();
  CheckFile file = std::move(reader).file();
  const std::vector<std::string>& own = document.root().notes();
  file.notes.insert(file.notes.end(), own.begin(), own.end());
  if (file.claims.empty()) throw InputError({path, 0}, "claim", "", "is missing: nothing to check");
  file.text = document.text();
  return file;
}

std::vector<io::InputText> input_texts(const CheckFile& file) {
  std::vector<io::InputText> all;
  const auto name_of = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const auto add = [&](const std::vector<io::InputText>& texts) {
    for (const io::InputText& text : texts) {
      const auto is_same = [&](const io::InputText& one) {
        return one.name == text.name && one.text == text.text;
      };
      if (std::ranges::none_of(all, is_same)) all.push_back(text);
    }
  };
  add({{name_of(file.path), file.text}});
  for (const Sweep& sweep : file.sweeps) add(sweep.inputs);
  for (const Sweep& scene : file.scenes) add({{name_of(scene.scene.path), scene.scene.text}});
  for (const FitSubject& fits : file.fits) {
    if (fits.curves) add(input_texts(*fits.curves));
    if (fits.scenes) add(fits.scenes->inputs);
  }
  return all;
}

}  // namespace plastica::sweeps
