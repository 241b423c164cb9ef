#include "calibrate/config/scene_fit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "calibrate/config/read_csv_options.hpp"
#include "calibrate/config/read_fit_options.hpp"
#include "calibrate/config/read_intervals.hpp"
#include "calibrate/config/read_parameters.hpp"
#include "calibrate/config/read_scene_abscissa.hpp"
#include "calibrate/config/read_target.hpp"
#include "calibrate/config/read_target_options.hpp"
#include "calibrate/config/target_files.hpp"
#include "calibrate/config/unique_names.hpp"
#include "calibrate/fit/choose_segments.hpp"
#include "calibrate/result/words.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/trial/scene_drive.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/model/numbered_place.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

constexpr int kMaxEvaluations = 1'000'000;
constexpr int kMaxStarts = 10'000;
constexpr int kMaxScreened = 1'000'000;
constexpr int kMaxSegments = 100'000;

/// What the targets of a table have in common.
struct TargetTable {
  WeightedTarget weighted;
  SceneTargetSource source;
};

class Reader {
 public:
  Reader(const io::TomlDocument& document, const std::string& path)
      : root_(document.root()), folder_(std::filesystem::path(path).parent_path().string()) {
    file_.path = path;
    add_input(path, document.text());
  }

  SceneFitFile read() {
    const auto fit = root_.find_table("fit");
    if (!fit) throw InputError({root_.where().file, 0}, "fit", "", "is missing");
    const auto defaults = root_.find("target_defaults");
    if (defaults) throw defaults->error("is for coupons' curves: say it in each [[target]]");
    read_options(*fit);
    const auto shared = fit->find("shared");
    const bool together = !shared || shared->boolean();
    std::size_t number = 0;
    for (const TomlTable& table : root_.find_tables("target")) {
      read_target(table, ++number, together);
    }
    take_segments();
    root_.check_unused();
    add_notes(root_.notes());
    return std::move(file_);
  }

 private:
  void add_input(const std::string& path, std::string text) {
    const std::string name = std::filesystem::path(path).filename().string();
    if (std::find(file_.read_files.begin(), file_.read_files.end(), path) !=
        file_.read_files.end()) {
      return;
    }
    file_.read_files.push_back(path);
    file_.inputs.push_back({name, std::move(text)});
  }

