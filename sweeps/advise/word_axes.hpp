#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "plastica/model/field.hpp"

namespace plastica::sweeps {

/// A way to model or to solve a scene: the word of a field, and of those that go with it.
struct WordChoice {
  /// "rules.yield_model" = "interaction" and "rules.yield_cap" = "fully_plastic"
  std::vector<std::pair<const Field*, std::string>> values{};

  /// "interaction, fully_plastic"
  std::string text() const;
};

/// What the words of an axis are to the error of a result.
enum class WordKind {
  Model,   ///< each has a limit of its own, as numbers are refined; the last is the richest
  Method,  ///< all have one limit
};

/// A word of a scene that advice chooses.
struct WordAxis {
  WordKind kind = WordKind::Model;
  std::vector<WordChoice> choices{};  ///< of models the simplest first
  std::size_t own = 0;                ///< that of the scene's file
  std::size_t richest = 0;            ///< of a model; of a method its own
  std::string note{};  ///< why a richer one is not among them; empty: none is lacking

  const Field& field() const { return *choices.front().values.front().first; }
};

/// The number of a choice on each axis, in their order (n_word_axes).
using Words = std::vector<std::size_t>;

/// The axes of words on which a scene has a choice: words that `check_scene` accepts and that mean
/// the same problem.
/// - `solver.level`: the least that holds all that acts on the beam, and the spatial one.
/// - `solver.translation`: rigid, elastic.
/// - `rules.yield_model` with `rules.yield_cap`, of a scene that may yield: elastic, the scene's
///   own, interaction with the fully plastic cap, fibre. Without fibres (sections given by numbers,
///   Wendelius' formulas) its own is the richest. A scene that its file calls elastic stays so.
/// - `rules.end_rule`: its own, the half joint, half a segment at the ends; with Wendelius'
/// formulas,
///   which refuse the half joint, all others.
/// - `solver.scheme` of a motion: its own and those of second order; of these Newton's only if its
///   own solves once a step.
/// An axis with one choice is none.
std::vector<WordAxis> word_axes(const Setup& setup);

/// The words of a scene's file.
Words own_words(const std::vector<WordAxis>& axes);

/// The scene with words.
Setup setup_with(const Setup& setup, const std::vector<WordAxis>& axes, const Words& words);

/// Whether `check_scene` accepts the scene.
bool is_accepted(const Setup& setup);

/// The order with which the error of a method falls, of the time step or of the segments.
double order_of_method(const Setup& setup, const Field& field);

/// What a segment-iteration costs over one of planar rigid elastic joints [1]: 4 in space, twice
/// that with stretch and shear, and with n fibres 0.03 n more, in space, where they are n across,
/// too, 0.11 n^2; all a tenth with an articulated scheme (docs/speed.md).
double kernel_cost(const Setup& setup);

}  // namespace plastica::sweeps
