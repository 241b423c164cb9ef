#pragma once

#include <span>
#include <string_view>

namespace plastica::calibrate {
enum class EngineFormat;
enum class HingeEngine;
}  // namespace plastica::calibrate

namespace plastica::sweeps {

/// In which coordinates an engine steps a beam.
enum class EngineRule {
  Hinges,  ///< turns of hinges: `HingeChain`
  Bodies,  ///< free bodies, which constraints hold: `BodyChain`
};

/// An engine that advice can be for: what is said of it, and by which rule it steps.
struct AdvisedEngine {
  std::string_view word{};  ///< of `--for`
  std::string_view name{};
  EngineRule rule = EngineRule::Hinges;
  calibrate::HingeEngine hinges{};
  calibrate::EngineFormat format{};
  std::string_view ending{};  ///< of the beam's file
  int most_segments = 0;
  std::string_view limit{};  ///< what so many segments are
  /// Whether the damping of joints is taken at the end of a step, not at its beginning.
  bool implicit_damping = false;
  /// Whether joints that the scene does not damp may have numerical damping.
  bool damps_numerically = false;
  /// How many times as many steps twice as many segments need to stay stable. Without armature the
  /// highest frequency of a chain grows with the square of its segments; implicit springs do not
  /// mind.
  int steps_of_twice_segments = 1;
  /// Whether the beam has no hinges about axes about which a motion in a plane does not turn: their
  /// springs, which may be stiffer by far, would ask for steps that the motion does not.
  bool holds_what_rests = false;
  double largest = 0.0;             ///< coordinate, speed or acceleration in SI; beyond it gives up
  std::string_view held_against{};  ///< the engine and version that tests run; empty: none
  std::string_view rule_note{};     ///< what to know of the rule; empty: nothing
  /// What the damping of joints is, where the scene has some.
  std::string_view scene_damping = "the scene's";
  // What whoever runs the beam has to do:
  std::string_view load_note{};
  std::string_view gravity_note{};
  std::string_view clamp_note{};
};

/// All of them, in the order in which `--help` has them.
std::span<const AdvisedEngine> advised_engines();

/// That of a word; null for another.
const AdvisedEngine* advised_engine(std::string_view word);

}  // namespace plastica::sweeps
