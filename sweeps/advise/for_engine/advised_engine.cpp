#include "sweeps/advise/for_engine/advised_engine.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/hinge_numbers.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::array<AdvisedEngine, 3> kEngines{{
    {.word = "mujoco",
     .name = "MuJoCo",
     .hinges = calibrate::HingeEngine::Mujoco,
     .format = calibrate::EngineFormat::Mjcf,
     .ending = ".xml",
     .most_segments = static_cast<int>(calibrate::kMujocoSegments),
     .limit = "the most that mujoco 2 reads",
     .implicit_damping = true,
     .damps_numerically = true,
     // mjMAXVAL: MuJoCo puts a simulation back to its start where anything is beyond.
     .largest = 1e10,
     .held_against = "MuJoCo 2.2.2",
     .load_note = "loads are not in the file: set them before each step, at the present pose "
                  "(mj_step1, mj_applyFT, mj_step2)",
     .gravity_note =
         "gravity has a history, and is constant in the file: set opt.gravity before each step",
     .clamp_note = "the clamp turns, and stands still in the file: set qpos_spring of the first "
                   "joint's hinge to its angle before each step"},
    {.word = "bullet",
     .name = "Bullet",
     .hinges = calibrate::HingeEngine::Bullet,
     .format = calibrate::EngineFormat::Bullet,
     .ending = ".hpp",
     .most_segments = 256,
     .limit = "the most that are looked at",
     .implicit_damping = false,
     .damps_numerically = false,
     .steps_of_twice_segments = 4,
     .holds_what_rests = true,
     .largest = std::numeric_limits<double>::max(),
     .held_against = "Bullet 3.24",
     .load_note = "loads are not in the file: add them before each step, at the present pose "
                  "(addLinkForce, addLinkTorque)",
     .gravity_note =
         "gravity has a history, and is constant in the file: call setGravity before each step",
     .clamp_note = "the clamp turns, and stands still in the file: give AddSprings its angle "
                   "before each step"},
    // Springs and dampers are implicit. None of the runs for the scenes of the tests blew up, at
    // steps of up to a sample: twice as many segments need no more steps, and stiff springs of what
    // rests ask for none. The rule damps every mode by itself, which is what asks for short steps:
    // numerical damping of joints would only add to that.
    {.word = "chrono",
     .name = "Chrono",
     .rule = EngineRule::Bodies,
     .hinges = calibrate::HingeEngine::Chrono,
     .format = calibrate::EngineFormat::Chrono,
     .ending = ".hpp",
     .most_segments = 256,
     .limit = "the most that are looked at",
     .implicit_damping = false,
     .damps_numerically = false,
     .largest = std::numeric_limits<double>::max(),
     .rule_note = "the runs are by Chrono's published rule (release 9, EULER_IMPLICIT_LINEARIZED "
                  "with a direct solver), which was not verified in Chrono itself",
     .scene_damping = "half of the scene's: Chrono's rule counts it twice",
     .load_note = "loads are not in the file: set them before each step, at the present pose "
                  "(EmptyAccumulators, AccumulateForce, AccumulateTorque, then ForceUpdate of the "
                  "system: else they act a step late)",
     .gravity_note = "gravity has a history: call SetGravitationalAcceleration and ForceUpdate of "
                     "the system before each step",
     .clamp_note = "the clamp turns: give TurnGround its angle before each step"},
}};

}  // namespace

std::span<const AdvisedEngine> advised_engines() { return kEngines; }

const AdvisedEngine* advised_engine(std::string_view word) {
  const auto* const found = std::ranges::find(kEngines, word, &AdvisedEngine::word);
  return found == kEngines.end() ? nullptr : &*found;
}

}  // namespace plastica::sweeps
