#include "sweeps/plan/templates.hpp"

#include <array>
#include <string>

#include "plastica/base/check.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::string_view kScene =
    R"(# The scene that sweep.toml varies: a cantilever under a tip force. `plastica init scene` writes one
# that explains the keys.

[beam]
length   = "4 m"
segments = 32
section  = { shape = "rectangle", width = "20 mm", height = "20 mm" }
material = "S355"

[[support]]
at   = "start"
kind = "clamp"

[[load]]
at      = "end"
force   = ["0 N", "-100 N", "0 N"]
history = "ramp"

[[probe]]
name = "tip"
kind = "displacement"
at   = "end"
component = "y"
)";

constexpr std::string_view kSweep =
    R"(# A sweep: a scene, what is varied in it, and what its cases are compared with.
#
#   plastica sweep sweep.toml -o sweep.h5
#   plastica recommend sweep.h5 --within "0.1 %"
#
# Runs as it is. `#` begins a comment.

scene = "cantilever.toml"

# An axis is a field of `plastica fields`, or one of those that it lists as derived. Axes are
# crossed: every value of one with every value of the others.
[[axis]]
field  = "beam.segments"
values = [5, 10, 20, 40, 80]
# linear      = { from = 10, to = 100, count = 10 }
# logarithmic = { from = 10, to = 1000, count = 5 }

[[axis]]
field  = "rules.end_rule"
values = ["half_joint", "equal"]   # the clamp as a joint of half a segment, or rigid
# zip  = "a"                       # axes with the same word move together

# Axes may be sampled instead, all of them together:
# [sample]
# method = "latin_hypercube"       # or "sobol"
# count  = 100
# seed   = 1
# [[axis]]
# field   = "material.youngs_modulus"
# sampled = ["190 GPa", "210 GPa"]
# spacing = "linear"               # or "logarithmic"

# Fields that all cases have otherwise than the scene:
# [set]
# solver.level = "spatial"

[error]
probe   = "tip"                    # or quantity = "natural_frequency", "limit_load", "break_load", ...
take    = "end"                    # "min", "max", "size", "mean", "curve", "frequency"
against = "theory:elastica"        # "reference:FILE", "value:0.735 m", "finest", "richardson"
# along = "beam.segments"          # the axis that refines; by default the first that can

# [cost]
# timed_runs = 3                   # runs each case so often more, and keeps the least time
)";

constexpr std::string_view kCheck =
    R"(# Claims about sweeps, for every change of a scene or a model: each holds, or it does not.
#
#   plastica check check.toml --junit check.xml
#
# Exit code 0 if all hold, 1 if one does not, 2 for a bad file. Runs as it is. A claim has one of:
#   order, correlation         of the errors' line, by least squares
#   error                      of every case
#   extrapolated_error, gci    of the value extrapolated from the three finest; its uncertainty
#   value, spread              of the quantity: within limits; independent of what is varied
#   work                       in segment-iterations, which no machine changes
#   energy_balance, failed     energy balance error of every case; how many cases fail
# each with at_least, at_most, or both. `where` chooses cases by the values of axes. In place of a
# sweep a claim may be about a scene, a fit file or a result of fits: docs/ci.md.

[[claim]]
name  = "the tip converges with order two"
sweep = "sweep.toml"
where = { rules.end_rule = "half_joint" }
order = { at_least = 1.98, at_most = 2.02 }

[[claim]]
name  = "forty segments are within 0.05 %"
sweep = "sweep.toml"
where = { rules.end_rule = "half_joint", beam.segments = [40, 80] }
error = { at_most = "0.05 %" }

[[claim]]
name  = "no case takes more than 3 000 segment-iterations"
sweep = "sweep.toml"
work  = { at_most = 3000 }
)";

}  // namespace

std::span<const std::string_view> template_kinds() {
  static constexpr std::array<std::string_view, 2> kKinds{"sweep", "check"};
  return kKinds;
}

std::vector<calibrate::TemplateFile> template_files(std::string_view kind) {
  const calibrate::TemplateFile scene{"cantilever.toml", std::string(kScene)};
  const calibrate::TemplateFile sweep{"sweep.toml", std::string(kSweep)};
  if (kind == "sweep") return {sweep, scene};
  if (kind == "check") return {{"check.toml", std::string(kCheck)}, sweep, scene};
  throw InputError({}, "init", kind, "must be one of sweep, check");
}

}  // namespace plastica::sweeps
