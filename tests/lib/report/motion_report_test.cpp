#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/support/motion_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::has;

using plastica::testing::cantilever_text;
using plastica::testing::coupon_text;
using plastica::testing::message_of;
using plastica::testing::motion_record;
using plastica::testing::record_of;

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

template <class Write>
std::string csv_of(const Write& write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

TEST(MotionReport, BeginsWithOutcomeSchemeStepAndFrames) {
  const std::string text = scene_report(motion_record());
  EXPECT_TRUE(
      text.starts_with("beam: broken: 2 joints over their limit at 80 ms, 1 joint cut by the "
                       "scene; 3 fragments\n"))
      << text;
  EXPECT_TRUE(has(text,
                  "\n  scheme          generalized_alpha, rho_infinity 0.8\n"
                  "  step            1 ms, fixed\n"
                  "  samples         201, with the shape of 21 frames\n"))
      << text;
  EXPECT_TRUE(has(text, "\n  2010 steps, 4623 iterations, 4 cut-backs\n")) << text;
}

TEST(MotionReport, TellsAdaptiveStepsAndDamping) {
  io::SceneRecord record = motion_record();
  record.setup.solver.scheme = Scheme::EnergyMomentum;
  record.setup.solver.step_error = 1e-5;
  record.setup.solver.damping = Damping::Relaxation;
  record.setup.solver.damping_time = 2e-5;
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "\n  scheme          energy_momentum\n")) << text;
  EXPECT_TRUE(
      has(text,
          "  step            at most 1 ms, as an error of 1e-05 of the length asks for; 1 ms "
          "taken\n"))
      << text;
  EXPECT_TRUE(has(text, "  damping         relaxation, 20 µs\n")) << text;
  EXPECT_FALSE(has(scene_report(record_of(cantilever_text())), "\n  scheme ")) << "statics";
}

TEST(MotionReport, TellsTheStepsThatRanAndWhatCutThem) {
  io::SceneRecord record = motion_record();  // samples 1 ms apart
  record.setup.solver.time_step = 0.05;
  EXPECT_TRUE(has(scene_report(record),
                  "  step            1 ms, fixed: 50 ms are cut to the samples, 1 ms apart\n"))
      << scene_report(record);
  const auto motion = [&] { return nlohmann::json::parse(scene_json(record)).at("motion"); };
  EXPECT_EQ(motion().at("time_step"), 0.05);
  EXPECT_EQ(motion().at("longest_step"), 1e-3);
  EXPECT_EQ(motion().at("step_cut"), "samples");
  record.setup.solver.time_step = 0.7e-3;
  record.response.shortest_step = record.response.longest_step = 0.5e-3;
  EXPECT_TRUE(has(scene_report(record),
                  "  step            500 µs, fixed: 700 µs are cut to divide "
                  "the time between the samples, 1 ms apart\n"))
      << scene_report(record);
  EXPECT_EQ(motion().at("step_cut"), "division");
  record.setup.solver.time_step = 0.5e-3;
  EXPECT_EQ(motion().at("step_cut"), "");
}

TEST(MotionReport, SaysThatMomentumIsOff) {
  io::SceneRecord record = motion_record();
  EXPECT_FALSE(has(scene_report(record), "the momentum of what flies"));
  record.response.momentum_error = 0.12;
  record.response.status = Status::NotBalanced;
  const std::string text = scene_report(record);
  EXPECT_TRUE(text.starts_with("beam: not-balanced")) << text;
  EXPECT_TRUE(has(text, "\n  the momentum of what flies freely is off by 12 %: ")) << text;
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json.at("status"), "not-balanced");
  EXPECT_EQ(json.at("energies").at("momentum_error"), 0.12);
  EXPECT_EQ(json.at("energies").at("balanced"), false);
}

