#include "cli/input_kind.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/io/content_digest.hpp"
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
    KindOfInput{"a result file", "show"},
};

const KindOfInput& known(InputKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

/// By the keys that a file of its kind must have.
std::optional<InputKind> kind_of_toml(const io::TomlTable& root) {
  using enum InputKind;
  if (root.contains("claim")) return Check;
  if (root.contains("target")) return Fit;
  if (root.contains("axis") || root.contains("scene")) return Sweep;
  if (root.contains("beam")) return Scene;
  return {};
}

}  // namespace

std::optional<InputKind> kind_of_input(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // a pipe can be read but once
  if (io::begins_as_result(path)) return InputKind::Result;
  if (std::filesystem::path(path).extension() != ".toml") return {};
  try {
    return kind_of_toml(io::TomlDocument::read(path).root());
  } catch (const InputError&) {  // whoever reads it says so
    return {};
  }
}

void expect_input(const std::string& path, std::initializer_list<InputKind> taken) {
  const std::optional<InputKind> kind = kind_of_input(path);
  if (!kind || std::ranges::find(taken, *kind) != taken.end()) return;
  std::string wanted;
  for (const InputKind one : taken) {
    wanted += (wanted.empty() ? "" : " or ") + std::string(known(one).words);
  }
  if (wanted.empty()) wanted = "a file of curves";
  throw InputError({path, 0}, "", "",
                   fmt::format("is {}, which plastica {} takes: must be {}", known(*kind).words,
                               known(*kind).command, wanted));
}

}  // namespace plastica::cli
