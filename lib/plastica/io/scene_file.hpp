#pragma once

#include <string>
#include <vector>

#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"

namespace plastica::io {

/// What a scene file says.
struct SceneFile {
  std::string path;  ///< as the user gave it
  std::string text;
  Setup setup;
  std::vector<std::string> notes{};  ///< old names in it, each with the new one, for the user
};

/// What a scene is read for.
enum class SceneUse {
  Run,   ///< it has to be one that can be simulated
  Beam,  ///< its beam alone is wanted: it may lack supports and loads, and is checked by its user
};

/// Reads a scene file: the tables [material], [section], [beam], [rules] and [solver] with the
/// fields of the field table, and
/// - `name`, the scene's name, by default the file's stem;
/// - `material = "S355"`, or `name = "S355"` in [material]: a named material, the base that the
///   other keys of [material] change; `material` and `section` may be keys of [beam] instead.
///
/// With [drive] the scene is a coupon:
/// - `deformation`, and `strain`, one of
///     [0, "1 %", "2 %"]                                          the samples,
///     { table = "path.csv", column = "Strain", unit = "%" }      a column, relative to the file,
///     { turning_points = ["2 %", "-1 %"], points_between = 50 }  straight ways from 0 over these
///   (50 samples between two turning points by default);
/// - [rules] has neither `yield_model`, `break_limit_x`, `_y`, `_z` nor `hinge_length`;
/// - [[probe]] with `kind` (see `ProbeQuantity`) and `name`, the kind by default; the stress if
/// there
///   is none.
///
/// Without, it is a chain, with [[support]] unless `solver.analysis` is "dynamics". Vectors are
/// lists of x, y and z in world axes; directions are "x", "-y" or such a list. Places are "start",
/// "end", { segment = 3 } (the outer end of that segment, from 1) or a fraction of the length
/// (0.25, "25 %"); integers above 0 are refused.
/// - [beam]: `segment_lengths`, lengths or fractions of the length; `joint_lengths`; with `shape =
///   "arc"` `arc_angle` and `arc_towards`, with `shape = "polyline"` `points`. `length` may be left
///   out where points or segment lengths say it, `segments` where segment lengths do.
/// - [[region]]: `from`, `to`, and keys of `section` and `material` that differ there; of a taper
///   `to_section`, keys that differ at its end.
/// - [[support]]: `at`, `kind` (see `SupportKind`), `hold` (of "x", "y", "z", "rx", "ry", "rz"),
///   `stiffness` and `rotational_stiffness` (elastic), `normal`, `gap` and `restitution` (pillar),
///   `translation` and `rotation` with their `history`.
/// - [[load]]: `at`, `force`, `moment`, `follows`, `history`; with `to` it is spread from `at` to
///   there, and force and moment are per length.
/// - [[mass]]: `at`, `mass`, `inertia`, about x, y and z.
/// - `gravity`, a vector or a table with `acceleration`, or `x`, `y` and `z`, and `history`.
/// - [[initial_motion]], dynamics: `velocity`, and `spin` through `about` (0.5 by default), of the
///   segments between `from` and `to`, the whole beam by default.
/// - [[cut]], dynamics: `at`, `time`.
/// - Histories are "ramp" (the default: 0 at time 0, 1 at 1 s, and on), "constant", { cycles = 3 }
///   (from 0 three times over 1 and -1, then to 0), { turning_points = [1, -1, 0.5] } (from 0, one
///   each second), or { time = ["0 s", "2 s"], factor = [0, 1] }; tables hold their last factor
///   after their end.
/// - [[probe]]: `name`, `kind`, `at` ("end" by default), `component` ("x", "y", "z", "size"; by
///   default y of displacements, velocities, momenta and forces, x of all that is about an axis),
///   `energy` of kind "energy".
/// - `solver.control_at`: the point that displacement and arc-length control watch;
///   `solver.control_motion`: how far displacement control takes it.
/// @throws InputError for the first thing that is wrong, keys that nobody knows included
SceneFile read_scene_file(const std::string& path, SceneUse use = SceneUse::Run);
/// @param name  stands for the file in errors; its folder is where relative paths begin
SceneFile parse_scene_file(std::string text, std::string name, SceneUse use = SceneUse::Run);

/// An error of a field that was found after the scene was read, with the file and the field's line
/// there; others (of options, of other files) as they are.
InputError placed_in(const SceneFile& file, const InputError& error);

/// Calls what works on a scene that was read, and places its errors.
template <class Call>
auto with_place_in(const SceneFile& file, const Call& call) {
  try {
    return call();
  } catch (const InputError& error) {
    throw placed_in(file, error);
  }
}

/// Refuses keys of [rules] that a coupon has no use for: the yield model, break limits and the
/// hinge length are of chains. @throws InputError that names the first
void refuse_rules_of_chains(const TomlTable& root);

/// Reads the tables [material], [section], [beam], [rules] and [solver] of any file into a setup;
/// what the file does not say stays as it is. A new field needs no change here.
/// @throws InputError as above, but leaves unknown keys to `TomlTable::check_unused`
void read_setup(const TomlTable& root, Setup& setup);

/// Refuses a section of its own that lacks a dimension: the default of one beside the others would
/// be a beam that nobody has.
/// @throws InputError
void check_section_is_whole(const TomlTable& root, const Setup& setup);

}  // namespace plastica::io
