#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/coupon/shape.hpp"
#include "plastica/model/field.hpp"
#include "plastica/model/material_field.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

struct ChainModel;
class ChainProgram;

/// A checked scene, laid out for `run`. Made by `prepare`; never changes, so that threads share it.
struct Model {
  Level level = Level::Coupon;
  std::string level_reason;  ///< why this level was chosen, for the report
  coupon::CouponShape coupon;
  HardeningLaw hardening = HardeningLaw::Ideal;  ///< of the scene's own material
  std::shared_ptr<const ChainModel> chain;       ///< of a beam with supports; else empty
  MaterialValues<double> material{};             ///< numbers that are not parameters stay at these
  std::vector<const Field*> parameters;          ///< fields that `run` is given, in order
  std::vector<double> drive;                     ///< strain at each sample [1] (n_samples)
  std::vector<ProbeQuantity> probes;             ///< what to record (n_probes)
  BreakPolicy on_break = BreakPolicy::CutAll;
};

/// Whether it runs in time, and not along a path of equilibria or as a coupon.
bool is_motion(const Model& model);

/// Values of a model's parameters in SI, in the order of `Model::parameters` (n_parameters).
using ParameterValues = std::span<const double>;

struct DeleteProgram {
  void operator()(ChainProgram* program) const;
};

/// Memory that `run` works in for one model; one a thread. A coupon needs none.
struct Workspace {
  std::shared_ptr<const ChainModel> model;  ///< that it was made for, kept alive; empty: a coupon
  std::unique_ptr<ChainProgram, DeleteProgram> chain;
  BreakListener on_break;  ///< of a motion; may be empty
  /// Of a path or motion: told the time after each step [s], may be empty. Returning false ends
  /// the run with Status::Interrupted.
  std::function<bool(double time)> on_progress;
  /// Once raised, by any thread, a path or motion ends before its next step with
  /// Status::Interrupted. May be null. A path that it ends has no shape of its last sample where
  /// fewer frames than samples are kept.
  StopFlag stop = nullptr;
};

}  // namespace plastica
