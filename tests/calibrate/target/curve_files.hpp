#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "calibrate/target/import.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::testing {

/// A folder of its own for a test, gone with it.
class CurveFiles {
 public:
  explicit CurveFiles(const std::string& test)
      : folder_(std::filesystem::temp_directory_path() /
                ("plastica_target_" + test + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~CurveFiles() { std::filesystem::remove_all(folder_); }
  CurveFiles(const CurveFiles&) = delete;
  CurveFiles& operator=(const CurveFiles&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name)) << text;
    return path(name);
  }

  /// A curve with columns `a` (strain times a factor) and `b` (stress times a factor).
  std::string write_curve(const std::string& name, double strain_factor, double stress_factor,
                          const std::string& header = "a,b") const {
    std::string text = header + "\n";
    const calibrate::Curve curve = IdealPlastic{}.curve();
    for (std::size_t i = 0; i < curve.size(); ++i) {
      char row[80];
      std::snprintf(row, sizeof row, "%.17g,%.17g\n", curve.strain[i] * strain_factor,
                    curve.stress[i] * stress_factor);
      text += row;
    }
    return write(name, text);
  }

  /// A block that reads columns `a` as strain and `b` in MPa.
  static calibrate::TargetSource source(std::vector<std::string> files) {
    calibrate::TargetSource out;
    out.files = std::move(files);
    out.where = {"fit.toml", 3};
    out.strain = calibrate::ColumnSource{"a", std::nullopt, {"fit.toml", 5}};
    out.stress = calibrate::ColumnSource{"b", "MPa", {"fit.toml", 6}};
    return out;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace plastica::testing
