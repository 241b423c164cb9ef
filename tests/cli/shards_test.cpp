#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"
#include "tests/support/has.hpp"

/// Runs that are computed in shards, and merged: the result of one run, or a refusal.
namespace plastica::testing {
namespace {

using Words = std::vector<std::string>;

class Shards : public ::testing::Test {
 protected:
  /// Runs a command once as a whole, to one.h5, and in so many shards, merged to all.h5.
  void expect_the_same(const Words& command, int count, int code = 0) const {
    CommandResult ran = run(command, {"-o", "one.h5", "--quiet", "--force"});
    ASSERT_EQ(ran.code, code) << ran.err;
    Words merge{"merge"};
    for (int k = count; k >= 1; --k) {
      ran = run(command, {"-o", "all.h5", "--shard", fmt::format("{}/{}", k, count)});
      ASSERT_EQ(ran.code, 0) << ran.err;
      EXPECT_EQ(ran.out, "");
      merge.push_back(fmt::format("all.h5.shard-{}-of-{}", k, count));
    }
    EXPECT_FALSE(place_.has("all.h5"));
    ran = run(merge, {"-o", "all.h5", "--quiet"});
    ASSERT_EQ(ran.code, code) << ran.err;
    expect_same_bits(place_, {"one.h5", "all.h5"});
    EXPECT_FALSE(place_.has("all.h5.journal"));
    std::filesystem::remove(place_.path("all.h5"));
  }

  CommandResult run(Words command, const Words& more) const {
    command.insert(command.begin() + 1, more.begin(), more.end());
    return place_.run(command);
  }

  void write_curves(int count) const {
    for (int i = 0; i < count; ++i) {
      place_.write(fmt::format("curve-{}.csv", i), broken_curve(300.0 + i, i));
    }
  }

