#include "sweeps/compare/closed_forms.hpp"

#include <string>

#include "sweeps/compare/form_lists.hpp"

namespace plastica::sweeps {
std::span<const ClosedForm> closed_forms() {
  static const std::vector<ClosedForm> forms = [] {
    std::vector<ClosedForm> all;
    for (const auto part : {elastic_forms(), yielding_forms(), motion_forms()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return forms;
}

const ClosedForm& find_closed_form(std::string_view name, const SourceLocation& where) {
  std::string all;
  for (const ClosedForm& form : closed_forms()) {
    if (form.name == name) return form;
    all += (all.empty() ? "" : ", ") + std::string(form.name);
  }
  throw InputError(where, "error.against", "theory:" + std::string(name),
                   "is not a closed form; there are " + all);
}

}  // namespace plastica::sweeps
