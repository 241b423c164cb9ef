#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sweeps/report/plot_lines.hpp"

/// Cases sorted into few colours; not installed.
namespace plastica::sweeps {

/// A colour and what it stands for.
struct CaseClass {
  std::string name;  ///< "0.1 … 0.2 %"
  std::string color;
  char letter = '?';  ///< on a terminal
  /// Its place among those of numbers, of the smallest 0, of the largest 1; none: it is a status.
  std::optional<double> fraction{};
};

struct CaseClasses {
  std::string what;        ///< that is classified: "size of the error of tip, end [%]"
  bool of_errors = false;  ///< whether errors are, else values
  std::vector<CaseClass> classes;
  std::vector<std::optional<std::size_t>> class_of;  ///< of picked cases (n_cases)
  std::vector<std::string> number;            ///< of a case, empty where there is none (n_cases)
  std::vector<std::optional<double>> amount;  ///< the same with all its digits (n_cases)
};

/// Bounds of classes by size: at 1, 2 and 5 times powers of ten, or at fewer, such that there are
/// few classes; the first and the last lie beyond the numbers.
/// @param low, high  above 0
std::vector<double> bounds_between(double low, double high);

/// By the size of the error, or where no case has one by the value, in equal steps; a case that has
/// neither by its status, or by why it has no error.
CaseClasses classify(const PlotCases& cases);

}  // namespace plastica::sweeps
