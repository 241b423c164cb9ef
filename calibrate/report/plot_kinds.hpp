#pragma once

#include <cstddef>
#include <span>

#include <array>
#include <string>

#include "calibrate/report/picture_kind.hpp"
#include "calibrate/report/plot_data.hpp"
#include "calibrate/result/result.hpp"

namespace plastica::calibrate::report {

/// One specimen: measured and fitted curve, yield and break marked, parameters in the title.
/// @throws InputError if it has no curve
PlotScript curve_plot(const FitRecord& record, const Sheet& sheet);
/// The same as characters, for a terminal of 80 columns and 24 lines.
PlotScript curve_terminal(const FitRecord& record);
PlotScript curve_picture(const FitRecord& record, const Sheet& sheet);

/// One specimen: measured minus fitted stress over strain, the rms misfit (or the stated noise) on
/// both sides of zero, the fitted yield stress reached marked.
/// @throws InputError if it was not fitted
PlotScript residuals_picture(const FitRecord& record, const Sheet& sheet);

/// The batch: a panel per group with all its curves, their mean, the fits and the breaks.
/// @throws InputError if no specimen has a curve that can be drawn
PlotScript overview_plot(std::span<const FitRecord> records, const Sheet& sheet);
/// The same as characters: the mean of each group, of a single one the mean of the fits, too.
PlotScript overview_terminal(std::span<const FitRecord> records);
PlotScript overview_picture(std::span<const FitRecord> records, const Sheet& sheet);

/// The free parameters: a panel each, every specimen a point above its group, with mean and
/// standard deviation. @throws InputError if nothing was fitted
PlotScript parameters_plot(std::span<const FitRecord> records, const Sheet& sheet);
/// The same as characters, without the errors; the panels one below the other.
PlotScript parameters_terminal(std::span<const FitRecord> records);
PlotScript parameters_picture(std::span<const FitRecord> records, const Sheet& sheet);

using FitPicture = PictureKind<FitRecord>;
/// All kinds, as `--list` has them: a new one is a line here, its function above, and what that
/// draws in a .cpp.
inline constexpr std::array kFitPictures{
    FitPicture{.name = "curve",
               .doc = "one specimen: measured and fitted curve, yield and break (choose it with "
                      "--case)",
               .of_one = curve_picture},
    FitPicture{.name = "residuals",
               .doc = "measured minus fitted stress of one specimen, and the rms misfit (--case)",
               .of_one = residuals_picture},
    FitPicture{.name = "quantiles",
               .doc = "residuals of one specimen against normal quantiles, whether they are noise "
                      "(--case)",
               .of_one = quantiles_picture<FitRecord>},
    FitPicture{.name = "overview",
               .doc = "all curves by group, with their mean, the fits and the breaks",
               .of_all = overview_picture},
    FitPicture{.name = "parameters",
               .doc = "the fitted parameters of all specimens by group",
               .of_all = parameters_picture},
    FitPicture{.name = "profile",
               .doc = "rise of the least cost over each parameter, of a fit with profiles (--case)",
               .of_one = profile_picture},
    FitPicture{.name = "bootstrap",
               .doc = "resampled values of the parameters and of pairs (--case)",
               .of_one = bootstrap_picture},
    FitPicture{.name = "laws",
               .doc = "what each law of a comparison makes of one specimen, and how far off it is "
                      "(--case)",
               .of_laws = laws_picture},
};

}  // namespace plastica::calibrate::report