  Workplace place_;
};

// One curve is bad, so that the exit code of the whole run is 1; a shard has done its work.
TEST_F(Shards, OfAFitFileMakeTheResultOfOneRun) {
  write_curves(10);
  place_.write("curve-7.csv", "");
  place_.write("fit.toml", fit_file("'curve-*.csv'"));
  for (const int count : {1, 3, 7, 13}) expect_the_same({"calibrate", "fit.toml"}, count, 1);
}

// All that a command line says goes to the shards' files, and is said again by merge.
TEST_F(Shards, OfBareCurvesWithOptionsMakeTheResultOfOneRun) {
  write_curves(10);
  place_.write("a b.csv", broken_curve(320.0, 11));
  expect_the_same({"calibrate", "a b.csv", "curve-1.csv", "curve-2.csv", "--strain", "Strain",
                   "--stress=Stress:MPa", "--laws", "ideal,linear", "--fix",
                   "youngs_modulus=200 GPa", "--fix=break_strain=2 %", "--profile", "--bootstrap",
                   "20", "--no-modulus-prior", "--isa", "baseline"},
                  3);
}

TEST_F(Shards, OfASweepMakeTheResultOfOneRun) {
  ASSERT_EQ(place_.run({"init", "sweep"}).code, 0);
  for (const int count : {1, 3, 7}) expect_the_same({"sweep", "sweep.toml"}, count);
  expect_the_same({"sweep", "sweep.toml", "--isa=baseline"}, 2);
}

/// Five bars that are pushed down by 60 mm, and a fit of each by two laws.
void write_pushed_bars(const Workplace& place) {
  place.write(
      "bar.toml",
      "beam = { length = '400 mm', segments = 6, section = { shape = 'rectangle', "
      "width = '20 mm', height = '20 mm' } }\n"
      "material = { name = 'S355', hardening = { law = 'linear', tangent_modulus = '10 GPa' "
      "} }\n"
      "[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[support]]\nat = 'end'\nkind = 'roller'\nhold = ['y']\n"
      "translation = ['0 mm', '-60 mm', '0 mm']\n"
      "[[probe]]\nname = 'force'\nkind = 'reaction'\nat = 'end'\ncomponent = 'y'\n");
  for (int k = 0; k < 5; ++k) {
    std::string curve = "Displacement (mm),Force (N)\n";
    for (int i = 1; i <= 20; ++i) {
      const double displacement = 3.0 * i;
      curve += fmt::format("{},{}\n", displacement,
                           (2300.0 + 40.0 * k) * std::tanh(displacement / 18.0) + displacement);
    }
    place.write(fmt::format("bar-{}.csv", k), curve);
  }
}

constexpr const char* kBars =
    "fit.shared = false\nfit.starts = 1\nfit.evaluations = 30\nfit.laws = ['ideal', 'linear']\n"
    "fit.parameters.yield_stress = { bounds = ['20 MPa', '20 GPa'] }\n"
    "[[target]]\nfiles = 'bar-*.csv'\nscene = 'bar.toml'\n"
    "abscissa = { drive = 'support[2]', column = 'Displacement' }\n"
    "ordinate = { probe = 'force', column = 'Force', factor = -1 }\n";

// Laws of one specimen go together: the simpler one's best point is a start of the other.
TEST_F(Shards, OfFitsThroughScenesMakeTheResultOfOneRun) {
  write_pushed_bars(place_);
  place_.write("fit.toml", std::string("fit.segments_error = false\n") + kBars);
  expect_the_same({"calibrate", "fit.toml"}, 3);
}

// A refused command leaves the shard as it is, whatever is forced.
TEST_F(Shards, CannotTellWhichLawAllFitsAdvise) {
  write_pushed_bars(place_);
  place_.write("all.h5.shard-1-of-2", "mine");
  place_.write("fit.toml", kBars);
  const auto before = place_.contents();
  for (const char* more : {"--force", "--dry-run"}) {
    const CommandResult result =
        place_.run({"calibrate", "fit.toml", "-o", "all.h5", "--shard", "1/2", more});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(
        result.err,
        "plastica: --shard: cannot tell which law all fits together advise, and that alone gets "
        "intervals and other numbers of segments: ask for no intervals, and set segments_error "
        "= false\n");
    EXPECT_EQ(place_.contents(), before);
  }
}

// What the command line says is said again as it was meant.
TEST_F(Shards, KnowFilesThatLookLikeOptionsAndFlagsThatAreOff) {
  write_curves(2);
  place_.write("-c.csv", broken_curve(320.0, 11));
  expect_the_same({"calibrate", "--profile=false", "--strain", "Strain", "--stress", "Stress:MPa",
                   "--bootstrap=0", "--", "curve-0.csv", "-c.csv"},
                  2);
}

TEST_F(Shards, HaveTheInputsOfTheFirstInWhateverOrderTheyAreNamed) {
  write_curves(3);
  place_.write("a.toml", fit_file("'curve-*.csv'"));
  place_.write("b.toml", "# the same\n" + fit_file("'curve-*.csv'"));
  ASSERT_EQ(run({"calibrate", "a.toml", "-o", "all.h5", "--shard", "1/2", "--quiet"}, {}).code, 0);
  ASSERT_EQ(run({"calibrate", "b.toml", "-o", "all.h5", "--shard", "2/2", "--quiet"}, {}).code, 0);
  const std::string one = "all.h5.shard-1-of-2", two = "all.h5.shard-2-of-2";
  ASSERT_EQ(place_.run({"merge", one, two, "-o", "up.h5", "--quiet"}).code, 0);
  ASSERT_EQ(place_.run({"merge", two, one, "-o", "down.h5", "--quiet"}).code, 0);
  expect_same_bits(place_, {"up.h5", "down.h5"});
}

TEST_F(Shards, OfASweepReplaceWhateverIsForced) {
  ASSERT_EQ(place_.run({"init", "sweep"}).code, 0);
  ASSERT_EQ(place_.run({"sweep", "sweep.toml", "-o", "all.h5", "--shard", "1/1", "--quiet"}).code,
            0);
  const Words merge{"merge", "all.h5.shard-1-of-1", "-o", "all.h5", "--quiet", "--force"};
  place_.write("all.h5", "some text");
  place_.write("all.h5.journal", "some other text");
  const CommandResult merged = place_.run(merge);
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(place_.read("all.h5.journal"), "some other text");
  ASSERT_EQ(place_.run({"sweep", "sweep.toml", "-o", "one.h5", "--quiet"}).code, 0);
  expect_same_bits(place_, {"one.h5", "all.h5"});

  place_.write("cantilever.toml",
               place_.read("cantilever.toml") + "\n[[mass]]\nat = 'end'\nmass = '1 kg'\n");
  place_.write("all.h5", "some text");
  const CommandResult changed = place_.run(merge);
  EXPECT_EQ(changed.code, 2);
  EXPECT_TRUE(changed.err.starts_with("plastica: shards: were computed of other inputs"))
      << changed.err;
  EXPECT_EQ(place_.read("all.h5"), "some text");
}

TEST_F(Shards, ThatWereKilledGoOnByResume) {
  write_curves(40);
  place_.write("fit.toml", fit_file("'curve-*.csv'", "laws = ['ideal', 'linear', 'voce']"));
  const Words command{"calibrate", "fit.toml", "-o", "all.h5", "--threads", "1"};
  Words resumed = command;
  resumed.insert(resumed.end(), {"--shard", "1/2", "--resume"});
  const std::string path = "all.h5.shard-1-of-2";
  RunningCommand running = place_.start(resumed);
  const auto size = [&] {
    std::error_code absent;
    const auto bytes = std::filesystem::file_size(place_.path(path), absent);
    return absent ? 0 : bytes;
  };
  while (running.runs() && size() < 40'000) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  running.send(SIGKILL);
  ASSERT_EQ(running.wait().code, 128 + SIGKILL);
  ASSERT_EQ(run(command, {"--shard", "2/2", "--quiet"}).code, 0);

  const Words merge{"merge", path, "all.h5.shard-2-of-2", "-o", "all.h5", "--quiet"};
  CommandResult result = place_.run(merge);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "plastica: " + path + ": is shard 1 of 2, and not complete: --resume of it goes on\n");
  result = place_.run(resumed);
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result.err, "fits resumed from the journal\n")) << result.err;
  EXPECT_TRUE(has(result.err, "wrote " + path + ": shard 1 of 2, 60 of 120 fits\n")) << result.err;
  result = place_.run(resumed);
  EXPECT_EQ(result.err, path + " is complete: nothing is left to do\n");
  EXPECT_EQ(result.code, 0);
  ASSERT_EQ(place_.run(merge).code, 0);
  ASSERT_EQ(place_.run({"calibrate", "fit.toml", "-o", "one.h5", "--quiet"}).code, 0);
  expect_same_bits(place_, {"one.h5", "all.h5"});
}