TEST(MotionReport, ListsTheJointsOfAllEventsAndTheFragmentsAfterTheLast) {
  const std::string text = scene_report(motion_record());
  EXPECT_TRUE(has(text, R"(
Breaks and cuts
    time  joint        at  cause      strain  limit      M_x  M_y    T  dissipated  cut
      ms         fraction                  %      %      N m  N m  N m           J
  80.000      6       0.5  bending x   10.02  10.00  -709.50    0    0      7.2500  yes
  80.000      7    0.5833  bending x   10.01  10.00  -702.25    0    0      7.0000   no
  140.00      9      0.75  the scene   0.000      -   12.500    0    0           0  yes

Fragments after the last event
  fragment  segments  count  length      from        to
                                  m  fraction  fraction
         1    0 … 5       6  0.5000     start       0.5
         2    6 … 8       3  0.2500       0.5      0.75
         3    9 … 11      3  0.2500      0.75       end
)")) << text;
}

TEST(MotionReport, TellsBreaksFromCuts) {
  io::SceneRecord record = motion_record();
  auto& events = record.response.chain.events;
  events.pop_back();
  EXPECT_TRUE(has(scene_report(record), "\nBreak\n"));
  for (BrokenJoint& joint : events[0].joints) joint.cause = BreakCause::Cut;
  EXPECT_TRUE(has(scene_report(record), "\nCut\n"));
  events.push_back(events[0]);
  EXPECT_TRUE(has(scene_report(record), "\nCuts\n"));
}

TEST(MotionReport, ListsAtMostTwentyJoints) {
  io::SceneRecord record = motion_record({.segments = 64});
  auto& events = record.response.chain.events;
  const BrokenJoint joint = events[0].joints[0];
  events[0].joints.assign(40, joint);
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "  … 41 joints in all\n")) << text;
  std::size_t rows = 0;
  for (std::size_t at = text.find("bending x "); at != text.npos;
       at = text.find("bending x ", at + 1)) {
    ++rows;
  }
  EXPECT_EQ(rows, 20U);
}

TEST(MotionReport, HasTheEnergiesThatAreNotZero) {
  const std::string text = scene_report(motion_record());
  for (const char* line :
       {"\n  external                20.000  J  ", "\n  kinetic  ", "\n  elastic  ",
        "\n  plastic                 3.2000  J  ", "\n  damping                 2.0000  J  ",
        "\n  numerical dissipation  0.40000  J  ", "\n  fracture                1.0000  J  "}) {
    EXPECT_TRUE(has(text, line)) << line << text;
  }
  EXPECT_FALSE(has(text, "\n  impact ")) << text;
  EXPECT_TRUE(
      has(text,
          "\n  residual               0.00600  J  not explained; at most 0.03 % of the largest\n"))
      << text;
}

TEST(MotionReport, WarnsOfEnergyThatIsNotBalanced) {
  io::SceneRecord record = motion_record();
  record.response.energy_balance_error = 0.0099;
  EXPECT_FALSE(has(scene_report(record), "take smaller steps"));
  record.response.energy_balance_error = 0.032;
  EXPECT_TRUE(has(scene_report(record),
                  "\n  the scheme has made 3.2 % of the energy: take smaller steps\n"));
  for (Energies& energy : record.response.chain.energy) energy.residual = 0.64;
  EXPECT_TRUE(
      has(scene_report(record), "\n  the energy balance is off by 3.2 %: take smaller steps\n"));
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json.at("energies").at("balanced"), false);
  EXPECT_EQ(json.at("energies").at("energy_balance_error"), 0.032);
}

TEST(MotionReport, ListsTheFrequenciesOfDisplacementsAndVelocities) {
  const std::string text = scene_report(motion_record());
  const std::size_t at = text.find("\nFrequencies\n");
  ASSERT_NE(at, text.npos) << text;
  const std::string part = text.substr(at, text.find("\n\n", at + 1) - at);
  EXPECT_TRUE(has(part, "\n  tip       30.002")) << part;
  EXPECT_TRUE(has(part, "\n            150.00")) << part;
  EXPECT_TRUE(has(part, "\n  speed     29.9")) << part;
  EXPECT_TRUE(has(part, "  m/s\n")) << part;
  EXPECT_FALSE(has(part, "kinetic")) << part;
  EXPECT_TRUE(has(part, "found from 10 to 500 Hz, resolved if at least 15 Hz apart")) << part;
}

