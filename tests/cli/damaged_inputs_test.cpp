#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

std::string repeated(const std::string& piece, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

class DamagedInput : public ::testing::TestWithParam<BadInput> {};

TEST_P(DamagedInput, IsRefusedInOneLine) { expect_refusal(GetParam()); }

const std::string kNoText = ":1: is not text (it has a zero byte)";
const std::string kLongName(300, 'n');
const std::string kTarget =
    "[[target]]\nfiles = \"a.csv\"\nstrain = \"Strain\"\nstress = \"Stress\"\n";

INSTANTIATE_TEST_SUITE_P(
    Tables, DamagedInput,
    ::testing::Values(
        BadInput{"LoneQuote",
                 {{"q.csv", "\""}},
                 {"inspect", "q.csv"},
                 "q.csv:1: has a quote that is not closed"},
        BadInput{"LoneQuoteToFit",
                 {{"q.csv", "\n\""}},
                 {"calibrate", "q.csv"},
                 "q.csv:2: has a quote that is not closed"},
        BadInput{"EndlessDevice", {}, {"inspect", "/dev/zero"}, "/dev/zero" + kNoText},
        BadInput{"EndlessDeviceToFit", {}, {"calibrate", "/dev/zero"}, "/dev/zero" + kNoText},
        BadInput{"NameTooLong",
                 {},
                 {"calibrate", kLongName},
                 kLongName + ": cannot be read: File name too long"},
        BadInput{"NameThatIsNotUtf8",
                 {{"caf\xE9.csv", "Strain (%),Stress (MPa)\n0,0\n1,1\n"}},
                 {"calibrate", "caf\xE9.csv"},
                 "caf?.csv: has a name that is not UTF-8 text; rename it"},
        BadInput{"ManyStars",
                 {{"a.csv", "Strain," + std::string(60, 'a') + "\n0,0\n1,1\n"},
                  {"f.toml",
                   "[[target]]\nfiles = \"a.csv\"\nstrain = \"Strain\"\nstress = { column = \"" +
                       repeated("*a", 20) + "*b\", unit = \"MPa\" }\n"}},
                 {"calibrate", "f.toml"},
                 "f.toml:4: stress = " + repeated("*a", 20) + "*b: matches no column of a.csv"},
        BadInput{"ManyBraces",
                 {{"f.toml", "[[target]]\nfiles = \"" + repeated("{a,b}", 16) + "\"\n"}},
                 {"calibrate", "f.toml"},
                 "f.toml:2: target[1].files = " + repeated("{a,b}", 16) +
                     ": stands for more than 10000 patterns by its braces; give a list of "
                     "patterns"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Toml, DamagedInput,
    ::testing::Values(
        BadInput{"EndlessFitFile", {}, {"calibrate", "/dev/zero", "-o", "o.h5"}, "/dev/zero…"},
        BadInput{
            "EndlessScene", {}, {"simulate", "/dev/zero", "-o", "o.h5"}, "/dev/zero" + kNoText},
        BadInput{"Folder",
                 {{"scene.toml/a", ""}},
                 {"simulate", "scene.toml", "-o", "o.h5"},
                 "scene.toml: cannot be read: Is a directory"},
        bad_scene("ZeroByte", std::string("a = 1\n\0", 7), "2: is not text (it has a zero byte)"),
        bad_scene("Utf16",
                  std::string("\xFF\xFE"
                              "a\0",
                              4),
                  "…"),
        bad_scene("KeyOfManyNames", repeated("a.", 100'000) + "a = 1\n",
                  "1: " + repeated("a.", 40) + "...: is nested in more than 64 tables and lists"),
        bad_scene("HeaderOfManyNames", "\n[" + repeated("a.", 100'000) + "a]\n",
                  "2: [" + repeated("a.", 39) + "a...: is nested in more than 64 tables and lists"),
        bad_scene("ManyBrackets", "a = " + repeated("[", 100'000),
                  "1: a = " + repeated("[", 76) +
                      "...: is nested in more than 64 tables and lists"),
        bad_scene("ManyValuesOnALine", "a = [" + repeated("0.1, ", 40'000) + "]\n[drive]\n", "…"),
        BadInput{
            "FitFileOfManyNames",
            {{"f.toml", repeated("a.", 100'000) + "a = 1\n"}},
            {"calibrate", "f.toml"},
            "f.toml:1: " + repeated("a.", 40) + "...: is nested in more than 64 tables and lists"}),
    name_of_case);

/// A file name that leads back to itself.
TEST(DamagedInputs, ALinkToItselfIsRefusedByEveryCommand) {
  const Workplace place;
  place.write("f.toml", kTarget + "table = { file = \"loop\", key = \"id\" }\n");
  place.write("a.csv", broken_curve());
  place.write("scene.toml", "[drive]\nstrain = { table = \"loop\", column = 1 }\n");
  place.write("sweep.toml", "scene = \"loop\"\n");
  std::filesystem::create_symlink("loop", place.path("loop"));
  const std::string why = "Too many levels of symbolic links\n";
  using Arguments = std::vector<std::string>;
  for (const Arguments& arguments :
       {Arguments{"inspect", "loop"}, Arguments{"calibrate", "loop"},
        Arguments{"calibrate", "f.toml"}, Arguments{"simulate", "loop", "-o", "o.h5"},
        Arguments{"simulate", "scene.toml", "-o", "o.h5"}, Arguments{"sweep", "loop"},
        Arguments{"sweep", "sweep.toml"}, Arguments{"check", "loop"}}) {
    const CommandResult result = place.run(arguments);
    EXPECT_EQ(result.code, 2) << arguments[0];
    EXPECT_EQ(lines_of(result.err), 1U) << result.err;
    EXPECT_NE(result.err.find("loop"), std::string::npos) << result.err;
    EXPECT_TRUE(result.err.ends_with(why)) << result.err;
  }
}

TEST(DamagedInputs, APipeIsReadToItsEnd) {
  const Workplace place;
  const std::string pipe = place.path("pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "a,b\n1,2\n3,4\n"; });
  const CommandResult result = place.run({"inspect", "pipe"});
  writer.join();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("pipe: 2 rows, 2 columns")) << result.out;
}

// It can be read but once; nobody need write to it to be told so.
TEST(DamagedInputs, APipeIsNoFitFile) {
  const Workplace place;
  ASSERT_EQ(mkfifo(place.path("fit.toml").c_str(), 0600), 0);
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: fit.toml: is a pipe: a fit file is read more than once\n");
}

TEST(DamagedInputs, APipeWithoutEndIsNoSceneFile) {
  const Workplace place;
  const CommandResult result =
      place.run_program("/bin/sh", {"-c", std::string("yes '# on and on' | \"") + PLASTICA_COMMAND +
                                              "\" simulate /dev/stdin -o o.h5"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: /dev/stdin: is larger than 16 MiB, the most that is read\n");
}

TEST(DamagedInputs, AFolderOfThemAmongGoodFilesEndsNoBatch) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("z.csv", broken_curve(350.0, 1));
  place.write("empty.csv", "");
  place.write("quote.csv", "\"");
  place.write("quotes.csv", "\"a\n\"b,1\n");
  place.write("wide.csv", std::string("\xFF\xFE"
                                      "a\0",
                                      4));
  place.write("zero.csv", std::string(1000, '\0'));
  place.write("caf\xE9.csv", "\"");
  std::filesystem::create_directory(place.path("folder.csv"));
  std::filesystem::create_symlink("loop.csv", place.path("loop.csv"));
  std::filesystem::create_symlink("nowhere", place.path("gone.csv"));
  place.write("f.toml", fit_file("\"*.csv\""));
  const CommandResult result = place.run({"calibrate", "f.toml", "--json", "o.json"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_EQ(result.err, "wrote f.h5\n");
  for (const char* reason :
       {"empty.csv: is empty\n", "quote.csv:1: has a quote that is not closed\n",
        "quotes.csv:1: has a quote that is not closed\n", "wide.csv: holds no data row\n",
        "zero.csv:1: is not text (it has a zero byte)\n",
        "loop.csv: cannot be read: Too many levels of symbolic links\n",
        "gone.csv: cannot be read: No such file or directory\n"}) {
    EXPECT_NE(result.out.find(reason), std::string::npos) << reason << result.out;
  }
  EXPECT_NE(result.out.find("\nfitted 2, rejected 8, failed 0\n"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace plastica::testing
