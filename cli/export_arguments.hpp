#pragma once

#include <string>
#include <vector>

#include "cli/export_beam.hpp"
#include "cli/result_kind.hpp"

/// What `plastica export` is asked for, and what of it goes together.
namespace plastica::cli {

struct ExportArguments {
  BeamRequest beam;  ///< its file, and `to`, empty: what the output's name ends in, else csv
  std::string what;  ///< empty: the first of the file's kind
  std::string time;
  std::string output = "-";
  bool force = false;
  bool is_scene_file = false;  ///< not a result: it has a beam alone
};

/// What --to may be: the formats of beams, csv the first, the others of tables, and ParaView's.
std::vector<std::string> export_formats();

/// Takes the format from the output's name where none is given. @throws InputError if they differ,
/// or if the name says another format than those of tables
void take_format(ExportArguments& arguments);

/// Whether the beam is wanted for an engine, not the numbers of the result.
bool wants_beam(const ExportArguments& arguments);

/// Refuses words that are none, whatever the file. @throws InputError
void check_words(const ExportArguments& arguments);

/// Refuses options that do not go with the file's kind or with what is written.
/// @throws InputError
void check_options(const ExportArguments& arguments, ResultKind kind);

}  // namespace plastica::cli
