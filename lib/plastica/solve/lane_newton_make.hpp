#pragma once

#include <cstddef>
#include <tuple>

#include "plastica/base/pack.hpp"
#include "plastica/chain/lane_fields.hpp"
#include "plastica/solve/lane_newton.hpp"
#include "plastica/solve/newton_step.hpp"
#include "plastica/solve/stability_count.hpp"

/// Defines the iterations in lanes for the instruction set that a file is compiled for.
namespace plastica::solve {
PLASTICA_KERNELS_BEGIN

using LaneScalar = Pack<double, kPathLanes>;

/// Makes room for a shape.
struct ShapeReader {
  const std::size_t* from;
  template <class Values>
  void size(Values& values) {
    values.clear();
    values.resize(*from++);
  }
  void index(std::size_t& index) { index = *from++; }
  void flag(bool& flag) { flag = *from++ != 0; }
  void number(LaneScalar& /*number*/) {}
};

/// Sets the numbers of a lane.
struct LaneWriter {
  int lane;
  const double* from;
  template <class Values>
  void size(Values& /*values*/) {}
  void index(std::size_t& /*index*/) {}
  void flag(bool& /*flag*/) {}
  void number(LaneScalar& number) { number.set(lane, *from++); }
};

/// Gives them back.
struct LaneReader {
  int lane;
  double* to;
  void number(const LaneScalar& number) { *to++ = number[lane]; }
};

template <class Law>
struct VisitLaw {
  template <class V>
  void operator()(V& visitor, Law& law) const {
    chain::visit_law(visitor, law);
  }
};

template <template <class> class Level, class Law>
class LaneNewtonOf final : public LaneNewton {
 public:
  using L = chain::InLanes<Level<LaneScalar>>;

  void take_shape(const std::size_t* shape) override {
    ShapeReader reader{shape};
    chain::visit_chain(reader, chain_);
    joints_.visit(reader, VisitLaw<Law>{});
    work_.resize(chain_);
  }

  void take_chain(int lane, const double* numbers) override {
    LaneWriter writer{lane, numbers};
    chain::visit_chain(writer, chain_);
    joints_.visit(writer, VisitLaw<Law>{});
  }

  void take_start(int lane, const double* start) override {
    LaneWriter writer{lane, start};
    chain::visit_unknowns(writer, work_.q);
    writer.number(work_.moment_scale);
    writer.number(work_.force_scale);
    writer.number(work_.stepped);
    for (auto& history : chain_.histories) writer.number(history.now);
    joints_.visit_states(writer, VisitState{});
  }

  void evaluate(double* imbalance) override {
    detail::assemble(chain_, joints_, work_);
    work_.recursion.factor(chain_, work_.q, work_.placement, work_.stage, work_.joints,
                           work_.outer_forces, work_.transmitted);
    detail::relative_imbalance(chain_, work_).store(imbalance);
  }

  void count_unstable_modes(double* counts) override {
    unstable_modes(chain_, PathCondition<L>{}, false, work_).store(counts);
  }

  void step() override {
    const PathCondition<L> at_its_time;
    detail::solve_imbalance(chain_, at_its_time, work_);
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      detail::solve_constraint(chain_, k, work_);
    }
    detail::join_columns(chain_, at_its_time, work_);
    detail::combine_columns(chain_, at_its_time, work_);
    const LaneScalar zero = constant<LaneScalar>(0);
    detail::take_step(chain_, at_its_time, zero < zero, work_);
  }

  void read(int lane, double* found) override {
    LaneReader reader{lane, found};
    chain::visit_unknowns(reader, work_.q);
    reader.number(work_.moment_scale);
    reader.number(work_.force_scale);
  }

  void read_places(int lane, double* places) override {
    LaneReader reader{lane, places};
    chain::visit_places(reader, work_.placement);
  }

  void read_trial(int lane, double* trial) override {
    LaneReader reader{lane, trial};
    joints_.visit_trial(reader, VisitState{});
  }

 private:
  struct VisitState {
    template <class V, class State>
    void operator()(V& visitor, State& state, std::size_t first, std::size_t count) const {
      chain::visit_state(visitor, state, first, count);
    }
  };

  chain::Chain<L> chain_;
  chain::SectionJoints<L, false, Law> joints_{{}, {}, {}};
  NewtonWork<L, false> work_;
};

template <class Base, class Of>
Base* make_lanes() {
  return new Of;
}

/// What makes each law's lanes, in the plane and in space.
template <class Table, class Base, template <template <class> class, class> class Of>
constexpr Table lane_table() {
  return []<class... Law>(std::tuple<Law...>*) {
    return Table{{make_lanes<Base, Of<chain::Planar, Law>>...},
                 {make_lanes<Base, Of<chain::Spatial, Law>>...}};
  }(static_cast<chain::LaneLaws<LaneScalar>*>(nullptr));
}

constexpr LaneNewtonTable newton_table() {
  return lane_table<LaneNewtonTable, LaneNewton, LaneNewtonOf>();
}

PLASTICA_KERNELS_END
}  // namespace plastica::solve
