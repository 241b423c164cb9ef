#pragma once

#include <span>
#include <string_view>

#include "plastica/model/field.hpp"

/// What a rate law is to scenes. By how much it raises the flow stress is in law/rate_factor.hpp.
namespace plastica {

class RateKind {
 public:
  constexpr RateKind(RateLaw law, std::string_view word, std::span<const Field> parameters)
      : law_(law), word_(word), parameters_(parameters) {}

  RateLaw law() const { return law_; }
  /// The word for it in files.
  std::string_view word() const { return word_; }
  /// Its parameters, as files name them.
  std::span<const Field> parameters() const { return parameters_; }
  /// Whether a material cannot do without one of them.
  static bool needs(const Field& parameter) { return parameter.material.has_value(); }

 private:
  RateLaw law_;
  std::string_view word_;
  std::span<const Field> parameters_;
};

std::span<const RateKind* const> rate_kinds();
/// @throws InputError if there is no such law
const RateKind& rate_kind(RateLaw law);

}  // namespace plastica
