#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/result/result.hpp"

/// What the pictures for a page and for a terminal have in common.
namespace plastica::calibrate::report {

/// Groups that a picture shows at most; those behind are counted in its title.
inline constexpr std::size_t kMaxPanels = 12;

/// What draws or writes curves says so where they were only counted, or are put aside.
/// @throws std::logic_error
void require_curves(std::span<const FitRecord> records);

bool is_fitted(const FitRecord& record);
/// The parameter of a name, null if the fit has none.
const FittedParameter* find_parameter(const FitResult& result, std::string_view name);
/// The corrected curve, or the raw one where there is none.
const Curve& measured_of(const FitRecord& record);

/// What a picture's title says of a fit: "σ_y 284.60 ± 0.46 MPa", …; or why there is none.
std::vector<std::string> facts_of(const FitRecord& record);
std::string strain_label(const Target& target);  ///< "engineering strain [%]"
std::string stress_label(const Target& target);  ///< "engineering stress [MPa]"

/// Where the fitted curve leaves the elastic line, as (strain in %, stress in MPa).
std::optional<std::vector<double>> yield_point(const FitResult& result);
/// The fitted curve with its fall to zero where the model breaks, also where it does so between two
/// samples and only these are there.
Curve fitted_with_fall(const FitResult& result);
/// The same up to the break, if that lies beyond the samples.
Curve fitted_with_break(const FitResult& result);
/// The fitted curve up to its break, without the fall.
Curve fitted_until_break(const FitResult& result);
/// Adds the specimen's break, if it was observed, as (strain in %, stress in MPa).
void add_break(const FitRecord& record, std::vector<std::vector<double>>& rows);
/// Largest finite strain [1] and stress [Pa] of measured and fitted curves; at least 0.
std::pair<double, double> largest_of(std::span<const FitRecord> records);
bool any_cyclic(std::span<const FitRecord> records);

/// Members of each group that has a curve to draw, in the order of `group_indices`.
/// @throws InputError if none has
std::vector<std::vector<std::size_t>> drawable_groups(std::span<const FitRecord> records);

/// What an axis is called that several specimens share: each of their names for it once.
std::string label_of_all(std::span<const FitRecord> records, std::span<const std::size_t> members,
                         std::string (*label)(const Target&));

/// The specimens of a group that can be drawn and count in its means, and their curves.
struct GroupCurves {
  std::vector<const FitRecord*> drawn;
  std::vector<const Curve*> measured;
};
GroupCurves curves_of(std::span<const FitRecord> records, const std::vector<std::size_t>& members);

/// The free parameters of the first fitted specimen that any specimen determines.
/// @throws InputError if nothing was fitted
std::vector<FittedParameter> free_parameters(std::span<const FitRecord> records);

/// One parameter over the groups, group g above g + 1, in the unit in which it is shown: rows of
/// (place, value, standard error) and (place, mean, standard deviation).
struct GroupValues {
  std::vector<std::vector<double>> points;
  std::vector<std::vector<double>> means;
};
GroupValues values_of(std::span<const FitRecord> records,
                      const std::vector<std::vector<std::size_t>>& groups,
                      const FittedParameter& parameter);

}  // namespace plastica::calibrate::report
