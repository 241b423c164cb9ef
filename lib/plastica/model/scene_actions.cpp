#include "plastica/model/scene_actions.hpp"

#include <algorithm>
#include <span>

#include "plastica/model/check_parts.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

bool is_of(const SupportField& field, const Support& support) { return field.belongs_to(support); }
template <class Field, class Item>
bool is_of(const Field& /*field*/, const Item& /*item*/) {
  return true;
}

template <class Item, class Field>
void add_items(std::vector<SceneAction>& actions, std::string_view list,
               const std::vector<Item>& items, std::span<const Field> fields) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const Field& field : fields) {
      if (field.sense == VectorSense::None || !is_of(field, items[i])) continue;
      SceneAction& action = actions.emplace_back();
      action.field = item_name(list, i, '.' + std::string(field.key));
      action.sense = field.sense;
      std::ranges::copy(field.values(items[i]), action.vector.begin());
    }
  }
}

}  // namespace

std::vector<SceneAction> actions_of(const Scene& scene) {
  std::vector<SceneAction> actions;
  add_items(actions, "load", scene.loads, load_fields());
  actions.push_back({"gravity", VectorSense::Push, scene.gravity});
  add_items(actions, "initial_motion", scene.initial_motions, initial_motion_fields());
  add_items(actions, "support", scene.supports, support_fields());
  return actions;
}

}  // namespace plastica::model_detail