/// A run in two shards whose inputs change before they are merged: refused, and nothing is left.
class ChangedShards : public Shards {
 protected:
  ChangedShards() {
    write_curves(4);
    place_.write("fit.toml", fit_file("'curve-*.csv'"));
    for (const char* part : {"1/2", "2/2"}) {
      run({"calibrate", "fit.toml", "-o", "all.h5", "--quiet", "--shard", part}, {});
    }
  }

  void expect_refusal(const std::string& beginning) const {
    const auto before = place_.contents();
    const CommandResult merged = place_.run(
        {"merge", "all.h5.shard-1-of-2", "all.h5.shard-2-of-2", "-o", "all.h5", "--quiet"});
    EXPECT_EQ(merged.code, 2);
    EXPECT_EQ(merged.out, "");
    EXPECT_TRUE(merged.err.starts_with("plastica: " + beginning)) << merged.err;
    EXPECT_EQ(lines_of(merged.err), 1U) << merged.err;
    EXPECT_EQ(place_.contents(), before);
  }
};

constexpr const char* kOtherInputs = "shards: were computed of other inputs, options or version";

TEST_F(ChangedShards, ByACurveAreRefused) {
  place_.write("curve-2.csv", broken_curve(500.0, 2));
  expect_refusal(kOtherInputs);
}

TEST_F(ChangedShards, ByASampleThatDecidesNothingAreRefused) {
  place_.write("curve-2.csv", place_.read("curve-2.csv") + "9,0\n");
  expect_refusal(kOtherInputs);
}

