#include "sweeps/advise/for_engine/engine_advice_json.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "calibrate/engine/hinge_numbers.hpp"

namespace plastica::sweeps {
namespace {

using EngineJson = nlohmann::ordered_json;

EngineJson number_or_null(double value) {
  return std::isfinite(value) ? EngineJson(value) : EngineJson(nullptr);
}

std::string_view word_of(EngineAdviceEnd end) {
  switch (end) {
    case EngineAdviceEnd::Found: return "found";
    case EngineAdviceEnd::NoReference: return "no_reference";
    case EngineAdviceEnd::AtLimit: return "at_limit";
    case EngineAdviceEnd::TooManyRuns: return "too_many_runs";
    case EngineAdviceEnd::TooMuchWork: return "too_much_work";
    case EngineAdviceEnd::Interrupted: break;
  }
  return "interrupted";
}

std::string_view word_of(EngineDamping damping) {
  switch (damping) {
    case EngineDamping::Scene: return "scene";
    case EngineDamping::None: return "none";
    case EngineDamping::Numerical: break;
  }
  return "numerical";
}

EngineJson json_of(const TriedEngineSetting& one) {
  return {{"segments", one.setting.segments},
          {"time_step", one.time_step},
          {"damping", word_of(one.setting.damping)},
          {"error", number_or_null(one.error)},
          {"reason", one.reason.empty() ? EngineJson(nullptr) : EngineJson(one.reason)},
          {"segment_steps", one.work}};
}

EngineJson joints_of(const AdvisedEngine& engine, const calibrate::EngineBeam& beam) {
  EngineJson all = EngineJson::array();
  for (const calibrate::EngineJoint& joint : beam.joints) {
    std::array<double, 3> damping{};
    std::array<double, 3> armature{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto hinge = calibrate::hinge_numbers(engine.hinges, beam, joint, k);
      damping[k] = hinge.damping;
      armature[k] = hinge.armature;
    }
    all.push_back({{"name", joint.name},
                   {"stiffness", joint.stiffness},
                   {"damping", damping},
                   {"armature", armature}});
  }
  return all;
}

}  // namespace

std::string engine_advice_json(const EngineAdvice& advice, const AdviceOptions& options,
                               const std::string& name) {
  const bool found = advice.end == EngineAdviceEnd::Found;
  const auto if_found = [&](double value) {
    return found ? number_or_null(value) : EngineJson(nullptr);
  };
  EngineJson tried = EngineJson::array();
  for (const TriedEngineSetting& one : advice.tried) tried.push_back(json_of(one));
  const EngineJson all = {
      {"scene", name},
      {"engine", advice.engine->word},
      {"rule_held_against", advice.engine->held_against.empty()
                                ? EngineJson(nullptr)
                                : EngineJson(advice.engine->held_against)},
      {"end", word_of(advice.end)},
      {"within", options.within},
      {"segments", found ? EngineJson(advice.setting.segments) : EngineJson(nullptr)},
      {"time_step", if_found(advice.time_step)},
      {"damping", found ? EngineJson(word_of(advice.setting.damping)) : EngineJson(nullptr)},
      {"joints", found ? joints_of(*advice.engine, advice.beam) : EngineJson::array()},
      {"error", if_found(advice.error)},
      {"reference_error", if_found(advice.reference_error)},
      {"promised", if_found(advice.promised)},
      {"by_segments", if_found(advice.by_segments)},
      {"by_steps", if_found(advice.by_steps)},
      {"worst", advice.worst.empty() ? EngineJson(nullptr) : EngineJson(advice.worst)},
      {"reference", advice.reference_setting},
      {"segment_steps", found ? EngineJson(advice.work) : EngineJson(nullptr)},
      {"next_cheaper", advice.next_cheaper ? json_of(*advice.next_cheaper) : EngineJson(nullptr)},
      {"notes", advice.notes},
      {"left_out", advice.left_out},
      {"cut_short", advice.cut_short},
      {"reference_runs", advice.reference.runs},
      {"runs", advice.runs},
      {"total_segment_steps", advice.total_work},
      {"tried", std::move(tried)}};
  return all.dump(2, ' ', false, EngineJson::error_handler_t::replace) + '\n';
}

}  // namespace plastica::sweeps
