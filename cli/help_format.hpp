#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plastica::cli {

/// Lays out `--help` in 80 columns: what an option takes (`FILE`, `N`) stands behind its name, what
/// it does beside it, wrapped.
class HelpFormat final : public CLI::Formatter {
 public:
  std::string make_subcommand(const CLI::App* sub) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  /// A positional argument is called by what it takes.
  std::string make_option_usage(const CLI::Option* option) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
};

}  // namespace plastica::cli
