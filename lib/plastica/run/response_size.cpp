#include "plastica/run/response_size.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string_view>

#include "plastica/model/check_value.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_shape.hpp"

namespace plastica {
namespace {

/// Model and program of the leanest run, in the plane at rest; those in space take more.
constexpr std::size_t kBytesOfSegment = 1500;

std::size_t count_of(int number) { return static_cast<std::size_t>(std::max(0, number)); }

}  // namespace

std::size_t ResponseSize::bytes() const {
  std::size_t numbers = probes * samples;
  if (segments == 0) return sizeof(double) * numbers;
  for (const ShapeValue& value : kShapeValues) numbers += frames * value.count(*this);
  numbers += modes * 3 * (segments + 1);
  const std::size_t of_sample = 2 * sizeof(double) + sizeof(Energies) + sizeof(int);
  return sizeof(double) * numbers + samples * of_sample + frames * sizeof(std::size_t);
}

std::size_t ResponseSize::needed_bytes() const { return bytes() + segments * kBytesOfSegment; }

ResponseSize response_size(const Scene& scene, const SolverOptions& options) {
  ResponseSize size;
  size.probes = scene.probes.size();
  if (scene.is_coupon()) {
    size.samples = scene.drive.strain.size();
    return size;
  }
  const std::size_t steps = count_of(options.steps);
  size.samples = steps + 1;
  size.frames = 1 + (options.frames == 0 ? steps : std::min(steps, count_of(options.frames)));
  size.segments = count_of(scene.beam.segments);
  size.supports = scene.supports.size();
  size.modes = count_of(options.buckling) + count_of(options.frequencies);
  size.in_motion = options.analysis == Analysis::Dynamics;
  return size;
}

ResponseSize response_size(const ChainModel& model) {
  return response_size(model.scene, model.options);
}

ResponseSize response_size(const Model& model) {
  if (model.chain) return response_size(*model.chain);
  ResponseSize size;
  size.probes = model.probes.size();
  size.samples = model.drive.size();
  return size;
}

void check_memory(const Scene& scene, const SolverOptions& options, std::size_t memory) {
  const ResponseSize size = response_size(scene, options);
  const std::size_t needed = size.needed_bytes();
  if (needed <= memory) return;
  const std::string too_much =
      "takes " + bytes_text(needed) + " of memory, and the machine has " + bytes_text(memory);
  if (scene.is_coupon()) {
    throw InputError({}, "drive.strain", std::to_string(size.samples) + " samples",
                     too_much + ": record fewer probes, or drive it by fewer samples");
  }
  throw InputError({}, "beam.segments", std::to_string(size.segments),
                   too_much + ": " + std::to_string(size.samples) + " samples, the shape of " +
                       std::to_string(size.frames) +
                       " kept; fewer segments, solver.steps or solver.frames take less");
}

void check_memory(std::vector<std::size_t> needed, int threads, std::size_t memory) {
  std::sort(needed.begin(), needed.end(), std::greater<>());
  needed.resize(std::min(needed.size(), count_of(threads)));
  const std::size_t together = std::accumulate(needed.begin(), needed.end(), std::size_t{0});
  if (together <= memory) return;
  throw InputError({}, "threads", std::to_string(threads),
                   "so many of the largest cases take " + bytes_text(together) +
                       " of memory, and the machine has " + bytes_text(memory) +
                       ": run fewer side by side, or smaller ones");
}

std::string bytes_text(std::size_t bytes) {
  constexpr std::array<std::string_view, 6> kUnits{"B", "kB", "MB", "GB", "TB", "PB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  // 999.5 is shown as 1000.
  while (value >= 999.5 && unit + 1 < kUnits.size()) {
    value /= 1000.0;
    ++unit;
  }
  return model_detail::figure(value) + " " + std::string(kUnits[unit]);
}

}  // namespace plastica