TEST(MotionReport, HasNoFrequenciesOfStaticsOrFewOrUnevenSamples) {
  EXPECT_FALSE(has(scene_report(record_of(cantilever_text())), "\nFrequencies\n"));
  EXPECT_FALSE(has(scene_report(motion_record({.samples = 15, .frames = 3})), "\nFrequencies\n"));
  io::SceneRecord uneven = motion_record();
  uneven.response.chain.time[50] += 1e-5;
  EXPECT_FALSE(has(scene_report(uneven), "\nFrequencies\n"));
}

TEST(MotionReport, OfAnInterruptedRunSaysWhen) {
  io::SceneRecord record = motion_record({.breaks = false});
  record.response.status = Status::Interrupted;
  EXPECT_EQ(outcome_line(record), "interrupted after 200 ms");
  record.response.status = Status::Completed;
  EXPECT_EQ(outcome_line(record), "completed");
}

TEST(MotionReport, CountsEventsAndFragments) {
  io::SceneRecord record = motion_record();
  auto& events = record.response.chain.events;
  events[1].joints[0].cause = BreakCause::Torsion;
  EXPECT_EQ(outcome_line(record),
            "broken: 3 joints over their limit in 2 events from 80 ms on; 3 fragments");
  events.erase(events.begin());
  events[0].joints[0].cause = BreakCause::Cut;
  record.response.status = Status::Completed;
  EXPECT_EQ(outcome_line(record), "completed: 1 joint cut by the scene; 2 fragments");
}

TEST(MotionReport, TakesPeaksAndReactionsFromTheFramesThatThereAre) {
  io::SceneRecord record = motion_record({.segments = 4, .samples = 41, .frames = 5});
  record.response.chain.plastic_strain[3 * 5 + 1] = 0.5;  // frame 3 is sample 30
  const ScenePeaks peaks = peaks_of(record);
  ASSERT_TRUE(peaks.plastic_strain);
  EXPECT_EQ(peaks.plastic_strain->value, 0.5);
  EXPECT_EQ(peaks.plastic_strain->joint, 1U);
  EXPECT_EQ(peaks.plastic_strain->sample, 30U);
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "\nJoints of 5 frames\n")) << text;
  EXPECT_TRUE(has(text, "  clamp            start  400.00  401.00")) << text;
  record.response.chain.frame_sample.pop_back();  // the last frame is not the last sample
  EXPECT_TRUE(has(scene_report(record), "\nReactions at 150 ms\n"));
}

TEST(MotionReport, IsNowhereWiderThanAHundredColumns) {
  io::SceneRecord record = motion_record({.segments = 64});
  for (ChainBreak& event : record.response.chain.events) {
    for (BrokenJoint& joint : event.joints) joint.moment = {-1.2345e7, -2.3456e6, 3.456e6};
  }
  std::istringstream lines(scene_report(record));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(width_of(line), 100U) << line;
}

TEST(MotionJson, GivesWhatTheReportSaysInSi) {
  const auto json = nlohmann::json::parse(scene_json(motion_record()));
  EXPECT_EQ(json.at("status"), "broken");
  EXPECT_EQ(json.at("motion").at("scheme"), "generalized_alpha");
  EXPECT_EQ(json.at("motion").at("time_step"), 1e-3);
  EXPECT_EQ(json.at("samples"), 201);
  EXPECT_EQ(json.at("frames"), 21);
  ASSERT_EQ(json.at("events").size(), 2U);
  const auto& first = json.at("events").at(0);
  EXPECT_EQ(first.at("joints").at(0).at("cut"), true);
  EXPECT_EQ(first.at("joints").at(1).at("cut"), false);
  EXPECT_EQ(first.at("joints").at(1).at("at"), 7.0 / 12.0);
  EXPECT_EQ(first.at("fragments").at(1).at("first"), 6);
  EXPECT_EQ(first.at("fragments").at(1).at("last"), 11);
  EXPECT_EQ(first.at("fragments").at(1).at("length"), 0.5);
  EXPECT_EQ(json.at("events").at(1).at("joints").at(0).at("cause"), "cut");
  EXPECT_EQ(json.at("energies").at("fracture"), 1.0);
  EXPECT_EQ(json.at("energies").at("balanced"), true);
  EXPECT_NEAR(json.at("energies").at("residual_fraction").get<double>(), 3e-4, 1e-12);
  EXPECT_NEAR(json.at("frequencies").at("tip").at(1).at("frequency"), 150.0, 0.01);
  EXPECT_FALSE(json.at("frequencies").contains("kinetic"));
  EXPECT_EQ(json.at("reactions").at(0).at("force").at(0), 2000.0);
  EXPECT_TRUE(
      nlohmann::json::parse(scene_json(record_of(cantilever_text()))).at("motion").is_null());
}

