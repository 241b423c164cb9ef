#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scene.hpp"

// What a program does wrong with `run` is told, not computed.

namespace plastica {
namespace {

using testing::message_of;

static_assert(!std::is_copy_constructible_v<Workspace>, "two copies would share their memory");

Scene bent(double force, int segments = 8) {
  Scene scene = testing::cantilever_scene(segments);
  scene.loads.push_back({.force = {0.0, force, 0.0}});
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

template <class Call>
std::string wrong(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).substr(std::string("plastica::run: ").size());
  }
  return "no error";
}

TEST(RunMisuse, OfAnotherModelsWorkspaceIsTold) {
  const Model a = prepare(bent(-5.0));
  Scene deeper = bent(-5.0);
  deeper.section.height *= 2.0;
  const Model b = prepare(deeper);
  Workspace workspace = make_workspace(a);
  Response response = make_response(b);
  EXPECT_EQ(wrong([&] { run(b, {}, workspace, response); }),
            "a workspace that was not made for this model");
  Workspace empty;
  EXPECT_EQ(wrong([&] { run(b, {}, empty, response); }),
            "a workspace that was not made for this model");
  EXPECT_EQ(wrong([&] { run(a, {}, workspace, response); }), "no error") << "of the same size";
}

/// A workspace keeps what it needs of its model.
TEST(RunMisuse, OfAWorkspaceThatOutlivesItsModelIsNone) {
  Workspace workspace;
  Response response;
  Model copy;
  {
    const Model model = prepare(bent(-5.0));
    workspace = make_workspace(model);
    response = make_response(model);
    copy = model;
  }
  run(copy, {}, workspace, response);
  EXPECT_EQ(response.status, Status::Completed);
}

TEST(RunMisuse, OfSizesIsTold) {
  const Model model = prepare(bent(-5.0), {}, std::vector<std::string>{"material.youngs_modulus"});
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  const std::vector<double> two{1e9, 2e9};
  EXPECT_EQ(wrong([&] { run(model, {}, workspace, response); }),
            "not a value for each of the model's parameters");
  EXPECT_EQ(wrong([&] { run(model, two, workspace, response); }),
            "not a value for each of the model's parameters");
  const std::vector<double> one{70e9};
  Response other = make_response(prepare(bent(-5.0, 4)));
  EXPECT_EQ(wrong([&] { run(model, one, workspace, other); }),
            "a response that was not made for this model");
  Response none;
  EXPECT_EQ(wrong([&] { run(model, one, workspace, none); }),
            "a response that was not made for this model");
  EXPECT_EQ(wrong([&] { run(Model{}, {}, workspace, response); }),
            "a model that `prepare` has not made");
}

TEST(RunMisuse, OfDerivativesIsTold) {
  Scene coupon = testing::coupon_scene(Deformation::Tension, {0.001, 0.01});
  coupon.probes = {{"stress", ProbeQuantity::Stress}};
  const std::vector<std::string> modulus{"material.youngs_modulus"};
  const std::vector<double> value{200e9};
  const auto told = [&](const Scene& scene, bool sized) {
    const Model model = prepare(scene, {}, modulus);
    Workspace workspace = make_workspace(model);
    Response response = make_response(model);
    Sensitivity sensitivity = sized ? make_sensitivity(model) : Sensitivity{};
    return wrong([&] { run_sensitivity(model, value, workspace, response, sensitivity); });
  };
  EXPECT_EQ(told(coupon, true), "no error");
  EXPECT_EQ(told(coupon, false), "derivatives that were not made for this model");
  const std::string other =
      "a model that is not a coupon without a break limit and with the stress as its one probe";
  EXPECT_EQ(told(bent(-5.0), true), other);
  Scene two = coupon;
  two.probes.push_back({"strain", ProbeQuantity::Strain});
  EXPECT_EQ(told(two, true), other);
  Scene breaking = coupon;
  breaking.material.break_strain = 0.005;
  EXPECT_EQ(told(breaking, true), other);
}

/// What a run leaves, none before it has left.
TEST(RunMisuse, LeavesNothingOfTheRunBefore) {
  Scene scene = bent(-1.0);
  scene.loads[0].force[1] = -1.6 * testing::yield_moment_of(scene);
  scene.yield_model = YieldModel::PerAxis;
  const Model model = prepare(scene, {}, std::vector<std::string>{"material.youngs_modulus"});
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  run(model, std::vector<double>{200e9}, workspace, response);
  EXPECT_TRUE(response.limit || response.plateau || response.permanent_strain > 0.0);
  run(model, std::vector<double>{-1.0}, workspace, response);
  EXPECT_EQ(response.status, Status::InvalidParameter);
  EXPECT_EQ(response.samples, 0U);
  EXPECT_EQ(response.permanent_strain, 0.0);
  EXPECT_FALSE(response.limit || response.plateau || response.axial);
  EXPECT_EQ(response.counters.steps, 0);
}

TEST(Prepare, RefusesParametersThatWouldMoveNothing) {
  Scene chain = bent(-5.0);
  const Scene coupon = testing::coupon_scene(Deformation::Tension, {0.01});
  const auto refusal = [](const Scene& scene, const std::string& field,
                          const SolverOptions& options = {}) {
    return message_of([&] { prepare(scene, options, std::vector<std::string>{field}); });
  };
  for (const Scene& scene : {chain, coupon}) {
    EXPECT_EQ(refusal(scene, "material.hardening.saturation_stress"),
              "material.hardening.saturation_stress: would move nothing: material.hardening.law is "
              "ideal, which does not have it");
    EXPECT_EQ(refusal(scene, "material.rate.coefficient"),
              "material.rate.coefficient: would move nothing: material.rate.law is none, which "
              "does not have it");
  }
  chain.material.hardening.law = HardeningLaw::Linear;
  EXPECT_EQ(refusal(chain, "material.hardening.tangent_modulus"),
            "material.hardening.tangent_modulus: must be above 0 in the scene to be a parameter of "
            "a chain: whether it hardens decides how strains spread");
  SolverOptions stretching;
  stretching.translation = JointTranslation::Elastic;
  EXPECT_EQ(refusal(chain, "material.poisson_ratio", stretching),
            "material.poisson_ratio: cannot be a parameter of a chain whose joints stretch: its "
            "shear coefficient is laid out with the scene");
}

}  // namespace
}  // namespace plastica
