#include "plastica/run/axial_warning.hpp"

#include <algorithm>
#include <utility>

#include "plastica/model/check_value.hpp"

namespace plastica {
namespace {

/// Whether supports hold the beam along its axis at two places, so that its elongation makes
/// forces.
bool is_held_along(const Scene& scene) {
  const auto holds = [](const Support& support) { return support.held()[2]; };
  return std::ranges::count_if(scene.supports, holds) > 1;
}

/// Of a hinge whose elongation is not all shown.
std::string hinge_warning(const Scene& scene, const AxialNote& note, const std::string& force) {
  const bool at_end = note.missing_elongation >= 1.0;
  const auto moves = [](const Support& support) { return support.moves(); };
  std::string text = std::string("the joint at ") +
                     (at_end ? "a clamped end" : "a rigid support within the beam") +
                     " yielded under an axial force of up to " + force +
                     ": its hinge lengthens, and shows " + (at_end ? "nothing" : "half") +
                     " of that";
  if (is_held_along(scene)) {
    text += ", so that axial forces between the supports come out too large";
  }
  if (at_end) {
    text +=
        "; rules.end_rule = \"half\" has the hinge in a joint that lengthens (of first order in "
        "the segments)";
  } else if (std::ranges::any_of(scene.supports, moves)) {
    text +=
        "; a load under displacement control, in place of a support that moves, shows all of it";
  }
  return text;
}

std::string yield_warning(const Scene& scene, const SolverOptions& options, const AxialNote& note) {
  using model_detail::figure;
  const std::string force =
      figure(note.ratio) + " N_p at " + figure(note.fraction) + " of the length";
  const bool per_axis = scene.yield_model == YieldModel::PerAxis;
  if (note.thrust > 0.0) {
    return "a joint yielded under a thrust of " + figure(note.thrust) +
           " N_p: next to no moment, and out of the plane, one yield surface lets it bend as if it "
           "were elastic; rules.yield_model = \"fibre\" finds where it buckles";
  }
  if (note.missing_elongation > 0.0) return hinge_warning(scene, note, force);
  const bool stretches = options.translation == JointTranslation::Elastic;
  if (!per_axis && options.analysis == Analysis::Statics) {
    if (stretches) return {};
    return "a joint yielded under an axial force of up to " + force +
           ": it lengthens, which joints that are rigid along the beam do not show; "
           "solver.translation = \"elastic\" does";
  }
  const std::string text =
      std::string(per_axis    ? "rules.yield_model = \"per_axis\""
                  : stretches ? "a motion of joints at the ends, which do not stretch,"
                              : "a motion of rigid joints") +
      " leaves the axial force out of yielding: up to " + force;
  const std::string advice =
      per_axis    ? "; \"interaction\" takes it into account"
      : stretches ? ""
                  : "; solver.translation = \"elastic\" takes it into account within the beam";
  if (note.left <= 0.0) return text + ", beyond which nothing is carried" + advice;
  return text + ", where a joint yielded; a joint carries up to " +
         figure(100.0 * (1.0 / note.left - 1.0)) + " % more than the section" + advice;
}

}  // namespace

std::vector<std::string> axial_warnings(const Scene& scene, const SolverOptions& options,
                                        const Response& response) {
  std::vector<std::string> all;
  if (response.axial) {
    std::string text = yield_warning(scene, options, *response.axial);
    if (!text.empty()) all.push_back(std::move(text));
  }
  if (response.unheld_thrust) {
    all.emplace_back(
        "the beam is under thrust, and no support keeps it from leaving its plane: whether it "
        "does is not looked at; supports that hold it there, or solver.level = \"spatial\", tell");
  }
  return all;
}

}  // namespace plastica
