#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

#include "plastica/io/hdf5.hpp"

namespace plastica::testing {
namespace {

/// The bytes of an HDF5 file that is no result.
std::string other_hdf5() {
  const Workplace place;
  io::Hdf5File file = io::Hdf5File::create(place.path("x.h5"));
  file.root().write("x", 1.0);
  file.commit();
  return place.read("x.h5");
}

/// The bytes of a result whose only specimen is `a`.
std::string result() {
  const Workplace place;
  place.write("a.csv", broken_curve());
  const CommandResult ran = place.run({"calibrate", "a.csv", "-o", "x.h5"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  return place.read("x.h5");
}

/// Expects that a file is refused by all that read a result.
void expect_no_result(const std::string& content, const std::string& line) {
  for (const char* command : {"show", "plot", "export"}) {
    SCOPED_TRACE(command);
    expect_refusal({"", {{"x.h5", content}}, {command, "x.h5"}, line});
  }
}

TEST(BadResult, ThatIsMissingIsNamed) {
  for (const char* command : {"show", "plot", "export"}) {
    SCOPED_TRACE(command);
    expect_refusal({"", {}, {command, "x.h5"}, "x.h5: cannot be read: No such file or directory"});
  }
}

TEST(BadResult, ThatIsNotHdf5IsRefused) {
  expect_no_result(broken_curve(), "x.h5: is not an HDF5 file");
  expect_no_result("", "x.h5: is not an HDF5 file");
}

TEST(BadResult, OfAnotherProgramIsRefused) {
  expect_no_result(other_hdf5(),
                   "x.h5: is not a result file of Plastica: it has no attribute schema");
}

TEST(BadResult, ThatIsTruncatedIsRefused) {
  const std::string whole = result();
  expect_no_result(whole.substr(0, whole.size() / 2), "x.h5: is cut off: …");
  expect_no_result(whole.substr(0, whole.size() - 1), "x.h5: is cut off: …");
}

TEST(BadResult, OfAnotherSchemaIsRefused) {
  const Workplace place;
  io::Hdf5File file = io::Hdf5File::create(place.path("x.h5"));
  file.root().set_attribute(".", "schema", "plastica/other");
  file.commit();
  expect_no_result(place.read("x.h5"),
                   "x.h5: schema = plastica/other: must be plastica/fits, plastica/scene, "
                   "plastica/sweep or plastica/scene-fits");
}

TEST(BadRequest, OfAResultIsRefusedInOneLine) {
  const std::map<std::string, std::string> files{{"x.h5", result()}, {"mine.csv", "my own"}};
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"show", "x.h5", "--case", "b"}, "x.h5: --case = b: must be a specimen of the file: a"},
      {{"plot", "x.h5", "--case", "b"}, "--case = b: is not a specimen of this file; it has a"},
      {{"plot", "x.h5", "--what", "pie"},
       "--what = pie: must be curve, residuals, quantiles, overview, parameters, profile, "
       "bootstrap or laws"},
      {{"plot", "x.h5", "--what", "overview", "--case", "a"},
       "--case = a: does not go with the picture 'overview'"},
      {{"plot", "x.h5", "-o", "x.gif"},
       "--output = x.gif: must end in .svg, .png, .pdf or .gp, or be -"},
      {{"plot", "x.h5", "-o", "none/x.svg"},
       "none/x.svg: cannot be written: there is no folder none"},
      {{"plot", "x.h5", "x.h5"}, "plot = x.h5: must not be there: fits are drawn of one file"},
      {{"plot", "x.h5", "--joint", "1"},
       "--joint: is for simulated scenes; this is a result of fits"},
      {{"export", "x.h5", "--to", "xls"},
       "--to = xls: must be one of csv, json, markdown, latex, mjcf, agx, bullet, chrono, "
       "opensees, vtkhdf, xdmf"},
      {{"export", "x.h5", "--what", "all"},
       "--what = all: must be one of specimens, fits, targets, curves, probes, joints, energies, "
       "events, fragments, spectrum, cases, beam"},
      {{"export", "x.h5", "--to", "latex"}, "--to latex: is for sweeps; this is a result of fits"},
      {{"export", "x.h5", "--what", "curves", "-o", "y.json"}, "--what: goes with --to csv"},
      {{"export", "x.h5", "--to", "csv", "-o", "y.json"},
       "--output = y.json: must not end in .json: --to is csv"},
      {{"export", "x.h5", "-o", "y.xml"},
       "--output = y.xml: ends in .xml, which says no format: give --to"},
      {{"export", "x.h5", "-o", "mine.csv"},
       "mine.csv: exists already: use --force to overwrite it"},
      {{"export", "x.h5", "-o", "x.h5", "--force"},
       "--output = x.h5: is a file that this run reads"},
      {{"export", "x.h5", "-o", "none/x.csv"},
       "none/x.csv: cannot be written: there is no folder none"}};
  for (const auto& [arguments, line] : requests) {
    SCOPED_TRACE(line);
    expect_refusal({"", files, arguments, line});
  }
}

}  // namespace
}  // namespace plastica::testing
