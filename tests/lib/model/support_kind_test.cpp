#include "plastica/model/support_kind.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "plastica/model/scene_actions.hpp"
#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

TEST(SupportKind, HasTheFreedomsAndWordsOfTheDocumentation) {
  const auto held = [](SupportKind kind) {
    Support support;
    support.kind = kind;
    std::string names;
    for (std::size_t i = 0; i < 6; ++i) {
      if (support.held()[i]) names += std::string(freedom_names()[i]) + ' ';
    }
    return std::string(traits_of(support).word) + ": " + names;
  };
  EXPECT_EQ(held(SupportKind::Clamp), "clamp: x y z rx ry rz ");
  EXPECT_EQ(held(SupportKind::Pin), "pin: x y z rz ");
  EXPECT_EQ(held(SupportKind::Roller), "roller: x y ");
  EXPECT_EQ(held(SupportKind::Guide), "guide: rx ry rz ");
  for (const auto kind : {SupportKind::Elastic, SupportKind::Pillar, SupportKind::InclinedRoller,
                          SupportKind::Hinge}) {
    EXPECT_TRUE(held(kind).ends_with(": ")) << held(kind);
  }
  const std::set<std::string_view> words(support_kinds().begin(), support_kinds().end());
  EXPECT_EQ(words.size(), support_traits().size());
}

TEST(SupportKind, NamesTheKindsThatHaveATrait) {
  EXPECT_EQ(kinds_with(&SupportTraits::normal), "kind = \"pillar\" or \"inclined_roller\"");
  EXPECT_EQ(kinds_with(&SupportTraits::springs), "kind = \"elastic\"");
  EXPECT_EQ(kinds_with(&SupportTraits::one_sided), "kind = \"pillar\"");
  EXPECT_EQ(kinds_with(&SupportTraits::releases), "kind = \"hinge\"");
}

/// Each number of supports is refused where its kind has no use for it, whatever the kind.
TEST(SupportKind, RefusesNumbersOfOtherKinds) {
  int refused = 0;
  for (const SupportTraits& kind : support_traits()) {
    for (const SupportField& field : support_fields()) {
      Support support{.at = {0.5, {}}, .kind = kind.kind};
      if (field.belongs_to(support)) continue;
      if (auto* vector = std::get_if<std::array<double, 3> Support::*>(&field.member)) {
        support.*(*vector) = {1.0, 0.0, 0.0};
      } else {
        support.*std::get<double Support::*>(field.member) = 0.5;
      }
      const std::string error =
          testing::error_of([&](Scene& scene) { scene.supports.push_back(support); });
      const std::string begin = "support[2]." + std::string(field.key);
      EXPECT_TRUE(error.starts_with(begin)) << kind.word << ": " << error;
      EXPECT_TRUE(error.ends_with("belongs to " + kinds_with(field.of))) << error;
      ++refused;
    }
  }
  // stiffness, rotational_stiffness of 7 kinds each, normal of 6, gap and restitution of 7.
  EXPECT_EQ(refused, 34);
}

TEST(SceneActions, AreAllVectorsThatPushOrTurnTheBeam) {
  Scene scene = testing::cantilever({0.0, -3.0, 0.0});
  scene.loads[0].moment = {0.0, 0.0, 7.0};
  scene.supports.push_back(
      {.at = {0.5, {}}, .kind = SupportKind::Pillar, .normal = {1.0, 0.0, 0.0}});
  scene.supports[0].rotation = {0.0, 0.2, 0.0};
  scene.initial_motions.push_back({.spin = {5.0, 0.0, 0.0}});
  std::set<std::string> seen;
  for (const auto& action : model_detail::actions_of(scene)) {
    if (action.vector == std::array<double, 3>{}) continue;
    seen.insert(action.field + (action.sense == VectorSense::Rotate ? " turns" : " pushes"));
  }
  // The clamp's normal says nothing.
  EXPECT_EQ(seen, (std::set<std::string>{"load[1].force pushes", "load[1].moment turns",
                                         "support[1].rotation turns", "support[2].normal pushes",
                                         "initial_motion[1].spin turns"}));
}

}  // namespace
}  // namespace plastica
