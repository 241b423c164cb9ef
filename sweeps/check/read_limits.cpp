#include "sweeps/check/read_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "plastica/io/result_file.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

bool is_about(const ClaimTraits& kind, ClaimSubject subject) {
  return (kind.subjects & static_cast<unsigned>(subject)) != 0;
}

/// What a kind of claim may be about: "a sweep or a scene".
std::string subjects_of(const ClaimTraits& kind) {
  std::string all;
  for (const ClaimSubject subject :
       {ClaimSubject::Sweep, ClaimSubject::Scene, ClaimSubject::Fit, ClaimSubject::Scan}) {
    if (is_about(kind, subject)) {
      all.append(all.empty() ? "" : " or ").append(word_of(subject));
    }
  }
  return all;
}

/// Fractions are numbers or percents; a value has the quantity's unit.
double read_limit(const TomlValue& value, const Claim& claim, const Sweep* sweep) {
  if (claim.kind == ClaimKind::Value) {
    return value.quantity(sweep != nullptr ? sweep->quantity.dimension : claim.dimension);
  }
  const bool is_error = claim.kind == ClaimKind::Error || claim.kind == ClaimKind::Misfit ||
                        claim.kind == ClaimKind::ExtrapolatedError || claim.kind == ClaimKind::Gci;
  return is_error || value.is_string() ? value.quantity(Dimension::Strain) : value.number();
}

void read_statuses(const TomlValue& words, Claim& claim) {
  const auto all = io::status_words();
  for (const TomlValue& one : words.is_array() ? words.array() : std::vector{words}) {
    claim.statuses.push_back(static_cast<Status>(one.word(all)));
  }
  if (claim.statuses.empty()) throw words.error("needs a word");
}

void read_range(const TomlValue& limits, const Sweep* sweep, Claim& claim) {
  const TomlTable range = limits.table();
  if (const auto low = range.find("at_least")) claim.at_least = read_limit(*low, claim, sweep);
  if (const auto high = range.find("at_most")) claim.at_most = read_limit(*high, claim, sweep);
  if (!claim.at_least && !claim.at_most) throw limits.error("needs at_least or at_most");
  if (claim.at_least && claim.at_most && *claim.at_least > *claim.at_most) {
    throw limits.error("at_least must not be above at_most");
  }
}

/// Whether the kind needs sizes of segments or steps.
bool is_of_sizes(ClaimKind kind) {
  return kind == ClaimKind::Order || kind == ClaimKind::Correlation || kind == ClaimKind::Gci ||
         kind == ClaimKind::ExtrapolatedError;
}

}  // namespace

std::string_view word_of(ClaimSubject subject) {
  switch (subject) {
    case ClaimSubject::Sweep: return "a sweep";
    case ClaimSubject::Scene: return "a scene";
    case ClaimSubject::Fit: return "fits";
    case ClaimSubject::Scan: break;
  }
  return "stability = { … }";
}

void read_claim_kind(const TomlTable& table, Claim& claim) {
  std::optional<TomlValue> named;
  for (std::size_t k = 0; k < kClaimKinds.size(); ++k) {
    const auto found = table.find(kClaimKinds[k].word);
    if (!found) continue;
    if (named) throw found->error("is a second claim: one table makes one");
    named = found;
    claim.kind = static_cast<ClaimKind>(k);
  }
  if (!named) {
    std::string all;
    for (const ClaimTraits& kind : kClaimKinds) {
      if (is_about(kind, claim.subject)) all.append(all.empty() ? "" : ", ").append(kind.word);
    }
    throw InputError(table.where(), table.key(), "", "claims nothing: it needs one of " + all);
  }
  const ClaimTraits& kind = traits_of(claim.kind);
  if (is_about(kind, claim.subject)) return;
  throw named->error(
      fmt::format("is about {}, not about {}", subjects_of(kind), word_of(claim.subject)));
}

void read_limits(const TomlTable& table, const Sweep* sweep, Claim& claim) {
  const TomlValue limits = table.at(traits_of(claim.kind).word);
  if (claim.kind == ClaimKind::Status) {
    read_statuses(limits, claim);
    return;
  }
  if (claim.kind == ClaimKind::Interval) {
    claim.truth = limits.table().at("holds").quantity(claim.dimension);
    claim.at_most = 0.0;  // of how far it lies outside
    return;
  }
  read_range(limits, sweep, claim);
  if (sweep == nullptr) return;
  const bool of_errors = claim.kind == ClaimKind::Order || claim.kind == ClaimKind::Correlation ||
                         claim.kind == ClaimKind::Error ||
                         claim.kind == ClaimKind::ExtrapolatedError;
  if (of_errors && sweep->against.kind == AgainstKind::Nothing) {
    throw limits.error(claim.subject == ClaimSubject::Scene ? "needs against"
                                                            : "needs error.against in the sweep");
  }
  if (is_of_sizes(claim.kind) && !sweep->refined) {
    throw limits.error("needs an axis that refines in the sweep");
  }
}

void refuse_sure(const TomlTable& table, const Claim& claim, std::size_t count) {
  const ClaimTraits& kind = traits_of(claim.kind);
  const TomlValue limits = table.at(kind.word);
  const std::string holds = "holds whatever happens: ";
  if (kind.not_negative && !claim.at_most && *claim.at_least <= 0.0) {
    throw limits.error(holds + "at_least must be above 0");
  }
  constexpr std::array kCounts{ClaimKind::Failed, ClaimKind::Fitted, ClaimKind::Undetected,
                               ClaimKind::Invalid};
  const bool counts = std::find(kCounts.begin(), kCounts.end(), claim.kind) != kCounts.end();
  const auto most = static_cast<double>(count);
  if (counts && claim.at_least.value_or(0.0) <= 0.0 && claim.at_most.value_or(0.0) >= most) {
    throw limits.error(holds + fmt::format("there are {}", count));
  }
  const bool surely_correlated =
      claim.at_least.value_or(-1.0) <= -1.0 && claim.at_most.value_or(1.0) >= 1.0;
  if (claim.kind == ClaimKind::Correlation && surely_correlated) {
    throw limits.error(holds + "a correlation is from -1 to 1");
  }
  const auto words = io::status_words();
  const auto named = [&](std::size_t k) {
    return std::find(claim.statuses.begin(), claim.statuses.end(), static_cast<Status>(k)) !=
           claim.statuses.end();
  };
  bool all = claim.kind == ClaimKind::Status;
  for (std::size_t k = 0; k < words.size(); ++k) all = all && named(k);
  if (all) throw limits.error(holds + "these are all words");
}

}  // namespace plastica::sweeps