TEST_F(ChangedShards, ByACurveMoreAreRefused) {
  place_.write("curve-9.csv", broken_curve(500.0, 2));
  expect_refusal(kOtherInputs);
}

TEST_F(ChangedShards, ByAnOptionOfTheFitFileAreRefused) {
  place_.write("fit.toml", fit_file("'curve-*.csv'", "confidence = 0.9"));
  expect_refusal(kOtherInputs);
}

TEST_F(ChangedShards, ByAFitFileThatIsGoneAreRefused) {
  std::filesystem::remove(place_.path("fit.toml"));
  expect_refusal("shards = fit.toml: is what they read, and is not here: run merge where they ran");
}

TEST_F(ChangedShards, ByAnOutputThatIsThereAreRefused) {
  place_.write("all.h5", "mine");
  expect_refusal("all.h5: exists already: use --force to overwrite it");
}

TEST_F(Shards, AreSaidByADryRun) {
  write_curves(4);
  const CommandResult result =
      place_.run({"calibrate", "curve-1.csv", "curve-2.csv", "--shard", "2/7", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.out.ends_with(
      "shard 2 of 7 would be one in 7 of these, written to fit.h5.shard-2-of-7\n"))
      << result.out;
}

// As Open MPI starts four of them.
TEST_F(Shards, AreThoseOfTheProcessesOfAnMpiJob) {
  write_curves(3);
  for (const char* rank : {"0", "1", "2", "3"}) {
    const CommandResult result =
        place_.run({"calibrate", "curve-0.csv", "curve-1.csv", "curve-2.csv", "-o", "all.h5",
                    "--shard", "auto", "--quiet"},
                   {std::string("OMPI_COMM_WORLD_RANK=") + rank, "OMPI_COMM_WORLD_SIZE=4"});
    ASSERT_EQ(result.code, 0) << result.err;
  }
  const CommandResult merged =
      place_.run({"merge", "all.h5.shard-1-of-4", "all.h5.shard-2-of-4", "all.h5.shard-3-of-4",
                  "all.h5.shard-4-of-4", "-o", "all.h5", "--quiet"});
  EXPECT_EQ(merged.code, 0) << merged.err;
}

class BadShard : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadShard, IsRefusedInOneLine) { expect_refusal(GetParam()); }

const std::map<std::string, std::string> kCurve{{"a.csv", broken_curve()}};

INSTANTIATE_TEST_SUITE_P(
    Input, BadShard,
    ::testing::Values(
        BadInput{"no_part",
                 kCurve,
                 {"calibrate", "a.csv", "--shard", "3"},
                 "--shard = 3: must be the number of a shard and how many there are, such as 2/7"},
        BadInput{"part_beyond",
                 kCurve,
                 {"calibrate", "a.csv", "--shard", "3/2", "--dry-run"},
                 "--shard = 3/2: the number of a shard must be 1 … 2"},
        BadInput{"empty",
                 kCurve,
                 {"calibrate", "a.csv", "--shard", ""},
                 "argument 4, behind --shard: is empty"},
        BadInput{"auto_alone",
                 kCurve,
                 {"calibrate", "a.csv", "--shard", "auto"},
                 "--shard = auto: needs several processes of mpirun or srun, which tell each its "
                 "number; a task of an array says its own: --shard $SLURM_ARRAY_TASK_ID/N"},
        BadInput{"json",
                 kCurve,
                 {"calibrate", "a.csv", "--shard", "1/2", "--json", "a.json"},
                 "--json: is of all of a run: plastica export makes it of the merged result"},
        BadInput{"curve_to_merge",
                 kCurve,
                 {"merge", "a.csv", "-o", "a.h5"},
                 "a.csv: is no shard of a run"},
        BadInput{"nothing_to_merge",
                 {},
                 {"merge", "a.h5.shard-1-of-2", "-o", "a.h5"},
                 "a.h5.shard-1-of-2: is not there"},
        BadInput{"no_output", kCurve, {"merge", "a.csv"}, "--output…"},
        BadInput{"output_is_the_shard",
                 kCurve,
                 {"merge", "a.csv", "-o", "a.csv", "--force"},
                 "--output = a.csv: is a file that this run reads"}),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
