#include <gtest/gtest.h>

#include <fmt/format.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "tests/cli/command.hpp"
#include "tests/cli/curves.hpp"

// What the machine and other processes do to a run: closed streams, two runs at once, files that
// are no files, too little memory for threads, flipped bits.

namespace plastica::testing {
namespace {

namespace fs = std::filesystem;

class Faults : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(place_.run({"init", "scene"}).code, 0);
    ASSERT_EQ(place_.run({"init", "fit"}).code, 0);
  }

  /// Runs a line of the shell in which `$P` is the command.
  CommandResult shell(const std::string& line) const {
    return place_.run_program("/bin/sh",
                              {"-c", std::string("P=") + PLASTICA_COMMAND + "; " + line});
  }

  Workplace place_;
};

TEST_F(Faults, AClosedOrFullErrorStreamLosesNothing) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  for (const std::string streams : {"2>&-", "2>/dev/full", "2>&- <&-"}) {
    const CommandResult ended = shell("$P simulate scene.toml -o b.h5 --force " + streams);
    EXPECT_EQ(ended.code, 0) << streams;
    EXPECT_EQ(place_.run({"show", "b.h5"}).out, place_.run({"show", "a.h5"}).out) << streams;
    EXPECT_EQ(shell("$P simulate none.toml " + streams).code, 2) << streams;
    EXPECT_EQ(shell("$P show " + streams).code, 2) << streams;
  }
  EXPECT_EQ(place_.read("b.h5").size(), place_.read("a.h5").size());
}

TEST_F(Faults, AClosedOrFullStandardOutputIsAFailureThatKeepsTheResult) {
  for (const std::string streams : {">&-", ">/dev/full", ">&- 2>&-"}) {
    EXPECT_EQ(shell("$P simulate scene.toml -o a.h5 --force " + streams).code, 3) << streams;
    EXPECT_EQ(place_.run({"show", "a.h5"}).code, 0) << streams;
  }
}

TEST_F(Faults, OfTwoSimulationsWithOneOutputOneIsToldThatItIsInUse) {
  std::string scene = place_.read("scene.toml");
  ASSERT_NE(scene.find("segments = 32"), std::string::npos);
  scene.replace(scene.find("segments = 32"), 13, "segments = 20000");
  place_.write("long.toml", scene);
  RunningCommand first = place_.start({"simulate", "long.toml", "-o", "a.h5", "--force"});
  while (first.runs() && !place_.has("a.h5.lock")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const CommandResult second = shell(
      "$P simulate scene.toml -o a.h5 --force 2>said; rc=$?; cat "
      "said; exit $rc");
  if (first.runs()) {
    EXPECT_EQ(second.code, 3);
    EXPECT_EQ(second.out, "plastica: a.h5: is in use by another run\n");
  }
  first.send(SIGKILL);
  EXPECT_EQ(first.wait().code, 128 + SIGKILL);
  // The lock of one that was killed stops nobody.
  EXPECT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  EXPECT_FALSE(place_.has("a.h5.lock"));
}

TEST_F(Faults, AnOutputThatIsNoFileOfItsOwnIsRefused) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  fs::create_symlink("a.h5", place_.path("link.h5"));
  ASSERT_EQ(::mkfifo(place_.path("pipe.csv").c_str(), 0600), 0);
  const auto refused = [&](std::vector<std::string> arguments, const std::string& said) {
    const CommandResult ended = place_.run(arguments);
    EXPECT_EQ(ended.code, 2) << arguments[0];
    EXPECT_EQ(ended.err, "plastica: " + said + "\n") << arguments[0];
  };
  const std::string bytes = place_.read("a.h5");
  refused({"simulate", "scene.toml", "-o", "link.h5", "--force"},
          "link.h5: is a link: name the file that it leads to");
  refused({"export", "a.h5", "-o", "pipe.csv", "--force"},
          "pipe.csv: cannot be written: it is a named pipe");
  refused({"export", "a.h5", "-o", "/dev/null", "--force"},
          "/dev/null: cannot be written: it is a device");
  refused({"plot", "a.h5", "-o", "a.h5", "--force"},
          "--output = a.h5: is a file that this run reads");
  refused({"simulate", "scene.toml", "-o", "b.h5", "--json", "./b.h5.lock"},
          "--json = ./b.h5.lock: is where the lock of the result file goes");
  refused({"calibrate", "fit.toml", "-o", "b.h5", "--json", "b.h5.journal"},
          "--json = b.h5.journal: is where the journal of the run goes");
  refused({"calibrate", "fit.toml", "-o", "b.h5", "--json", "b.h5"},
          "--json = b.h5: is the output, too");
  EXPECT_EQ(place_.read("a.h5"), bytes);
  EXPECT_FALSE(place_.has("b.h5"));
}

