#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/plan/fit_plan.hpp"
#include "sweeps/plan/quantity.hpp"

namespace plastica::sweeps {

/// What an axis moves, and the values that it takes.
struct Axis {
  const Field* field = nullptr;  ///< of scene, solver, or `derived_fields`
  /// In the order of the file; of a sampled axis, by sample. Monostate: an optional field is unset.
  std::vector<FieldValue> values{};
  /// Axes with the same word, and all sampled ones, move together; empty: crossed with the others.
  std::string group{};
  bool sampled = false;  ///< whether a sample has drawn its values
  /// Whether each value has a reference of its own though the field refines: `error.apart`.
  bool apart = false;
  SourceLocation where{};
};

/// What cases are compared with.
enum class AgainstKind { Nothing, Theory, File, Value, Finest, Richardson };

struct Against {
  AgainstKind kind = AgainstKind::Nothing;
  std::string name{};  ///< of the theory, or path of the file
  double value = 0.0;  ///< Value: in SI
  /// File: a curve of the probe (n_samples).
  std::vector<double> time{};
  std::vector<double> curve{};
};

/// A sweep: a scene, what is varied in it, and what is compared.
struct Sweep {
  std::string name;
  std::string path;  ///< of its file, as the user gave it
  io::SceneFile scene;
  Setup setup;  ///< of the scene, as its file has it
  /// What [set] fixes for all cases, as axes of one value; then [[axis]], the first one the
  /// slowest.
  std::vector<Axis> axes;
  Quantity quantity;
  Against against;
  /// Errors are differences over this [SI of the quantity]; empty: over the reference.
  std::optional<double> error_scale{};
  /// Number of the axis that refines the discretization; empty: none.
  std::optional<std::size_t> refined{};
  std::optional<FitPlan> fit{};  ///< of each case, where the quantity is one of a fit
  int timed_runs = 0;  ///< of a case, after one to warm up; 0: it is run once and not timed
  std::vector<io::InputText> inputs;  ///< sweep file, scene, reference
  /// For the user: old names in these, each with the new one; repairs of what is fitted.
  std::vector<std::string> notes{};
};

/// A sweep's cases: all combinations of its axes, in the order of the axes, with groups of axes
/// moving together.
class CaseTable {
 public:
  explicit CaseTable(const Sweep& sweep);

  std::size_t size() const { return size_; }
  /// Position of a case on each axis: numbers of the axes' values (n_axes).
  std::vector<std::size_t> position(std::size_t index) const;
  /// The setup of a case. @throws InputError if the values do not go together
  Setup setup(std::size_t index) const;
  /// 16 hexadecimal digits, made of all that decides the case's result: the scene's content, the
  /// quantity, the library's version and instruction set. Two cases that come to the same have the
  /// same id.
  std::string id(std::size_t index) const;

 private:
  /// Axes that move together.
  struct Wheel {
    std::vector<std::size_t> axes;
    std::size_t length = 1;
  };

  const Sweep& sweep_;
  std::vector<Wheel> wheels_;
  std::size_t size_ = 1;
  std::uint64_t common_digest_ = 0;
};

/// Most cases that a sweep may have.
inline constexpr std::size_t kMaxCases = 10'000'000;

/// Reads a sweep file and the scene that it names; see docs/file-formats.md for the keys.
/// @throws InputError for the first thing that is wrong, unknown keys included
Sweep read_sweep_file(const std::string& path);
/// @param name  stands for the file in errors; its folder is where relative paths begin
Sweep parse_sweep(std::string text, std::string name);

/// A value as tables show it: "32", "0.001 s", "half_joint", "unset".
std::string value_text(const Field& field, const FieldValue& value);

}  // namespace plastica::sweeps
