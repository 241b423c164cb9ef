#include "plastica/model/item_field.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "plastica/io/scene_digest.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/report/scene_json.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/scene_record.hpp"

/// Every number of supports, loads, masses and initial motions reaches the digest, a file and back,
/// and the JSON: what a table of fields says, all of them do.
namespace plastica::io {
namespace {

template <class Item, class Field, class Use>
void change_each(std::vector<Item> Scene::*list, std::span<const Field> fields, const Use& use) {
  for (const Field& field : fields) {
    for (std::size_t k = 0; k < 3; ++k) {
      plastica::Setup setup;
      Item& item = (setup.scene.*list).emplace_back();
      auto* const vector = std::get_if<std::array<double, 3> Item::*>(&field.member);
      if (vector != nullptr) {
        (item.*(*vector))[k] += 0.5;
      } else {
        item.*std::get<double Item::*>(field.member) += 0.5;
      }
      use(std::string(field.key), setup);
      if (vector == nullptr) break;  // one number
    }
  }
}

template <class Use>
void change_all(const Use& use) {
  change_each(&Scene::supports, support_fields(), use);
  change_each(&Scene::loads, load_fields(), use);
  change_each(&Scene::masses, mass_fields(), use);
  change_each(&Scene::initial_motions, initial_motion_fields(), use);
}

TEST(ItemField, ChangesTheDigest) {
  change_all([](const std::string& key, const plastica::Setup& changed) {
    plastica::Setup usual = changed;
    for (Support& support : usual.scene.supports) support = {};
    for (Load& load : usual.scene.loads) load = {};
    for (PointMass& mass : usual.scene.masses) mass = {};
    for (InitialMotion& motion : usual.scene.initial_motions) motion = {};
    EXPECT_NE(scene_digest(usual), scene_digest(changed)) << key;
  });
}

template <class Item>
void add(const std::vector<Item>& changed, std::vector<Item>& all) {
  all.insert(all.end(), changed.begin(), changed.end());
}

// Loads, masses and motions stand in every file, each change in an item of its own: a number that
// got lost, or into another item, changes the digest. Supports have reactions, as many as there
// are: a file for each.
TEST(ItemField, GoesToAFileAndBack) {
  const ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  SceneRecord record = testing::record_of(testing::cantilever_text());
  Scene& scene = record.setup.scene;
  scene.loads.clear();
  std::vector<std::pair<std::string, Support>> supports;
  change_all([&](const std::string& key, const plastica::Setup& changed) {
    add(changed.scene.loads, scene.loads);
    add(changed.scene.masses, scene.masses);
    add(changed.scene.initial_motions, scene.initial_motions);
    for (const Support& support : changed.scene.supports) supports.emplace_back(key, support);
  });
  ASSERT_FALSE(supports.empty() || scene.loads.empty() || scene.masses.empty() ||
               scene.initial_motions.empty());
  for (std::size_t i = 0; i < supports.size(); i += testing::kSanitized ? 5 : 1) {
    const auto& [key, support] = supports[i];
    scene.supports = {support};
    scene.supports[0].hold = support.held();
    write_scene_store(path, record, Overwrite::Allowed);
    const SceneRecord back = read_scene_store(path);
    EXPECT_EQ(scene_digest(back.setup), scene_digest(record.setup)) << key;
  }
}

TEST(ItemField, StandsInTheJsonOfItsKind) {
  SceneRecord record = testing::record_of(testing::cantilever_text());
  Scene& scene = record.setup.scene;
  scene.masses.emplace_back();
  scene.supports.resize(1);
  for (const SupportTraits& kind : support_traits()) {
    scene.supports[0].kind = kind.kind;
    scene.supports[0].translation = {0.0, 0.1, 0.0};
    const auto all = nlohmann::json::parse(report::scene_json(record));
    const auto& support = all["supports"][0];
    for (const SupportField& field : support_fields()) {
      const auto& where = field.of == nullptr ? support["motion"] : support;
      EXPECT_EQ(where.contains(std::string(field.key)), field.belongs_to(scene.supports[0]))
          << kind.word << ' ' << field.key;
    }
  }
  const auto all = nlohmann::json::parse(report::scene_json(record));
  for (const auto& field : load_fields()) {
    EXPECT_TRUE(all["loads"][0].contains(std::string(field.key))) << field.key;
  }
  for (const auto& field : mass_fields()) {
    EXPECT_TRUE(all["masses"][0].contains(std::string(field.key))) << field.key;
  }
}

}  // namespace
}  // namespace plastica::io