TEST_F(Faults, AFileThatIsReplacedKeepsItsMode) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  ASSERT_EQ(place_.run({"export", "a.h5", "-o", "a.csv"}).code, 0);
  for (const char* name : {"a.h5", "a.csv"}) ::chmod(place_.path(name).c_str(), 0640);
  place_.write("a.h5.part", "mine");
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5", "--force"}).code, 0);
  ASSERT_EQ(place_.run({"export", "a.h5", "-o", "a.csv", "--force"}).code, 0);
  for (const char* name : {"a.h5", "a.csv"}) {
    EXPECT_EQ(fs::status(place_.path(name)).permissions(), static_cast<fs::perms>(0640)) << name;
  }
  EXPECT_EQ(place_.read("a.h5.part"), "mine");
}

TEST_F(Faults, AFullDiskLeavesTheOlderExport) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  ASSERT_EQ(place_.run({"export", "a.h5", "--to", "json", "-o", "a.json"}).code, 0);
  const std::string before = place_.read("a.json");
  const CommandResult ended =
      shell("trap '' XFSZ; ulimit -f 1; $P export a.h5 --to json -o a.json --force");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(place_.read("a.json"), before);
}

TEST_F(Faults, AFlippedBitIsSeenWhereverAResultIsRead) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "a.h5"}).code, 0);
  const std::string bytes = place_.read("a.h5");
  for (const double fraction : {0.01, 0.3, 0.6, 0.99}) {
    std::string damaged = bytes;
    char& byte = damaged[static_cast<std::size_t>(fraction * static_cast<double>(bytes.size()))];
    byte = static_cast<char>(byte ^ 16);
    place_.write("a.h5", damaged);
    for (const char* command : {"show", "plot", "export"}) {
      const CommandResult ended = place_.run({command, "a.h5"});
      EXPECT_EQ(ended.code, 2) << command << fraction;
      EXPECT_EQ(ended.out, "") << command << fraction;
      EXPECT_EQ(lines_of(ended.err), 1U) << ended.err;
    }
  }
  // As older versions wrote it: read, and said that damage cannot be detected.
  place_.write("a.h5", bytes.substr(512));
  const CommandResult ended = place_.run({"show", "a.h5"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.err.find("warning: a.h5: has no digest"), std::string::npos) << ended.err;

  // Damaged, such a file may be read, but ends no command.
  std::mt19937_64 random(1);
  for (int i = 0; i < 30; ++i) {
    std::string damaged = bytes.substr(512);
    char& byte = damaged[random() % damaged.size()];
    byte = static_cast<char>(byte ^ (1 << (random() % 8)));
    place_.write("b.h5", damaged);
    EXPECT_LE(place_.run({"show", "b.h5"}).code, 3) << i;
  }
}

TEST_F(Faults, ThreadsThatCannotBeMadeOrHaveNoRoomAreTold) {
  place_.write("sweep.toml",
               "scene = 'scene.toml'\n[[axis]]\nfield = 'beam.segments'\nvalues = "
               "[4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19]\n"
               "[error]\nprobe = 'tip'\n");
  const std::string sweep = "$P sweep sweep.toml -o a.h5 --quiet --force --threads ";
  const CommandResult plain = shell(sweep + "16");
  ASSERT_EQ(plain.code, 0) << plain.err;
  const CommandResult small = shell("OMP_STACKSIZE=16k " + sweep + "2");
  EXPECT_EQ(small.code, 3);
  EXPECT_EQ(small.err,
            "plastica: the stacks of threads are too small: set OMP_STACKSIZE, or ulimit "
            "-s, to 128k or more\n");
  const CommandResult large = shell("ulimit -v 4000000; OMP_STACKSIZE=1G " + sweep + "16");
  EXPECT_EQ(large.code, 3);
  EXPECT_EQ(lines_of(large.err), 1U) << large.err;
  const CommandResult few = shell("ulimit -s 65536; ulimit -v 700000; " + sweep + "16");
  EXPECT_EQ(few.code, 3);
  EXPECT_EQ(few.err,
            "plastica: cannot make 16 threads: Resource temporarily unavailable; give fewer "
            "(--threads), or smaller stacks\n");
}

TEST_F(Faults, AFitThatIsCompleteIsSaidToBeSo) {
  const std::vector<std::string> go_on{"calibrate", "fit.toml", "-o", "a.h5", "--resume"};
  const CommandResult first = place_.run(go_on);
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string bytes = place_.read("a.h5");
  const CommandResult again = place_.run(go_on);
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(again.err, "a.h5 is complete: nothing is left to do\n");
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(place_.read("a.h5"), bytes);
  EXPECT_FALSE(place_.has("a.h5.journal"));

  // What is made of it may be asked for again, too.
  std::vector<std::string> with_summary = go_on;
  with_summary.insert(with_summary.end(), {"--json", "a.json"});
  for (int i = 0; i < 2; ++i) EXPECT_EQ(place_.run(with_summary).code, 0);
  EXPECT_TRUE(place_.has("a.json"));

  // Not if anything is another.
  std::string curve = place_.read("example-curve.csv");
  curve.replace(curve.rfind('.') + 1, 1, curve[curve.rfind('.') + 1] == '7' ? "8" : "7");
  place_.write("example-curve.csv", curve);
  const CommandResult other = place_.run(go_on);
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.err,
            "plastica: a.h5: exists already, and is of other curves, options, version or "
            "instruction set: use --force to overwrite it\n");
  EXPECT_EQ(place_.read("a.h5"), bytes);
}

