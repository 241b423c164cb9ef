#include "plastica/base/former_names.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <span>
#include <utility>

namespace plastica {
namespace {

struct Renamed {
  std::string_view before, now;
};

constexpr std::array kKeys{
    Renamed{"kinematic_share", "kinematic_fraction"},
    Renamed{"drop_share", "drop_fraction"},
    Renamed{"zero_share", "zero_fraction"},
    Renamed{"end_share", "end_fraction"},
    Renamed{"most_work", "max_work"},
    Renamed{"silent", "undetected"},
    Renamed{"unsound", "invalid"},
};

constexpr std::array kColumns{
    Renamed{"kinematic_share", "kinematic_fraction"},
    Renamed{"segment_shares", "segment_fractions"},
    Renamed{"misfit_share", "misfit_fraction"},
    Renamed{"parts", "targets"},
    Renamed{"moved", "free"},
    Renamed{"runs_probability", "runs_test_p"},
    Renamed{"last_whole_strain", "last_intact_strain"},
    Renamed{"last_whole_stress", "last_intact_stress"},
};

std::string_view former(std::span<const Renamed> table, std::string_view now) {
  const auto found = std::ranges::find(table, now, &Renamed::now);
  return found == table.end() ? std::string_view() : found->before;
}

/// The path with another last part, where the table has one.
std::string with_last_part(std::string path, std::string_view Renamed::*from,
                           std::string_view Renamed::*to) {
  const std::size_t begin = path.rfind('.') + 1;
  const auto found = std::ranges::find(kKeys, std::string_view(path).substr(begin), from);
  if (found != kKeys.end()) path.replace(begin, std::string::npos, (*found).*to);
  return path;
}

struct Listening {
  std::mutex mutex;
  FormerNameListener listener;
};

Listening& listening() {
  static Listening one;
  return one;
}

thread_local int unnoted = 0;

}  // namespace

std::string_view former_key(std::string_view now) { return former(kKeys, now); }
std::string_view former_column(std::string_view now) { return former(kColumns, now); }

std::string present_path(std::string path) {
  return with_last_part(std::move(path), &Renamed::before, &Renamed::now);
}

std::string first_path(std::string_view path) {
  return with_last_part(std::string(path), &Renamed::now, &Renamed::before);
}

FormerNameListener listen_to_former_names(FormerNameListener listener) {
  const std::scoped_lock lock(listening().mutex);
  return std::exchange(listening().listener, std::move(listener));
}

void note_former_name(const SourceLocation& where, std::string_view before, std::string_view now) {
  if (unnoted > 0 || where.line == 0) return;
  const std::scoped_lock lock(listening().mutex);
  if (listening().listener) listening().listener(where, before, now);
}

UnnotedFormerNames::UnnotedFormerNames() { ++unnoted; }
UnnotedFormerNames::~UnnotedFormerNames() { --unnoted; }

}  // namespace plastica
