#include "plastica/run/axial_warning.hpp"

#include "plastica/model/check_value.hpp"

namespace plastica {

std::string axial_warning(const Scene& scene, const SolverOptions& options,
                          const Response& response) {
  if (!response.axial) return {};
  using model_detail::figure;
  const AxialNote& note = *response.axial;
  const std::string force = figure(note.ratio) + " N_p at " + figure(note.share) + " of the length";
  const bool per_axis = scene.yield_model == YieldModel::PerAxis;
  if (!per_axis && options.analysis == Analysis::Statics) {
    return "a joint yielded under an axial force of up to " + force +
           ": it lengthens, which joints that are rigid along the beam do not show; "
           "solver.translation = \"elastic\" does";
  }
  const std::string text =
      std::string(per_axis ? "rules.yield_model = \"per_axis\"" : "a motion of rigid joints") +
      " leaves the axial force out of yielding: up to " + force + ", where a joint yielded; ";
  const std::string seen =
      per_axis ? "; \"interaction\" sees it" : "; solver.translation = \"elastic\" sees it";
  if (note.left <= 0.0) return text + "the section carries no moment there" + seen;
  return text + "a joint carries up to " + figure(100.0 * (1.0 / note.left - 1.0)) +
         " % more than the section" + seen;
}

}  // namespace plastica