TEST_F(Faults, ACompleteOutputDoesNotCostTheJournalOfAnotherRun) {
  place_.write("b.csv", place_.read("example-curve.csv"));
  const std::vector<std::string> files{"calibrate", "example-curve.csv", "b.csv", "-o", "a.h5"};
  const auto with = [&](std::vector<std::string> options) {
    options.insert(options.begin(), files.begin(), files.end());
    return options;
  };
  ASSERT_EQ(place_.run(with({})).code, 0);
  RunningCommand other = place_.start(with({"--bootstrap", "100000", "--force", "--threads", "1"}));
  // One fit is kept, the other under way.
  const auto journal = place_.path("a.h5.journal");
  std::error_code absent;
  while (other.runs() && (!fs::exists(journal) || fs::file_size(journal, absent) < 10000)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  other.send(SIGINT);
  const CommandResult stopped = other.wait();
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_EQ(stopped.err,
            "plastica: interrupted; what is finished is kept: --resume --force goes on\n");
  const CommandResult refused = place_.run(with({"--bootstrap", "100000", "--resume"}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("use --resume --force to go on"), std::string::npos) << refused.err;
  const CommandResult complete = place_.run(with({"--resume"}));
  EXPECT_EQ(complete.code, 0);
  EXPECT_EQ(complete.err,
            "a.h5 is complete: nothing is left to do\n"
            "its journal has 1 fits of another run, and is kept\n");
  EXPECT_GT(fs::file_size(journal), 10000U);
}

TEST_F(Faults, ACheckDoesNotWriteOverWhatItReads) {
  ASSERT_EQ(place_.run({"init", "check"}).code, 0);
  for (const char* name : {"check.toml", "sweep.toml", "cantilever.toml"}) {
    const std::string text = place_.read(name);
    const CommandResult ended = place_.run({"check", "check.toml", "--junit", name, "--force"});
    EXPECT_EQ(ended.code, 2) << name;
    EXPECT_EQ(place_.read(name), text) << name;
  }
}

TEST_F(Faults, WhatStandsInTheJournalsPlaceIsSaid) {
  const std::string rule = " in the place of the journal: move it, or name another output\n";
  ASSERT_EQ(::mkfifo(place_.path("a.h5.journal").c_str(), 0600), 0);
  const CommandResult pipe = place_.run({"calibrate", "fit.toml", "-o", "a.h5"});
  EXPECT_EQ(pipe.code, 2);
  EXPECT_EQ(pipe.err, "plastica: a.h5.journal: is a named pipe" + rule);
  place_.write("mine", "mine");
  fs::create_symlink("mine", place_.path("b.h5.journal"));
  const CommandResult link = place_.run({"calibrate", "fit.toml", "-o", "b.h5", "--force"});
  EXPECT_EQ(link.code, 2);
  EXPECT_EQ(link.err, "plastica: b.h5.journal: is a link" + rule);
  EXPECT_EQ(place_.read("mine"), "mine");
}

TEST_F(Faults, NamesReachTheTerminalAndSpreadsheetsHarmless) {
  const std::string hostile = "\033]0;x\007\033[31mred.csv";
  place_.write(hostile, place_.read("example-curve.csv"));
  place_.write("columns.csv", "\033[31mStrain [%],Stress [MPa]\n0,0\n1,2\n2,3\n");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"inspect", hostile},
                                             {"inspect", "columns.csv"},
                                             {"calibrate", hostile, "--dry-run"},
                                             {"calibrate", hostile, "-o", "a.h5"},
                                             {"show", "a.h5", "--all"},
                                             {"show", hostile},
                                             {"simulate", hostile},
                                             {"calibrate", hostile + "none"}}) {
    const CommandResult ended = place_.run(arguments);
    EXPECT_EQ((ended.out + ended.err).find('\033'), std::string::npos) << ended.out << ended.err;
    EXPECT_NE(ended.out + ended.err, "");
  }
  place_.write("=cmd|' !A0.csv", place_.read("example-curve.csv"));
  ASSERT_EQ(place_.run({"calibrate", "=cmd|' !A0.csv", "-o", "b.h5"}).code, 0);
  const CommandResult table = place_.run({"export", "b.h5"});
  EXPECT_NE(table.out.find("\n'=cmd|' !A0,"), std::string::npos) << table.out;
}

}  // namespace
}  // namespace plastica::testing
