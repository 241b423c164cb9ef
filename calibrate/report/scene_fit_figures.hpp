#pragma once

#include <array>
#include <span>
#include <string>

#include "calibrate/report/picture_kind.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/scene_figure.hpp"

/// What the pictures of fits through scenes show; not installed.
namespace plastica::calibrate::report {

using plastica::report::Figure;
using plastica::report::PlotScript;

/// A panel per target: measured and fitted ordinate over the abscissa with bands of 95 % (not on a
/// terminal), the break marked.
Figure fit_figure(const SceneFitRecord& record, bool terminal);
/// Of one target with its residuals in a strip below.
PlotScript fit_picture(const SceneFitRecord& record, const Sheet& sheet);
/// A panel per target: measured minus fitted ordinate, and the noise on both sides of zero.
/// @throws InputError if nothing was fitted
Figure residuals_figure(const SceneFitRecord& record);
/// The costs of the searches in rising order. @throws InputError if none ended anywhere
Figure starts_figure(const SceneFitRecord& record);
/// A panel per parameter: its value over the length of the segments, and where that leads.
/// @throws InputError if the fit was not repeated with other segments
Figure segments_figure(const SceneFitRecord& record);
/// A panel per parameter: its value and interval in each fit, with mean and deviation.
/// @throws InputError if no fit determines any
Figure population_figure(std::span<const SceneFitRecord> records);

/// The correlations of a fit's parameters as a map with their numbers; for a terminal the numbers.
/// @throws InputError if it has none
PlotScript correlation_plot(const SceneFitRecord& record, const Sheet& sheet);

template <auto figure>
PlotScript draw_one(const SceneFitRecord& record, const Sheet& sheet) {
  return drawn(figure(record), sheet);
}

using SceneFitPicture = PictureKind<SceneFitRecord>;
/// All kinds, as `--list` has them, the first one where none is asked for: a new one is a line
/// here, its figure above, and what that shows in a .cpp.
inline constexpr std::array kSceneFitPictures{
    SceneFitPicture{
        .name = "fit",
        .doc = "one fit: curves of each target, bands of 95 %, the break (choose it with --case)",
        .of_one = fit_picture},
    SceneFitPicture{.name = "residuals",
                    .doc = "measured minus fitted of each target, and the noise (--case)",
                    .of_one = draw_one<residuals_figure>},
    SceneFitPicture{.name = "quantiles",
                    .doc = "residuals of each target against normal quantiles (--case)",
                    .of_one = quantiles_picture<SceneFitRecord>},
    SceneFitPicture{.name = "starts",
                    .doc = "what the searches found, in rising order of their costs (--case)",
                    .of_one = draw_one<starts_figure>},
    SceneFitPicture{.name = "correlation",
                    .doc = "correlations of the fitted parameters (--case)",
                    .of_one = correlation_plot},
    SceneFitPicture{.name = "segments",
                    .doc = "values over the length of the segments, and where they lead (--case)",
                    .of_one = draw_one<segments_figure>},
    SceneFitPicture{
        .name = "profile",
        .doc = "rise of the least cost over each parameter, of a fit with profiles (--case)",
        .of_one = profile_picture},
    SceneFitPicture{.name = "bootstrap",
                    .doc = "resampled values of the parameters and of pairs (--case)",
                    .of_one = bootstrap_picture},
    SceneFitPicture{
        .name = "laws",
        .doc = "what each law of a comparison makes of the targets, and how far off it is (--case)",
        .of_laws = laws_picture},
    SceneFitPicture{
        .name = "population",
        .doc = "values and intervals of all fits, with mean and deviation of the specimens",
        .of_all = [](std::span<const SceneFitRecord> records,
                     const Sheet& sheet) { return drawn(population_figure(records), sheet); }},
};

}  // namespace plastica::calibrate::report
