#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calibrate/target/curve.hpp"
#include "plastica/report/plot_script.hpp"

namespace plastica::calibrate::report {

using plastica::report::in_quotes;
using plastica::report::kBlue;
using plastica::report::kDark;
using plastica::report::kGrey;
using plastica::report::kVermillion;
using plastica::report::PlotScript;
using plastica::report::quoted_tic;

/// Adds a curve in % and MPa to a script, thinned to what a picture can show. @return its name
std::string add_curve(PlotScript& script, const Curve& curve);
/// Adds several curves as one block, a blank line between them.
std::string add_curves(PlotScript& script, const std::vector<const Curve*>& curves);

/// The points of a curve that change a picture: one that falls on the spot of the last kept one,
/// of `spots` along each axis, is left out. Infinite and NaN points are left out, too.
Curve thinned(const Curve& curve, std::size_t spots = 1500);

/// The mean of the curves over their strains, up to where the first of them ends; empty for fewer
/// than two and for curves whose strain turns back by more than noise.
Curve mean_curve(const std::vector<const Curve*>& curves);

}  // namespace plastica::calibrate::report
