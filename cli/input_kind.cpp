#include "cli/input_kind.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/io/hdf5_tables.hpp"
#include "plastica/io/merge_shards.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::cli {
namespace {

struct KindOfInput {
  std::string_view words;
  std::string_view command;
};

/// In the order of InputKind.
constexpr std::array kKinds{
    KindOfInput{"a scene", "simulate"},       KindOfInput{"a sweep", "sweep"},
    KindOfInput{"a file of claims", "check"}, KindOfInput{"a fit file", "calibrate"},
    KindOfInput{"a result file", "show"},     KindOfInput{"a file of curves", "inspect"},
    KindOfInput{"a shard of a run", "merge"},
};

const KindOfInput& known(InputKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

/// Keys at the top of a file that no other kind has.
constexpr std::array<std::pair<std::string_view, InputKind>, 11> kMarks{{
    {"claim", InputKind::Check},
    {"fit", InputKind::Fit},
    {"target", InputKind::Fit},
    {"axis", InputKind::Sweep},
    {"scene", InputKind::Sweep},
    {"beam", InputKind::Scene},
    {"drive", InputKind::Scene},
    {"load", InputKind::Scene},
    {"mass", InputKind::Scene},
    {"probe", InputKind::Scene},
    {"support", InputKind::Scene},
}};

/// Nothing of a file with keys of two kinds: one of them is a mistake, which its reader names.
std::optional<InputKind> kind_of_toml(const io::TomlTable& root) {
  std::optional<InputKind> kind;
  for (const auto& [key, of] : kMarks) {
    if (!root.contains(key)) continue;
    if (kind && *kind != of) return {};
    kind = of;
  }
  return kind;
}

}  // namespace

std::optional<InputKind> kind_of_input(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // a pipe can be read but once
  switch (io::hdf5_origin(path)) {
    case io::Hdf5Origin::Results: return InputKind::Result;
    case io::Hdf5Origin::Others: return InputKind::Curves;
    case io::Hdf5Origin::Unknown: return {};  // whoever reads it says why
    case io::Hdf5Origin::None: break;
  }
  if (io::is_shard(path)) return InputKind::Shard;
  if (std::filesystem::path(path).extension() != ".toml") return {};
  try {
    return kind_of_toml(io::TomlDocument::read(path).root());
  } catch (const InputError&) {  // whoever reads it says so
    return {};
  }
}

std::string command_for(const std::string& path) {
  const std::optional<InputKind> kind = kind_of_input(path);
  return kind ? std::string(known(*kind).command) : std::string();
}

void expect_input(const std::string& path, std::initializer_list<InputKind> taken) {
  const std::optional<InputKind> kind = kind_of_input(path);
  if (!kind || std::ranges::find(taken, *kind) != taken.end()) return;
  std::string wanted;
  for (const InputKind one : taken) {
    wanted += (wanted.empty() ? "" : " or ") + std::string(known(one).words);
  }
  throw InputError({path, 0}, "", "",
                   fmt::format("is {}, which plastica {} takes: must be {}", known(*kind).words,
                               known(*kind).command, wanted));
}

}  // namespace plastica::cli
