#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "plastica/base/check.hpp"

/// Names that have changed since the last version, which this one still reads; not installed.
///
/// All of them stand in two tables, of keys in input files and of names in result files. Readers
/// ask for the present name and find the former one, too (`TomlTable::find`, `find_field`,
/// `Hdf5Group`); what is written has the present one.
namespace plastica {

/// The former name of a key of input files; empty: it has none.
std::string_view former_key(std::string_view now);
/// The former name of a dataset or group of result files; empty: it has none.
std::string_view former_column(std::string_view now);

/// The present path of a field: "material.hardening.kinematic_fraction" of the path that ends with
/// "kinematic_share", with the part before the last dot or without it.
std::string present_path(std::string path);
/// The path that a field had at first. Digests are made of it, so that journals stay usable.
std::string first_path(std::string_view path);

/// Gets a former name in an input file, with its place, and the present one.
using FormerNameListener =
    std::function<void(const SourceLocation& where, std::string_view before, std::string_view now)>;

/// Sets what is told of former names in input files, from any thread; an empty function: nothing
/// is. For a program, before it reads its inputs.
/// @return the one before
FormerNameListener listen_to_former_names(FormerNameListener listener);
/// Tells the listener of a former name; not of a place without a line, which is no input file.
void note_former_name(const SourceLocation& where, std::string_view before, std::string_view now);

/// While it lives, its thread reads what no user has written, such as inputs in a result file: the
/// listener is told nothing.
class UnnotedFormerNames {
 public:
  UnnotedFormerNames();
  ~UnnotedFormerNames();
  UnnotedFormerNames(const UnnotedFormerNames&) = delete;
  UnnotedFormerNames& operator=(const UnnotedFormerNames&) = delete;
};

}  // namespace plastica
