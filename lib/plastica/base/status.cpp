#include "plastica/base/status.hpp"

namespace plastica {

std::string_view name_of(Status status) {
  switch (status) {
    case Status::NotRun: return "not-run";
    case Status::Completed: return "completed";
    case Status::Broken: return "broken";
    case Status::Rejected: return "rejected";
    case Status::InvalidParameter: return "invalid-parameter";
    case Status::NonFinite: return "non-finite";
    case Status::LimitLoad: return "limit-load";
    case Status::Mechanism: return "mechanism";
    case Status::HeldTwice: return "held-twice";
    case Status::NotConverged: return "not-converged";
    case Status::Interrupted: return "interrupted";
    case Status::Unstable: return "unstable";
    case Status::NotBalanced: return "not-balanced";
  }
  return "unknown";
}

std::string_view advice(Status status, bool in_motion) {
  switch (status) {
    case Status::NotRun: return "call run";
    case Status::Rejected: return "mend the input that the reason names";
    case Status::InvalidParameter: return "keep every parameter inside of its field's range";
    case Status::NonFinite: return "look at the largest strain and stiffness of the scene";
    case Status::Mechanism: return "the supports leave the beam free to move: hold more of it";
    case Status::HeldTwice:
      return "let one of the supports slide along the beam, or set solver.translation = elastic";
    case Status::NotConverged:
      // Generalized-alpha may end so at small steps, too: of what rings too little is taken.
      return in_motion ? "take smaller steps; of generalized_alpha a lower rho_infinity, or scheme "
                         "= energy_momentum"
                       : "take more steps, or control = arc_length";
    case Status::Interrupted: return "run it again";
    case Status::Unstable:
      return "stay below the critical factor, hold the beam where it gives way, or add the "
             "imperfection that it has, at a level that holds it";
    case Status::NotBalanced:
      return "take smaller steps; of the schemes energy_momentum balances best";
    case Status::Completed:
    case Status::Broken:
    case Status::LimitLoad: return "";
  }
  return "";
}

}  // namespace plastica
