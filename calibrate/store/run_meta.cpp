#include <unistd.h>

#include <array>
#include <ctime>

#include "calibrate/store/fit_store.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/hdf5.hpp"

namespace plastica::calibrate {

RunMeta begin_meta(std::string command_line, int threads) {
  RunMeta meta;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::array<char, 32> time{};
  if (gmtime_r(&now, &utc) != nullptr) {
    std::strftime(time.data(), time.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  }
  meta.start_time = time.data();
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) == 0) meta.host = host.data();
  meta.threads = resolved_threads(threads);
  meta.instruction_set = instruction_set();
  meta.command_line = std::move(command_line);
  meta.versions = {{"plastica", std::string(version())}, {"hdf5", io::hdf5_version()}};
  return meta;
}

}  // namespace plastica::calibrate