  void add_notes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
      if (std::find(file_.notes.begin(), file_.notes.end(), note) == file_.notes.end()) {
        file_.notes.push_back(note);
      }
    }
  }

  void read_options(const TomlTable& fit) {
    SceneFitOptions& options = file_.options;
    (void)fit.at("parameters");
    options.parameters = read_parameters(fit, ParameterScope::Scene);
    read_objective(fit);
    if (const auto algorithm = fit.find("algorithm")) {
      options.algorithm = algorithm_names()[algorithm->word(algorithm_names())];
      for (const std::string_view key : {"starts", "screen"}) {
        const auto given = options.algorithm != "auto" ? fit.find(key) : std::nullopt;
        if (given) throw given->error("goes with algorithm = \"auto\": any other one goes alone");
      }
    }
    const auto read_integer = [&](std::string_view key, int low, int high, int& value) {
      if (const auto found = fit.find(key)) value = static_cast<int>(found->integer(low, high));
    };
    read_integer("evaluations", 1, kMaxEvaluations, options.evaluations);
    read_integer("starts", 1, kMaxStarts, options.starts);
    read_integer("screen", 0, kMaxScreened, options.screen);
    if (const auto laws = fit.find("laws")) options.laws = read_laws(*laws);
    if (const auto seed = fit.find("seed")) {
      options.seed =
          static_cast<std::uint64_t>(seed->integer(0, std::numeric_limits<std::int64_t>::max()));
    }
    if (const auto segments = fit.find("segments_error")) {
      options.segments_error = segments->boolean();
    }
    read_segments(fit);
    read_intervals(fit, options.intervals);
    if (const auto tolerance = fit.find("tolerance")) {
      options.tolerance = tolerance->number_within(0.0, 1.0, false);
    }
    if (const auto confidence = fit.find("confidence")) {
      options.confidence = confidence->quantity(Dimension::None);
      if (options.confidence <= 0.0 || options.confidence >= 1.0) {
        throw confidence->error("must be above 0 % and below 100 %");
      }
    }
  }

  void read_objective(const TomlTable& fit) {
    const auto objective = fit.find("objective");
    if (!objective) return;
    file_.options.objective = static_cast<Objective>(objective->word(words_of<Objective>()));
  }

  /// `segments` of all beams of the fit, a number or "auto", and what they may do to its values.
  void read_segments(const TomlTable& fit) {
    SceneFitOptions& options = file_.options;
    const auto within = fit.find("within");
    if (within) {
      options.segments_within = within->quantity(Dimension::None);
      if (!(options.segments_within > 0.0 && options.segments_within < 1.0)) {
        throw within->error("must be above 0 % and below 100 %");
      }
      if (!options.segments_error) {
        throw within->error("needs the error of the segments (segments_error)");
      }
    }
    segments_ = fit.find("segments");
    if (!segments_ || !segments_->is_string()) return;
    if (segments_->string() != "auto") throw segments_->error("must be \"auto\" or a number");
    if (!within) {
      throw segments_->error("needs `within`, what the segments may do to a value: \"0.5 %\"");
    }
    file_.chooses_segments = true;
  }

  /// Gives the beams the fit's number of segments.
  void take_segments() {
    if (!segments_) return;
    const int number =
        file_.chooses_segments ? 0 : static_cast<int>(segments_->integer(1, kMaxSegments));
    try {
      for (SceneFitCase& one : file_.cases) {
        // Of "auto" it is only asked whether a number can be given at all.
        std::vector<WeightedTarget> probed = one.targets;
        set_segments(number, file_.chooses_segments ? probed : one.targets);
      }
    } catch (const InputError& error) {
      throw segments_->error(error.rule());
    }
  }

  /// @param number  of the table, from 1 on
  void read_target(const TomlTable& table, std::size_t number, bool together) {
    const TargetTable target = read_table(table);
    for (const std::string& path : target_files(table, folder_)) {
      WeightedTarget weighted = target.weighted;
      SceneTargetSource source = target.source;
      source.file = path;
      weighted.target = read_scene_target(source, weighted.setup.scene, std::move(weighted.target));
      file_.read_files.push_back(path);
      weighted.target.table = number;
      weighted.target.name = names_.add(weighted.target.name);
      if (!together || file_.cases.empty()) {
        const std::string stem = std::filesystem::path(file_.path).stem().string();
        file_.cases.push_back({together ? stem : weighted.target.name, {}});
      }
      warn_of_same_curve(path, weighted.target);
      file_.cases.back().targets.push_back(std::move(weighted));
    }
    table.check_unused();
  }

  /// Columns of one file may be two curves; one that is read twice counts twice.
  void warn_of_same_curve(const std::string& path, SceneTarget& target) {
    auto& known = of_file_[path];
    for (const auto& [of_case, of_target] : known) {
      const SceneTarget& other = file_.cases[of_case].targets[of_target].target;
      if (other.ordinate_probe != target.ordinate_probe || other.ordinate != target.ordinate ||
          other.abscissa != target.abscissa) {
        continue;
      }
      target.warnings.push_back("its curve is that of " + other.name +
                                ", too: two [[target]] blocks read it, and it counts twice");
      return;
    }
    known.emplace_back(file_.cases.size() - 1, file_.cases.back().targets.size());
  }

  TargetTable read_table(const TomlTable& table) {
    TargetTable read;
    WeightedTarget& weighted = read.weighted;
    SceneTarget& target = weighted.target;
    weighted.setup = read_scene(table.at("scene"));
    const Setup as_it_stands = weighted.setup;
    io::read_setup(table, weighted.setup);
    const std::string why =
        why_not_beam(as_it_stands.scene, as_it_stands.solver, weighted.setup.scene);
    if (!why.empty()) throw table.at("beam").error(why);
    refuse_own_segments(table);
    refuse_own_parameters(table);
    const TomlTable abscissa = table.at("abscissa").table();
    const TomlTable ordinate = table.at("ordinate").table();
    read_scene_abscissa(abscissa, target);
    const TomlValue probe = ordinate.at("probe");
    target.ordinate_probe = probe.string();
    target.ordinate_where = probe.where();
    const Dimension x = abscissa_dimension(weighted.setup.scene, target, target.abscissa_where);
    const Dimension y = ordinate_dimension(weighted.setup.scene, target);
    read.source.abscissa = read_column(abscissa, x);
    read.source.ordinate = read_column(ordinate, y);
    target.abscissa_factor = read_factor(abscissa);
    target.ordinate_factor = read_factor(ordinate);
    read_csv_options(table, read.source.csv);
    if (const auto trim = table.find("trim")) read.source.trim = read_choice(*trim, x);
    if (const auto tolerance = table.find("reversal_tolerance")) {
      read.source.reversal_tolerance = tolerance->quantity(x);
      if (*read.source.reversal_tolerance < 0.0) throw tolerance->error("must be at least 0");
    }
    if (const auto noise = table.find("noise")) {
      target.noise = noise->quantity(y);
      if (!(*target.noise > 0.0)) throw noise->error("must be above 0");
    }
    if (const auto weight = table.find("weight")) {
      weighted.weight = weight->number_within(0.0, std::numeric_limits<double>::infinity(), false);
    }
    return read;
  }

  void refuse_own_segments(const TomlTable& target) const {
    if (!segments_) return;
    const auto beam = target.find_table("beam");
    const auto own = beam ? beam->find("segments") : std::nullopt;
    if (own) throw own->error("contradicts fit.segments, which is for all beams of the fit");
  }

  /// What a target says of a parameter would be no more than where a search may begin.
  void refuse_own_parameters(const TomlTable& target) const {
    const auto beam = target.find_table("beam");
    for (const Parameter& parameter : file_.options.parameters) {
      refuse_own(target, parameter.field->path);
      // Material and section may stand in [beam], too.
      if (beam) refuse_own(*beam, parameter.field->path);
    }
  }

  static void refuse_own(const TomlTable& said, std::string_view path) {
    std::optional<TomlTable> table = said;
    for (std::size_t dot = path.find('.'); table && dot != std::string_view::npos;
         dot = path.find('.')) {
      const auto inner = table->find(path.substr(0, dot));
      table = inner && inner->is_table() ? std::optional(inner->table()) : std::nullopt;
      path.remove_prefix(dot + 1);
    }
    const auto own = table ? table->find(path) : std::nullopt;
    if (!own) return;
    throw own->error(
        "is a parameter of the fit, which gives all targets its value: say it in fit.parameters, "
        "or leave it out there");
  }

  Setup read_scene(const TomlValue& value) {
    const auto path = std::filesystem::path(folder_) / value.string();
    if (!io::is_file(path)) {
      throw value.error("is not a file" + (folder_.empty() ? "" : " in " + folder_) +
                        io::why_no_file(path));
    }
    const std::string file = path.lexically_normal().string();
    io::SceneFile scene = io::read_scene_file(file);
    add_input(file, scene.text);
    add_notes(scene.notes);
    return std::move(scene.setup);
  }

  TomlTable root_;
  std::string folder_;
  UniqueNames names_;
  /// Numbers of cases and their targets that were read of a file, each curve once.
  std::map<std::string, std::vector<std::pair<std::size_t, std::size_t>>> of_file_;
  std::optional<TomlValue> segments_;
  SceneFitFile file_;
};

}  // namespace

bool names_scenes(const std::string& path) {
  const auto document = io::TomlDocument::read(path);
  const std::vector<TomlTable> targets = document.root().find_tables("target");
  return std::any_of(targets.begin(), targets.end(),
                     [](const TomlTable& table) { return table.contains("scene"); });
}

SceneFitFile parse_scene_fit_file(std::string text, const std::string& path) {
  return Reader(io::TomlDocument::parse(std::move(text), path), path).read();
}

SceneFitFile read_scene_fit_file(const std::string& path) {
  return parse_scene_fit_file(io::TomlDocument::read(path).text(), path);
}

}  // namespace plastica::calibrate
