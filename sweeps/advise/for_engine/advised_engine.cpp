#include "sweeps/advise/for_engine/advised_engine.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/hinge_numbers.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::array<AdvisedEngine, 2> kEngines{{
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
     .load_note = "loads are not in the file: add them before each step, at the present pose "
                  "(addLinkForce, addLinkTorque)",
     .gravity_note =
         "gravity has a history, and is constant in the file: call setGravity before each step",
     .clamp_note = "the clamp turns, and stands still in the file: give AddSprings its angle "
                   "before each step"},
}};

}  // namespace

std::span<const AdvisedEngine> advised_engines() { return kEngines; }

const AdvisedEngine* advised_engine(std::string_view word) {
  const auto* const found = std::ranges::find(kEngines, word, &AdvisedEngine::word);
  return found == kEngines.end() ? nullptr : &*found;
}

}  // namespace plastica::sweeps
