#include "cli/launched.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

/// Variables in which launchers say which of how many processes this one is: Open MPI, MPICH and
/// others by PMI, SLURM's srun.
constexpr std::array<std::pair<const char*, const char*>, 3> kRanks{{
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
    {"PMI_RANK", "PMI_SIZE"},
    // Not SLURM_NTASKS, which the script of a job has, too, and that runs once.
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},
}};

std::size_t number_of(const char* variable, std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  throw InputError({}, variable, text, "in the environment, must be a number");
}

}  // namespace

std::optional<Launched> launched() {
  for (const auto& [rank, size] : kRanks) {
    const char* index = std::getenv(rank);
    const char* count = std::getenv(size);
    if (index == nullptr || count == nullptr) continue;
    const Launched process{number_of(rank, index), number_of(size, count)};
    // A task of an array is one process.
    if (process.count > 1) return process;
    break;
  }
  return std::nullopt;
}

}  // namespace plastica::cli
