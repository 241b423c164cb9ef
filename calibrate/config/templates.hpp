#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// A file to write: its name and its text.
struct TemplateFile {
  std::string name;
  std::string text;
};

/// What `plastica init` can begin: "fit", "scene-fit", "scene", "coupon".
std::span<const std::string_view> template_kinds();

/// The files that `plastica init KIND` writes side by side; they run as they are. The first is the
/// one to run:
///   fit        fit.toml and example-curve.csv, the curve that it fits;
///   scene-fit  scene-fit.toml, bend_test.toml, the scene that it fits through, and bend_test.csv;
///   scene      scene.toml, a cantilever;
///   coupon     coupon.toml, a beam in tension.
/// Each says in comments what it does and what can be changed.
/// @throws InputError for another kind
std::vector<TemplateFile> template_files(std::string_view kind);

/// A tension test for a first fit: ideally plastic with E = 200 GPa, yield stress 350 MPa, broken
/// at 2 % permanent strain, with noise of 1 MPa (standard deviation). The same bytes every time.
std::string example_curve();

}  // namespace plastica::calibrate
