#include "sweeps/advise/for_engine/engine_advice_json.hpp"

#include <cstddef>
#include <string_view>
#include <utility>

#include "calibrate/engine/hinge_numbers.hpp"
#include "plastica/report/json_values.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;
using report::number;
using report::text_or_null;

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

Json json_of(const TriedEngineSetting& one) {
  return {{"segments", one.setting.segments},
          {"time_step", one.time_step},
          {"damping", word_of(one.setting.damping)},
          {"error", number(one.error)},
          {"reason", one.reason.empty() ? Json(nullptr) : Json(one.reason)},
          {"segment_steps", one.work}};
}

Json joints_of(const AdvisedEngine& engine, const calibrate::EngineBeam& beam) {
  Json all = Json::array();
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
  const auto if_found = [&](double value) { return found ? number(value) : Json(nullptr); };
  Json tried = Json::array();
  for (const TriedEngineSetting& one : advice.tried) tried.push_back(json_of(one));
  const Json all = {
      {"scene", name},
      {"engine", advice.engine->word},
      {"rule_held_against", text_or_null(advice.engine->held_against)},
      {"end", word_of(advice.end)},
      {"within", options.within},
      {"segments", found ? Json(advice.setting.segments) : Json(nullptr)},
      {"time_step", if_found(advice.time_step)},
      {"damping", found ? Json(word_of(advice.setting.damping)) : Json(nullptr)},
      {"joints", found ? joints_of(*advice.engine, advice.beam) : Json::array()},
      {"error", if_found(advice.error)},
      {"reference_error", if_found(advice.reference_error)},
      {"promised", if_found(advice.promised)},
      {"by_segments", if_found(advice.by_segments)},
      {"by_steps", if_found(advice.by_steps)},
      {"worst", advice.worst.empty() ? Json(nullptr) : Json(advice.worst)},
      {"reference", advice.reference_setting},
      {"segment_steps", found ? Json(advice.work) : Json(nullptr)},
      {"next_cheaper", advice.next_cheaper ? json_of(*advice.next_cheaper) : Json(nullptr)},
      {"notes", advice.notes},
      {"left_out", advice.left_out},
      {"cut_short", advice.cut_short},
      {"reference_runs", advice.reference.runs},
      {"runs", advice.runs},
      {"total_segment_steps", advice.total_work},
      {"tried", std::move(tried)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::sweeps
