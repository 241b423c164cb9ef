#include "sweeps/advise/for_engine/engine_advice_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "calibrate/engine/hinge_numbers.hpp"
#include "sweeps/advise/advice_text.hpp"

namespace plastica::sweeps {
namespace {

std::string why_no_setting(const EngineAdvice& advice) {
  switch (advice.end) {
    case EngineAdviceEnd::NoReference: return "no run of ours came close enough to compare with";
    case EngineAdviceEnd::Interrupted: return "interrupted";
    case EngineAdviceEnd::TooManyRuns: return "not in the runs that are allowed (--max-runs)";
    case EngineAdviceEnd::TooMuchWork: return "not for the work that is allowed (--max-work)";
    case EngineAdviceEnd::AtLimit:
    case EngineAdviceEnd::Found: break;
  }
  const AdvisedEngine& engine = *advice.engine;
  if (advice.setting.segments >= engine.most_segments) {
    return fmt::format("not with {} segments, {}", engine.most_segments, engine.limit);
  }
  return fmt::format(
      "more segments and shorter steps do not help ({}'s joints neither stretch nor shear)",
      engine.word);
}

std::string setting_text_of(int segments, double time_step, EngineDamping damping) {
  std::string text = fmt::format("{} segments, step {:.6g} s", segments, time_step);
  if (damping == EngineDamping::None) text += ", no damping";
  if (damping == EngineDamping::Numerical) text += ", numerical damping";
  return text;
}

std::string engine_line(std::string_view what, const std::string& value) {
  return fmt::format("  {:<16} = {}", what, value);
}

std::string_view damping_remark(const AdvisedEngine& engine, EngineDamping damping) {
  switch (damping) {
    case EngineDamping::Scene: return engine.scene_damping;
    case EngineDamping::None: return "none, as in the scene";
    case EngineDamping::Numerical: break;
  }
  return "a tenth of the step times the stiffness, numerical: the scene has none";
}

/// The numbers of an inner joint about x, y and z.
std::string joint_lines(const EngineAdvice& advice) {
  const calibrate::EngineBeam& beam = advice.beam;
  const auto inner = std::ranges::find_if(
      beam.joints, [](const calibrate::EngineJoint& joint) { return joint.parent.has_value(); });
  if (inner == beam.joints.end()) return {};
  std::array<double, 3> damping{};
  std::array<double, 3> armature{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto hinge = calibrate::hinge_numbers(advice.engine->hinges, beam, *inner, k);
    damping[k] = hinge.damping;
    armature[k] = hinge.armature;
  }
  const auto three = [](const std::array<double, 3>& v) {
    return fmt::format("{:.6g}, {:.6g}, {:.6g}", v[0], v[1], v[2]);
  };
  std::string text = engine_line("joint stiffness", three(inner->stiffness)) +
                     "  N m/rad, about x, y, z of " + inner->name + "\n" +
                     engine_line("joint damping", three(damping)) + "  N m s/rad, " +
                     std::string(damping_remark(*advice.engine, advice.setting.damping)) + "\n";
  if (armature == std::array<double, 3>{}) return text;
  return text + engine_line("joint armature", three(armature)) + "  kg m^2, for this step\n";
}

std::string setting_lines(const EngineAdvice& advice) {
  std::string text = engine_line("segments", std::to_string(advice.setting.segments));
  const bool found = advice.end == EngineAdviceEnd::Found;
  if (found)
    text += fmt::format("  twice as many move it by {}", error_percent(advice.by_segments));
  text += '\n' + engine_line("step", fmt::format("{:.6g} s", advice.time_step));
  if (found) text += fmt::format("  half of it moves it by {}", error_percent(advice.by_steps));
  return text + '\n' + joint_lines(advice);
}

std::string tried_text(const TriedEngineSetting& one) {
  std::string text =
      setting_text_of(one.setting.segments, one.time_step, one.setting.damping) + "\n  ";
  text += std::isfinite(one.error) ? "error " + error_percent(one.error) : "no error";
  if (!one.reason.empty()) text += fmt::format(" ({})", one.reason);
  return text + fmt::format(", {} segment-steps\n", one.work);
}

}  // namespace

std::string engine_advice_text(const EngineAdvice& advice, const AdviceOptions& options,
                               const std::string& name) {
  if (advice.end == EngineAdviceEnd::NoReference && !advice.reason.empty()) {
    return fmt::format("{} for {}: nothing to compare with: our own run with {}: {}\n", name,
                       advice.engine->word, advice.reference_setting, advice.reason);
  }
  if (advice.end == EngineAdviceEnd::NoReference) {
    AdviceOptions ours = options;
    ours.within = kReferenceShare * options.within;
    return fmt::format("{} for {}: nothing within {}: {}\n", name, advice.engine->word,
                       error_percent(options.within), why_no_setting(advice)) +
           advice_text(advice.reference, ours, name);
  }
  if (advice.end != EngineAdviceEnd::Found) {
    std::string text = fmt::format("{} for {}: nothing within {}: {}", name, advice.engine->word,
                                   error_percent(options.within), why_no_setting(advice));
    if (advice.time_step == 0.0) return text + '\n';
    return text + "; the last setting:\n" + setting_lines(advice) +
           fmt::format("  it is {} off our own run with {}\n", error_percent(advice.error),
                       advice.reference_setting);
  }
  std::string text = fmt::format("{} for {}, within {}:\n", name, advice.engine->word,
                                 error_percent(options.within)) +
                     setting_lines(advice);
  text += fmt::format("  error {} against our own run with {}\n", error_percent(advice.error),
                      advice.reference_setting);
  text += fmt::format("  which is within {} itself: at most {} in all\n",
                      error_percent(advice.reference_error), error_percent(advice.promised));
  if (!advice.worst.empty()) text += fmt::format("  the largest is of {}\n", advice.worst);
  text += fmt::format("  cost {} segment-steps\n", advice.work);
  if (advice.next_cheaper) {
    text += "next cheaper, not within: " + tried_text(*advice.next_cheaper);
  }
  if (advice.cut_short) {
    text += "the search was cut short (--max-runs, --max-work): others may be cheaper\n";
  }
  text += fmt::format("the advice took {} runs of ours and {} by {}'s rule\n",
                      advice.reference.runs, advice.runs, advice.engine->name);
  for (const std::string& note : advice.notes) text += fmt::format("note: {}\n", note);
  for (const std::string& probe : advice.left_out) {
    text += fmt::format(
        "note: {} is not looked at: it is given, an error, or nothing that an "
        "engine has\n",
        probe);
  }
  return text;
}

}  // namespace plastica::sweeps
