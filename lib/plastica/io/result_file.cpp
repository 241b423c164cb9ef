#include "plastica/io/result_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>

#include "plastica/base/instruction_set.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/base/status.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/durable_file.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/value_rule.hpp"

namespace plastica::io {
namespace {

/// "setup/material/yield_stress" of "material.yield_stress".
std::string setup_path(const Field& field) {
  std::string path = "setup/" + std::string(field.path);
  std::replace(path.begin(), path.end(), '.', '/');
  return path;
}

}  // namespace

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
  meta.instruction_set = name_of(resolved(InstructionSet::Auto));
  meta.command_line = std::move(command_line);
  meta.versions = {{"plastica", std::string(version())}, {"hdf5", hdf5_version()}};
  return meta;
}

void check_output_path(const std::string& path, bool force) {
  const auto refuse = [&](const std::string& rule) { throw InputError({path, 0}, "", "", rule); };
  if (path.empty()) throw InputError({}, "output", "", "must name a file");
  if (path == "-") refuse("is no file: standard output is not taken here");
  const std::string folder = folder_of(path);
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) {
    refuse(errno == ENOENT ? "cannot be written: there is no folder " + folder
                           : "cannot be written: " + folder + ": " + std::strerror(errno));
  }
  if (!S_ISDIR(status.st_mode)) refuse("cannot be written: " + folder + " is no folder");
  if (const std::string why = no_output_reason(path); !why.empty()) refuse(why);
  constexpr std::size_t kLongestName = 247;  // NAME_MAX of Linux less ".journal"
  if (path.size() - (path.rfind('/') + 1) > kLongestName) {
    refuse("has too long a name: at most " + std::to_string(kLongestName) +
           " bytes, so that a journal fits beside it");
  }
  if (::lstat(path.c_str(), &status) == 0 && !force) {
    refuse("exists already: use --force to overwrite it");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse("cannot be written: the folder " + folder + " is closed to writing");
  }
}

std::string schema_of(const std::string& path) {
  const Hdf5File file = Hdf5File::open(path);
  if (!file.root().has_attribute(".", "schema")) {
    throw InputError({path, 0}, "", "",
                     "is not a result file of Plastica: it has no attribute schema");
  }
  return file.root().text_attribute(".", "schema");
}

std::span<const std::string_view> status_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> all;
    for (int i = 0; i <= static_cast<int>(Status::NotBalanced); ++i) {
      all.push_back(name_of(static_cast<Status>(i)));
    }
    return all;
  }();
  return words;
}

void write_schema(Hdf5Group& root, std::string_view schema, int version) {
  root.set_attribute(".", "schema", schema);
  root.set_attribute(".", "version", version);
}

void check_schema(const Hdf5Group& root, std::string_view schema, int version) {
  (void)check_schema(root, schema, version, version);
}

int check_schema(const Hdf5Group& root, std::string_view schema, int oldest, int newest) {
  const auto refuse = [&](const std::string& name, const std::string& value,
                          const std::string& rule) {
    throw InputError({root.file(), 0}, name, value, rule);
  };
  if (!root.has_attribute(".", "schema")) {
    refuse("", "", "is not a result file of Plastica: it has no attribute schema");
  }
  const std::string found = root.text_attribute(".", "schema");
  if (found != schema) refuse("schema", found, "must be " + std::string(schema));
  const std::int64_t number = root.integer_attribute(".", "version");
  if (number < oldest || number > newest) {
    const std::string from = oldest < newest ? std::to_string(oldest) + " to " : "";
    refuse("version", std::to_string(number),
           "must be " + from + std::to_string(newest) + ", which this Plastica reads");
  }
  return static_cast<int>(number);
}

void write_run_id(Hdf5Group& root, const std::string& id) {
  if (!id.empty()) root.set_attribute(".", std::string(kRunAttribute), id);
}

std::string read_run_id(const Hdf5Group& root) {
  const std::string name(kRunAttribute);
  return root.has_attribute(".", name) ? root.text_attribute(".", name) : std::string();
}

void write_inputs(Hdf5Group& root, const std::vector<InputText>& inputs) {
  std::vector<std::string> names;
  std::vector<std::string> texts;
  for (const InputText& input : inputs) {
    names.push_back(input.name);
    texts.push_back(input.text);
  }
  root.write_texts("inputs/name", names);
  root.write_texts("inputs/text", texts);
}

void write_meta(Hdf5Group& root, const RunMeta& meta) {
  Hdf5Group group = root.group(kMetaGroup);
  group.write_text("start_time", meta.start_time);
  group.write("seconds", meta.seconds, {"s"});
  group.write_text("host", meta.host);
  group.write("threads", std::int64_t{meta.threads});
  group.write_text("instruction_set", meta.instruction_set);
  group.write_text("command_line", meta.command_line);
  group.write("resumptions", std::int64_t{meta.resumptions});
  Hdf5Group versions = group.group("versions");
  for (const auto& [name, version] : meta.versions) versions.write_text(name, version);
}

std::vector<InputText> read_inputs(const Hdf5Group& root) {
  std::vector<std::string> names = root.read_texts("inputs/name");
  std::vector<std::string> texts = root.read_texts("inputs/text");
  if (names.size() != texts.size()) {
    throw InputError({root.file(), 0}, "/inputs", "", "must have as many names as texts");
  }
  std::vector<InputText> inputs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    inputs.push_back({std::move(names[i]), std::move(texts[i])});
  }
  return inputs;
}

RunMeta read_meta(const Hdf5Group& root) {
  const Hdf5Group group = root.open_group(kMetaGroup);
  RunMeta meta;
  meta.start_time = group.read_text("start_time");
  constexpr std::array kRules{ValueRule{"meta/seconds", kNotNegative}};
  meta.seconds = read_number<double>(group, "seconds", kRules);
  meta.host = group.read_text("host");
  meta.threads = read_number<int>(group, "threads", kRules);
  meta.instruction_set = group.read_text("instruction_set");
  meta.command_line = group.read_text("command_line");
  meta.resumptions = read_number<int>(group, "resumptions", kRules);
  const Hdf5Group versions = group.open_group("versions");
  for (const std::string& name : versions.children()) {
    meta.versions.emplace_back(name, versions.read_text(name));
  }
  return meta;
}

void write_setup(Hdf5Group& group, const Setup& setup) {
  for (const Field& field : fields()) {
    const std::string path = setup_path(field);
    const FieldValue value = field.get(setup);
    if (const auto* word = std::get_if<std::string>(&value)) {
      group.write_text(path, *word);
    } else {
      const auto* number = std::get_if<double>(&value);
      group.write(path, number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN(),
                  {si_unit(field.dimension)});
    }
  }
}

void read_setup(const Hdf5Group& group, Setup& setup) {
  const SourceLocation where{group.file(), 0};
  for (const Field& field : fields()) {
    const std::string path = setup_path(field);
    // What an older version did not know has its default, which is how that version ran.
    if (!group.exists(path)) continue;
    FieldValue value;
    if (group.kind(path) == Hdf5Kind::Text) {
      value = group.read_text(path);
    } else if (const auto number = group.read_scalar<double>(path); !std::isnan(number)) {
      value = number;
    }
    set_field(setup, field, value, where);
  }
}

}  // namespace plastica::io
