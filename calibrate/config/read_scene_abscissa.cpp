#include "calibrate/config/read_scene_abscissa.hpp"

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

/// "strain", "support[2]" or "load[1]", by its number from 1 on.
void read_drive(const TomlValue& value, SceneTarget& target) {
  const std::string& word = value.string();
  if (word == "strain") {
    target.kind = Abscissa::Strain;
    return;
  }
  for (const auto& [name, kind] : {std::pair{std::string_view("support["), Abscissa::Support},
                                   std::pair{std::string_view("load["), Abscissa::Load}}) {
    if (!word.starts_with(name) || !word.ends_with(']')) continue;
    const char* first = word.data() + name.size();
    const char* last = word.data() + word.size() - 1;
    const auto [end, error] = std::from_chars(first, last, target.driven);
    if (error != std::errc{} || end != last || first == last) break;
    if (target.driven == 0) break;
    --target.driven;
    target.kind = kind;
    return;
  }
  throw value.error("must be \"strain\", \"support[I]\" or \"load[I]\", I its number from 1 on");
}

}  // namespace

void read_scene_abscissa(const TomlTable& axis, SceneTarget& target) {
  const auto probe = axis.find("probe");
  const auto drive = axis.find("drive");
  const auto time = axis.find("time");
  const int given = (probe ? 1 : 0) + (drive ? 1 : 0) + (time ? 1 : 0);
  if (given != 1) {
    throw InputError(axis.where(), axis.key(), "",
                     "needs one of probe (compared along the scene's own path), drive (the scene "
                     "follows what was measured) and time = true");
  }
  target.abscissa_where = (probe ? *probe : drive ? *drive : *time).where();
  if (probe) target.abscissa_probe = probe->string();
  if (drive) read_drive(*drive, target);
  if (time) {
    if (!time->boolean()) throw time->error("must be true, or left out");
    target.kind = Abscissa::Time;
  }
}

}  // namespace plastica::calibrate
