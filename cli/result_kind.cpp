#include "cli/result_kind.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/input_kind.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/machine_error.hpp"
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

namespace {

ResultKind kind_in(const std::string& path) {
  const std::string schema = io::schema_of(path);
  for (std::size_t k = 0; k < kWords.size(); ++k) {
    if (kWords[k].schema == schema) return static_cast<ResultKind>(k);
  }
  throw InputError({path, 0}, "schema", schema,
                   fmt::format("must be {}, {}, {} or {}", kWords[0].schema, kWords[1].schema,
                               kWords[2].schema, kWords[3].schema));
}

void read_whole(const std::string& path) {
  switch (kind_in(path)) {
    case ResultKind::Fits: calibrate::read_fit_store(path); break;
    case ResultKind::Scene: io::read_scene_store(path); break;
    case ResultKind::Sweep: sweeps::read_sweep_store(path); break;
    case ResultKind::SceneFits: calibrate::read_scene_fit_store(path); break;
  }
}

/// Reads a file once in a process of its own: HDF5 crashes on some damage, or never ends.
void try_reading(const std::string& path) {
  constexpr unsigned kSeconds = 600;
  const pid_t child = ::fork();
  if (child < 0) throw MachineError(std::string("cannot make a process: ") + std::strerror(errno));
  if (child == 0) {
    ::alarm(kSeconds);
    try {
      read_whole(path);
    } catch (...) {  // is said by who reads it next
    }
    ::_exit(0);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    throw InputError(
        {path, 0}, "", "",
        fmt::format("is damaged: reading it was ended by signal {}", WTERMSIG(status)));
  }
}

}  // namespace

void check_without_digest(const std::string& path) {
  // Whoever opens the file checks the digest that it has.
  if (io::begins_with_digest(path) || io::check_content_digest(path)) return;
  tell(
      "warning: {}: has no digest (an older version or another program wrote it), so that damage "
      "cannot be detected\n",
      path);
  try_reading(path);
}

ResultKind kind_of_result(const std::string& path) {
  expect_input(path, {InputKind::Result});
  check_without_digest(path);
  return kind_in(path);
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
