#include "cli/help_format.hpp"

#include <fmt/format.h>

#include <string_view>

#include "plastica/report/format.hpp"

namespace plastica::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kColumn = 27;  ///< where descriptions begin

/// A name in the first column, and its description in the second, below it if the name is long.
std::string two_columns(const std::string& name, std::string_view description) {
  const std::string indent(kColumn, ' ');
  const std::string first = "  " + name;
  if (first.size() + 2 > kColumn) {
    return first + '\n' + report::wrapped(indent, description, kWidth);
  }
  return report::wrapped(fmt::format("{:<{}}", first, kColumn), description, kWidth);
}

}  // namespace

std::string HelpFormat::make_subcommand(const CLI::App* sub) const {
  return two_columns(sub->get_name(), sub->get_description());
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  if (is_positional) return two_columns(make_option_usage(option), option->get_description());
  std::string name;
  for (const std::string& letter : option->get_snames()) name += "-" + letter + ", ";
  for (const std::string& word : option->get_lnames()) name += "--" + word + ", ";
  name.resize(name.size() - 2);
  if (!option->get_option_text().empty()) name += " " + option->get_option_text();
  return two_columns(name, option->get_description());
}

std::string HelpFormat::make_option_usage(const CLI::Option* option) const {
  const std::string& takes = option->get_option_text();
  return option->get_required() ? takes : "[" + takes + "]";
}

std::string HelpFormat::make_group(std::string group, bool is_positional,
                                   std::vector<const CLI::Option*> options) const {
  // Behind another group of options there is a blank line already.
  const bool is_first = is_positional || group == "Options";
  std::string text = (is_first ? "\n" : "") + group + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return text;
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return report::wrapped("", app->get_description(), kWidth) + "\n";
}

}  // namespace plastica::cli
