#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

// All members of each structure. A structured binding names them all or does not compile, so that
// no test can overlook a field that is new.
/// Of a curve that is here: see `with_samples`.
inline auto members(const Curve& v) {
  const auto& [a, b, aside, spool] = v;
  static_cast<void>(spool);
  return std::tie(a, b, aside.samples);
}
inline auto members(const Repair& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const Correction& v) {
  const auto& [a, b, c, d, e] = v;
  return std::tie(a, b, c, d, e);
}
inline auto members(const BreakObservation& v) {
  const auto& [a, b, c, d] = v;
  return std::tie(a, b, c, d);
}
inline auto members(const Characteristics& v) {
  const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = v;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
}
/// All but the last three, which files do not have.
inline auto members(const Target& v) {
  const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, shift_error, ends_at_neck, ran_back] =
      v;
  static_cast<void>(shift_error);
  static_cast<void>(ends_at_neck);
  static_cast<void>(ran_back);
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
}
inline auto members(const Judgement& v) {
  const auto& [a, b] = v;
  return std::tie(a, b);
}
inline auto members(const FittedParameter& v) {
  const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = v;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
}
inline auto members(const OptimizerStage& v) {
  const auto& [a, b, c, d] = v;
  return std::tie(a, b, c, d);
}
inline auto members(const Trace& v) {
  const auto& [a, b, c, d, e] = v;
  return std::tie(a, b, c, d, e);
}
inline auto members(const LikelihoodProfile& v) {
  const auto& [a, b, c, d, e, f, g, h] = v;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const BootstrapInterval& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const BootstrapResult& v) {
  const auto& [a, b, c, d, e] = v;
  return std::tie(a, b, c, d, e);
}
inline auto members(const FitIntervals& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const FitOutcome& v) {
  const auto& [a, b, c, d, e, f, g, h] = v;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const ModulusPrior& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const StatedPriors& v) {
  const auto& [a, b] = v;
  return std::tie(a, b);
}
inline auto members(const FitResult& v) {
  // No binding takes a class apart whose base has members, too.
  static_assert(sizeof(FitResult) == sizeof(FitOutcome) + 424, "all members are compared here");
  return std::tie(static_cast<const FitOutcome&>(v), v.cost, v.misfit_rms, v.misfit_fraction,
                  v.misfit_word, v.runs_test_p, v.autocorrelation, v.effective_samples, v.samples,
                  v.noise, v.simpler_evaluations, v.break_strain_total, v.seed, v.stages, v.trace,
                  v.fitted, v.modulus_prior, v.stated_priors, v.unseen);
}
inline auto members(const FitRecord& v) {
  const auto& [a, b] = v;
  return std::tie(a, b);
}
template <typename A, typename B>
auto members(const std::pair<A, B>& v) {
  return std::tie(v.first, v.second);
}

/// Whether two values are the same, numbers bit by bit: a NaN is the same as itself.
template <typename T>
bool same_bits(const T& a, const T& b);

template <typename T>
bool same_bits(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same_bits(*a, *b));
}

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same_bits(a[i], b[i])) return false;
  }
  return true;
}

template <typename T>
bool same_bits(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  } else if constexpr (requires { members(a); }) {
    const auto all = [&]<std::size_t... I>(const auto& x, const auto& y,
                                           std::index_sequence<I...>) {
      return (same_bits(std::get<I>(x), std::get<I>(y)) && ...);
    };
    const auto of_a = members(a);
    return all(of_a, members(b), std::make_index_sequence<std::tuple_size_v<decltype(of_a)>>());
  } else {
    return a == b;
  }
}

}  // namespace plastica::calibrate
