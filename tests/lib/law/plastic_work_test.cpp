#include "plastica/law/plastic_work.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"

namespace plastica::law {
namespace {

const std::vector<double> kCycle{0.001, 0.004, 0.01, 0.008, 0.0, -0.01, -0.012, 0.003, 0.02};

template <class S>
IdealPlastic<S> ideal() {
  return {constant<S>(200e9), constant<S>(1.0) / constant<S>(200e9), constant<S>(300e6)};
}
template <class S>
LinearHardening<S> linear() {
  return {constant<S>(200e9), constant<S>(300e6), constant<S>(2e9), constant<S>(3e9)};
}
template <class S>
VoceChaboche<S> voce() {
  return {constant<S>(200e9),
          constant<S>(300e6),
          constant<S>(80e6),
          constant<S>(12.0),
          {constant<S>(20e9), constant<S>(4e9), constant<S>(0.5e9)},
          {constant<S>(300.0), constant<S>(1e-3), constant<S>(0.0)}};
}

template <class S>
Multilinear<S> table() {
  const auto of = [](double a, double b, double c) {
    std::array<S, Multilinear<S>::kLines> row{};
    row[0] = constant<S>(a);
    row[1] = constant<S>(b);
    row[2] = constant<S>(c);
    return row;
  };
  return {constant<S>(200e9), constant<S>(300e6),   constant<S>(0.4),       constant<S>(0.6),
          constant<S>(1e9),   of(0.0, 0.002, 0.01), of(0.002, 0.008, 0.03), of(15e9, -1e9, 2e9)};
}

/// Work of a path whose increments are cut in `parts`: exactly, or by trapezoids.
template <class S, class Law>
S work_of(const Law& law, int parts, bool trapezoid) {
  typename Law::State state;
  S work{};
  S stress{};
  double from = 0.0;
  for (const double to : kCycle) {
    for (int i = 1; i <= parts; ++i) {
      const auto now = respond(law, state, constant<S>(from + (to - from) * i / parts));
      const S flow = now.state.plastic - state.plastic;
      work += trapezoid ? constant<S>(0.5) * (stress + now.stress) * flow
                        : plastic_work(law, state, now);
      state = now.state;
      stress = now.stress;
    }
    from = to;
  }
  return work;
}

template <class Law>
void expect_exact(const Law& law) {
  const double exact = work_of<double>(law, 1, false);
  EXPECT_GT(exact, 0.0);
  EXPECT_NEAR(work_of<double>(law, 7, false), exact, 1e-9 * exact);
  EXPECT_NEAR(work_of<double>(law, 20000, true), exact, 1e-4 * exact);
}

TEST(PlasticWork, OfAnIncrementIsTheIntegralOverItsParts) {
  expect_exact(ideal<double>());
  expect_exact(linear<double>());
  expect_exact(voce<double>());
  expect_exact(table<double>());
}

TEST(PlasticWork, OfIdealPlasticityIsTheYieldStressTimesThePlasticPath) {
  const auto law = ideal<double>();
  const auto now = respond(law, {}, -0.0115);
  EXPECT_DOUBLE_EQ(plastic_work(law, {}, now), 300e6 * 0.01);
}

TEST(PlasticWork, IsZeroWithinTheElasticRange) {
  EXPECT_EQ(plastic_work(ideal<double>(), {}, respond(ideal<double>(), {}, 0.001)), 0.0);
  EXPECT_EQ(plastic_work(linear<double>(), {}, respond(linear<double>(), {}, 0.001)), 0.0);
  EXPECT_EQ(plastic_work(voce<double>(), {}, respond(voce<double>(), {}, 0.001)), 0.0);
  EXPECT_EQ(plastic_work(table<double>(), {}, respond(table<double>(), {}, 0.001)), 0.0);
}

template <template <class> class Law, class Make>
void expect_same_for_all_scalars(const Make& make) {
  using Lanes = Pack<double, 8>;
  using D = Dual<double, 1>;
  const double expected = work_of<double>(make.template operator()<double>(), 3, false);
  EXPECT_EQ(work_of<Lanes>(make.template operator()<Lanes>(), 3, false)[5], expected);
  EXPECT_EQ(work_of<D>(make.template operator()<D>(), 3, false).value(), expected);
  const float single = work_of<float>(make.template operator()<float>(), 3, false);
  EXPECT_NEAR(static_cast<double>(single), expected, 1e-3 * expected);
}

TEST(PlasticWork, TakesEveryScalar) {
  expect_same_for_all_scalars<IdealPlastic>([]<class S>() { return ideal<S>(); });
  expect_same_for_all_scalars<LinearHardening>([]<class S>() { return linear<S>(); });
  expect_same_for_all_scalars<VoceChaboche>([]<class S>() { return voce<S>(); });
  expect_same_for_all_scalars<Multilinear>([]<class S>() { return table<S>(); });
}

}  // namespace
}  // namespace plastica::law