TEST(MotionTable, OfTheEnergiesHasARowPerSample) {
  const std::string text =
      csv_of([](std::ostream& out) { write_energies_csv(out, motion_record()); });
  EXPECT_TRUE(text.starts_with(
      "sample,time [s],external [J],kinetic [J],elastic [J],plastic [J],"
      "damping [J],numerical_dissipation [J],impact [J],fracture [J],residual [J]\n"
      "0,0,20,"))
      << text.substr(0, 200);
  EXPECT_EQ(lines_of(text), 202U);
}

TEST(MotionTable, OfTheEventsHasARowPerJoint) {
  const std::string text =
      csv_of([](std::ostream& out) { write_events_csv(out, motion_record({.segments = 8})); });
  EXPECT_EQ(lines_of(text), 4U);
  EXPECT_TRUE(has(text, ",4,0.5,bending_x,1,0.1002,0.1,-709.5,0,0,-0.4,0,0,7.25\n")) << text;
  EXPECT_TRUE(has(text, ",6,0.75,cut,1,0,0,12.5,0,0,0,0,0,0\n")) << text;
}

TEST(MotionTable, OfTheFragmentsHasARowPerFragmentAfterEachEvent) {
  const std::string text =
      csv_of([](std::ostream& out) { write_fragments_csv(out, motion_record({.segments = 8})); });
  EXPECT_EQ(lines_of(text), 6U);
  EXPECT_TRUE(has(text, ",4,7,0.5,1\n") && has(text, ",4,5,0.5,0.75\n")) << text;
}

TEST(MotionTable, OfASpectrumHasARowPerFrequencyAndAColumnPerProbe) {
  const std::string text =
      csv_of([](std::ostream& out) { write_spectrum_csv(out, motion_record()); });
  EXPECT_TRUE(text.starts_with("frequency [Hz],tip [m],speed [m/s],kinetic [J]\n0,")) << text;
  EXPECT_EQ(lines_of(text), 1U + 513U);
  std::ostringstream none;
  EXPECT_EQ(message_of([&] { write_spectrum_csv(none, record_of(cantilever_text())); }),
            "--what = spectrum: needs a motion of at least 16 samples at even times");
}

TEST(MotionTable, OfTheJointsIsOfTheFrameNextToATime) {
  const io::SceneRecord record = motion_record({.segments = 4, .samples = 41, .frames = 5});
  const auto at = [&](std::optional<double> time) {
    return csv_of([&](std::ostream& out) { write_joints_csv(out, record, time); });
  };
  EXPECT_EQ(at(0.2), at({}));
  EXPECT_NE(at(0.1), at({}));
  EXPECT_TRUE(has(at(0.1), "\n0,0,0,0,0,-100,0,0,0,100,0,0.02,0,0,")) << at(0.1);
}

TEST(MotionTable, IsRefusedOfACoupon) {
  const io::SceneRecord coupon = record_of(coupon_text());
  std::ostringstream out;
  for (const auto& write : {write_energies_csv, write_events_csv, write_fragments_csv}) {
    EXPECT_THROW(write(out, coupon), InputError);
  }
  EXPECT_EQ(message_of([&] { write_events_csv(out, coupon); }),
            "--what = events: is not of a coupon, which has none");
}

}  // namespace
}  // namespace plastica::report
