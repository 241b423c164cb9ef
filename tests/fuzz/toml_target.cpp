#include <string>
#include <string_view>

#include "plastica/io/toml.hpp"
#include "plastica/io/toml_edit.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// TOML of any kind, and changes of single values in it.
namespace plastica::fuzz {
namespace {

/// Asks for all that a value has.
void read_value(const io::TomlValue& value) {
  require(value.where().line > 0, "a value without a line");
  require(!value.key().empty(), "a value without a key");
  check_refusal(value.error("is refused").what());
  if (value.is_array()) {
    for (const io::TomlValue& item : value.array()) read_value(item);
  } else if (value.is_table()) {
    const io::TomlTable table = value.table();
    for (const std::string& key : table.keys()) read_value(table.at(key));
    table.check_unused();
  } else {
    require(!value.written().empty(), "a value that is not written");
    read_or_refused([&] { return value.quantity(Dimension::Strain); });
    read_or_refused([&] { return value.strings(); });
    read_or_refused([&] { return value.integer(-1, 1'000'000); });
  }
}

/// A value that was set is there.
void edit_toml(std::string_view text, std::string_view path) {
  const auto edited = result_or_refused([&] { return io::set_toml_value(text, path, "7"); });
  if (!edited) return;
  require(io::has_toml_key(*edited, path), "a key that was set is not there");
  const auto document =
      result_or_refused([&] { return io::TomlDocument::parse(*edited, "edited.toml"); });
  require(document.has_value(), "an edited text is no TOML");
}

void read_toml(Bytes bytes) {
  const std::string text(text_of(bytes));
  const bool is_toml = read_or_refused([&] {
    const io::TomlDocument document = io::TomlDocument::parse(text, "fuzzed.toml");
    const io::TomlTable& root = document.root();
    for (const std::string& key : root.keys()) read_value(root.at(key));
    root.check_unused();
  });
  if (!is_toml) return;
  for (const std::string_view path : {"a", "a.b", "beam.segments", "load[1].at", "c.d.e"}) {
    edit_toml(text, path);
  }
}

const Registered kToml{"toml", read_toml};

}  // namespace
}  // namespace plastica::fuzz
