#include "cli/result_kind.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

struct KindWords {
  std::string_view schema;
  std::string_view one;
  std::string_view many;
};

/// In the order of ResultKind.
constexpr std::array kWords{
    KindWords{calibrate::kFitStoreSchema, "a result of fits", "results of fits"},
    KindWords{io::kSceneSchema, "a simulated scene", "simulated scenes"},
    KindWords{sweeps::kSweepSchema, "a sweep", "sweeps"},
    KindWords{calibrate::kSceneFitSchema, "a result of fits through scenes", "results of fits"},
};

const KindWords& words_of(ResultKind kind) { return kWords[static_cast<std::size_t>(kind)]; }

}  // namespace

void tell_without_digest(const std::string& path) {
  if (io::check_content_digest(path)) return;
  tell(
      "warning: {}: has no digest (an older version or another program wrote it), so that damage "
      "cannot be seen\n",
      path);
}

ResultKind kind_of_result(const std::string& path) {
  tell_without_digest(path);
  const std::string schema = io::schema_of(path);
  for (std::size_t k = 0; k < kWords.size(); ++k) {
    if (kWords[k].schema == schema) return static_cast<ResultKind>(k);
  }
  throw InputError({path, 0}, "schema", schema,
                   fmt::format("must be {}, {}, {} or {}", kWords[0].schema, kWords[1].schema,
                               kWords[2].schema, kWords[3].schema));
}

void refuse_options_of_others(ResultKind kind, std::span<const ResultOption> options) {
  for (const ResultOption& option : options) {
    const auto& kinds = option.kinds;
    if (!option.given || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
    std::string those;
    for (const ResultKind other : kinds) {
      const std::string_view many = words_of(other).many;
      if (those.ends_with(many)) continue;  // both kinds of fits
      those += (those.empty() ? "" : " and ") + std::string(many);
    }
    throw InputError({}, option.name, "",
                     fmt::format("is for {}; this is {}", those, words_of(kind).one));
  }
}

}  // namespace plastica::cli
