#include "calibrate/store/fit_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/fitted_curve.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/io/hdf5.hpp"
#include "tests/calibrate/store/same_bits.hpp"
#include "tests/calibrate/store/stored_objects.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::calibrate {
namespace {

FitStoreContents contents_of(std::vector<FitRecord> records) {
  FitStoreContents contents;
  contents.records = std::move(records);
  contents.options = ideal_options();
  contents.inputs = {{"fit.toml", "[fit]\n# Maß: µm\n"}, {"info.csv", ""}};
  contents.meta = {"2024-05-31T12:00:00Z",
                   1.5,
                   "a-host",
                   2,
                   "baseline",
                   "plastica calibrate fit.toml",
                   1,
                   {{"plastica", "0.1.0"}, {"hdf5", "1.10.8"}}};
  return contents;
}

/// Records that are filled, empty, rejected and failed, in the order of their names.
std::vector<FitRecord> mixed_records() {
  FitRecord failed = rejected_record("c");
  failed.target = ideal_target("c", 3e8);
  failed.result.status = FitStatus::Failed;
  failed.result.trace = {{1}, {2.0}, {INFINITY}, 0, 0};
  return {filled_record("a"), rejected_record("b"), failed, filled_record("Ω")};
}

FitStoreContents round_trip(const FitStoreContents& contents) {
  const io::ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  write_fit_store(path, contents);
  return read_fit_store(path);
}

TEST(FitStore, WritesTheSameBytesWhereCurvesArePutAside) {
  const io::ScratchFolder folder;
  FitStoreContents contents = contents_of(mixed_records());
  for (int i = 0; i < 40; ++i) {
    FitRecord& record = contents.records.emplace_back(filled_record("many-" + std::to_string(i)));
    record.target.corrected = ideal_target("", 3e8, 300 + static_cast<std::size_t>(i)).corrected;
  }
  write_fit_store(folder.file("here.h5"), contents);
  const auto spool = std::make_shared<CurveSpool>(folder.file(""), 2000);
  for (FitRecord& record : contents.records) {
    put_aside(record.target, spool);
    put_aside(record.result.fitted, spool);
  }
  write_fit_store(folder.file("aside.h5"), contents);
  EXPECT_TRUE(io::content_of(folder.file("here.h5")) == io::content_of(folder.file("aside.h5")));
}

/// Fitted curves that are counted alone are made again: of one law, and of several.
TEST(FitStore, WritesTheSameBytesWhereFittedCurvesAreCountedAlone) {
  for (const bool several : {false, true}) {
    const io::ScratchFolder folder;
    FitOptions options = ideal_options();
    options.keep_trace = false;
    if (several) options.laws = {Law::Ideal, Law::Linear};
    const std::vector<Target> targets = ideal_targets(5);
    const std::vector<FitResult> results = fit(targets, options);
    const std::vector<FitCase> cases = cases_of(targets.size(), options);
    FitStoreContents contents;
    contents.options = options;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      contents.records.push_back({targets[cases[i].target], results[i]});
    }
    write_fit_store(folder.file("here.h5"), contents);
    const auto spool = std::make_shared<CurveSpool>(folder.file(""), 2000);
    std::size_t curves = 0;
    for (FitRecord& record : contents.records) {
      EXPECT_TRUE(may_have_curve(record.target, record.result));
      curves += record.result.fitted.size() > 0 ? 1 : 0;
      put_aside(record.target, spool);
      count_alone(record.result);
      EXPECT_EQ(record.result.fitted.size(), 0U);
    }
    EXPECT_GT(curves, 3U);
    write_fit_store(folder.file("counted.h5"), contents);
    EXPECT_TRUE(io::content_of(folder.file("here.h5")) ==
                io::content_of(folder.file("counted.h5")));
  }
}

TEST(FitStore, CountsSamplesWhereItIsToldTo) {
  const io::ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  write_fit_store(path, contents_of(mixed_records()));
  const FitStoreContents whole = read_fit_store(path);
  FitStoreContents counted = read_fit_store(path, FitSamples::Counted);
  ASSERT_EQ(counted.records.size(), whole.records.size());
  for (std::size_t i = 0; i < whole.records.size(); ++i) {
    FitRecord& record = counted.records[i];
    const FitRecord& other = whole.records[i];
    EXPECT_EQ(record.result.evaluations(), other.result.evaluations());
    for (auto member : {&Target::raw, &Target::corrected}) {
      Curve& curve = record.target.*member;
      EXPECT_EQ(curve.samples(), (other.target.*member).samples());
      EXPECT_EQ(curve.size(), 0U);
      if (curve.samples() > 0) {
        EXPECT_THROW(with_samples(curve), std::logic_error);
      }
      curve = other.target.*member;
    }
    EXPECT_EQ(record.result.fitted.samples(), other.result.fitted.samples());
    record.result.fitted = other.result.fitted;
    record.result.trace = other.result.trace;
    EXPECT_TRUE(same_bits(record.target, other.target)) << i;
    EXPECT_TRUE(same_bits(record.result, other.result)) << i;
  }
}

TEST(FitStore, GivesBackEveryFieldOfEveryRecordBitByBit) {
  const auto contents = contents_of(mixed_records());
  const auto read = round_trip(contents);
  ASSERT_EQ(read.records.size(), contents.records.size());
  for (std::size_t i = 0; i < read.records.size(); ++i) {
    EXPECT_TRUE(same_bits(read.records[i].target, contents.records[i].target)) << i;
    EXPECT_TRUE(same_bits(read.records[i].result, contents.records[i].result)) << i;
  }
}

TEST(FitStore, GivesBackRealFitsBitByBit) {
  const auto targets = ideal_targets(5);
  const auto results = fit(targets, ideal_options());
  std::vector<FitRecord> records;
  for (std::size_t i = 0; i < targets.size(); ++i) records.push_back({targets[i], results[i]});
  EXPECT_TRUE(same_bits(round_trip(contents_of(records)).records, records));
}

TEST(FitStore, HoldsABatchWithoutTargets) {
  EXPECT_TRUE(round_trip(contents_of({})).records.empty());
}

TEST(FitStore, HoldsRejectedTargetsAlone) {
  const std::vector<FitRecord> records{rejected_record("a"), rejected_record("b")};
  EXPECT_TRUE(same_bits(round_trip(contents_of(records)).records, records));
}

TEST(FitStore, GivesBackTheOptions) {
  auto contents = contents_of({});
  FitOptions& o = contents.options;
  o.setup.scene.material.break_strain = 0.25;
  o.setup.scene.material.hardening.law = HardeningLaw::VoceChaboche;
  o.setup.scene.section.shape = SectionShape::Circle;
  o.setup.scene.beam.segments = 17;
  o.objective = Objective::LeastSquares;
  o.noise = 1e6;
  o.weights = {{0.0, 2.0}, {0.01, 0.125}, {0.5, 0.0}};
  o.break_weight = 0.125;
  o.algorithm = "slsqp";
  o.stopping = {1, 2, 3e-9, 4e-9};
  o.seed = 0xffffffffffffffffU;
  o.confidence = 0.9;
  o.intervals = {true, 40, 3, 50};
  o.stated = {"material.density", "material.break_strain"};
  o.parameters[0].role = ParameterRole::Fixed;
  o.parameters[0].value = 2e11;
  o.parameters[1].lower = 1e6;
  o.parameters[1].upper = 1e9;
  o.parameters[1].scale = ParameterScale::Linear;
  o.parameters[1].prior = Prior{3e8, 2e7};
  o.parameters[2].role = ParameterRole::Tied;
  o.parameters[2].tied_to = o.parameters[1].field;
  o.parameters[2].factor = 1e-9;

  const FitOptions read = round_trip(contents).options;
  for (const Field& field : fields()) {
    EXPECT_EQ(field.get(read.setup), field.get(o.setup)) << field.path;
  }
  EXPECT_EQ(read.stated, o.stated);
  EXPECT_EQ(read.objective, o.objective);
  EXPECT_EQ(read.noise, o.noise);
  ASSERT_EQ(read.weights.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.weights[i].from, o.weights[i].from);
    EXPECT_EQ(read.weights[i].weight, o.weights[i].weight);
  }
  EXPECT_EQ(read.break_weight, o.break_weight);
  EXPECT_EQ(read.algorithm, o.algorithm);
  EXPECT_EQ(read.stopping.global_evaluations, 1);
  EXPECT_EQ(read.stopping.local_evaluations, 2);
  EXPECT_EQ(read.stopping.parameter_tolerance, 3e-9);
  EXPECT_EQ(read.stopping.cost_tolerance, 4e-9);
  EXPECT_EQ(read.seed, o.seed);
  EXPECT_EQ(read.confidence, o.confidence);
  EXPECT_TRUE(read.intervals.profile);
  EXPECT_EQ(read.intervals.bootstrap, 40);
  EXPECT_EQ(read.intervals.block, 3);
  EXPECT_EQ(read.intervals.specimens, 50);
  ASSERT_EQ(read.parameters.size(), o.parameters.size());
  for (std::size_t i = 0; i < o.parameters.size(); ++i) {
    const Parameter& p = read.parameters[i];
    const Parameter& q = o.parameters[i];
    EXPECT_EQ(p.field, q.field);
    EXPECT_EQ(p.role, q.role);
    EXPECT_EQ(p.value, q.value);
    EXPECT_EQ(p.lower, q.lower);
    EXPECT_EQ(p.upper, q.upper);
    EXPECT_EQ(p.scale, q.scale);
    ASSERT_EQ(p.prior.has_value(), q.prior.has_value());
    if (q.prior) {
      EXPECT_EQ(p.prior->mean, q.prior->mean);
      EXPECT_EQ(p.prior->standard_deviation, q.prior->standard_deviation);
    }
    EXPECT_EQ(p.tied_to, q.tied_to);
    EXPECT_EQ(p.factor, q.factor);
  }
}

TEST(FitStore, GivesBackInputsAndMeta) {
  const auto contents = contents_of({});
  const auto read = round_trip(contents);
  ASSERT_EQ(read.inputs.size(), 2U);
  EXPECT_EQ(read.inputs[0].name, "fit.toml");
  EXPECT_EQ(read.inputs[0].text, contents.inputs[0].text);
  EXPECT_EQ(read.meta.start_time, contents.meta.start_time);
  EXPECT_EQ(read.meta.seconds, 1.5);
  EXPECT_EQ(read.meta.host, "a-host");
  EXPECT_EQ(read.meta.threads, 2);
  EXPECT_EQ(read.meta.instruction_set, "baseline");
  EXPECT_EQ(read.meta.command_line, contents.meta.command_line);
  EXPECT_EQ(read.meta.resumptions, 1);
  EXPECT_EQ(read.meta.versions, contents.meta.versions);
}

TEST(FitStore, HasTheSameBytesWhateverTheOrderOfTheRecords) {
  const io::ScratchFolder folder;
  auto contents = contents_of(mixed_records());
  write_fit_store(folder.file("a.h5"), contents);
  std::reverse(contents.records.begin(), contents.records.end());
  std::swap(contents.records[0], contents.records[1]);
  write_fit_store(folder.file("b.h5"), contents);
  EXPECT_TRUE(io::content_of(folder.file("a.h5")) == io::content_of(folder.file("b.h5")));
}

TEST(FitStore, DiffersBetweenTwoRunsInMetaAlone) {
  const io::ScratchFolder folder;
  auto contents = contents_of(mixed_records());
  write_fit_store(folder.file("a.h5"), contents);
  contents.meta = io::begin_meta("another command line", 8);
  contents.meta.resumptions = 3;
  write_fit_store(folder.file("b.h5"), contents);
  const auto first = objects_of(folder.file("a.h5"));
  EXPECT_EQ(first, objects_of(folder.file("b.h5")));
  EXPECT_GT(first.size(), 100U);

  contents.records[0].result.trace.costs[0] += 1.0;
  write_fit_store(folder.file("c.h5"), contents);
  EXPECT_NE(first, objects_of(folder.file("c.h5")));
}

TEST(FitStore, GivesEveryRealColumnAUnitOrSaysThatItIsMixed) {
  const io::ScratchFolder folder;
  write_fit_store(folder.file("a.h5"), contents_of(mixed_records()));
  const io::Hdf5File file = io::Hdf5File::open(folder.file("a.h5"));
  // Those whose unit differs from row to row stand beside a column that names it, or are SI.
  const std::vector<std::string> mixed{"/evaluations/values",
                                       "/properties/value",
                                       "/corrections/amount",
                                       "/options/parameters/value",
                                       "/options/parameters/lower",
                                       "/options/parameters/upper",
                                       "/options/parameters/prior_mean",
                                       "/options/parameters/prior_standard_deviation",
                                       "/parameters/youngs_modulus/verdict_number",
                                       "/parameters/yield_stress/verdict_number",
                                       "/parameters/break_strain/verdict_number",
                                       "/profiles/low",
                                       "/profiles/high",
                                       "/profiles/value/values",
                                       "/profiles/rise/values",
                                       "/profiles/searched/values",
                                       "/bootstraps/values/values",
                                       "/bootstraps/standard_error/values",
                                       "/bootstraps/low/values",
                                       "/bootstraps/high/values"};
  std::vector<std::string> without;
  for (const auto& [path, text] : objects_of(folder.file("a.h5"))) {
    if (file.root().kind(path) != io::Hdf5Kind::Real) continue;
    if (path == "/correlation/values") continue;
    if (!file.root().has_attribute(path, "units")) without.push_back(path);
  }
  EXPECT_TRUE(std::is_permutation(without.begin(), without.end(), mixed.begin(), mixed.end()))
      << ::testing::PrintToString(without);
}

TEST(FitStore, HasNoDatasetThatItsDocumentationDoesNotName) {
  const io::ScratchFolder folder;
  write_fit_store(folder.file("a.h5"), contents_of(mixed_records()));
  const std::string page = io::content_of(PLASTICA_SOURCE_DIR "/docs/hdf5.md");
  ASSERT_NE(page.find("## The result file of fits (HDF5)"), std::string::npos);
  const io::Hdf5File file = io::Hdf5File::open(folder.file("a.h5"));
  for (const auto& [path, text] : objects_of(folder.file("a.h5"))) {
    if (path.starts_with("/options/setup")) continue;  // the fields have a table of their own
    if (file.root().kind(path) == io::Hdf5Kind::Group) continue;
    const std::string name = path.substr(path.rfind('/') + 1);
    EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << path;
  }
  for (const std::string& group : file.root().children()) {
    EXPECT_NE(page.find("`/" + group), std::string::npos) << group;
  }
}

TEST(FitStore, ShowsWhatIsMissingAsNotANumber) {
  const io::ScratchFolder folder;
  write_fit_store(folder.file("a.h5"), contents_of(mixed_records()));
  const io::Hdf5File file = io::Hdf5File::open(folder.file("a.h5"));
  for (const char* path : {"fits/cost", "parameters/yield_stress/value",
                           "characteristics/proof_stress", "characteristics/first_broken_strain"}) {
    const auto values = file.root().read<double>(path);
    ASSERT_EQ(values.size(), 4U);
    EXPECT_FALSE(std::isnan(values[0])) << path;
    EXPECT_TRUE(std::isnan(values[1])) << path;
  }
  EXPECT_EQ(file.root().text_attribute("parameters/yield_stress/value", "units"), "Pa");
  EXPECT_EQ(file.root().text_attribute("parameters/break_strain/value", "units"), "1");
}

TEST(FitStore, LeavesTheUnusedColumnsOfEvaluationsEmpty) {
  const io::ScratchFolder folder;
  write_fit_store(folder.file("a.h5"), contents_of(mixed_records()));
  const io::Hdf5File file = io::Hdf5File::open(folder.file("a.h5"));
  EXPECT_EQ(file.root().shape("evaluations/values"), (std::vector<std::size_t>{7, 2}));
  const auto values =
      file.root().read_array<double>("evaluations/values", std::array<std::size_t, 2>{7, 2});
  EXPECT_EQ(values[6], 2.0);  // the failed fit, which moves one parameter
  EXPECT_TRUE(std::isnan(values[7]));
}

TEST(FitStore, SaysWhichParametersTheColumnsOfEvaluationsAre) {
  const io::ScratchFolder folder;
  write_fit_store(folder.file("a.h5"), contents_of(mixed_records()));
  const io::Hdf5File file = io::Hdf5File::open(folder.file("a.h5"));
  EXPECT_EQ(file.root().read<std::uint64_t>("free/values"),
            (std::vector<std::uint64_t>{0, 2, 1, 0, 2}));
  EXPECT_EQ(file.root().read<std::uint64_t>("free/offsets"),
            (std::vector<std::uint64_t>{0, 2, 2, 3, 5}));
  EXPECT_EQ(file.root().read<std::uint64_t>("fits/free_parameters"),
            (std::vector<std::uint64_t>{2, 0, 1, 2}));
}

TEST(FitStore, NamesTheHdf5ThatWritesIt) {
  const auto versions = io::begin_meta("", 1).versions;
  EXPECT_NE(std::find(versions.begin(), versions.end(),
                      std::pair<std::string, std::string>{"hdf5", io::hdf5_version()}),
            versions.end());
}

}  // namespace
}  // namespace plastica::calibrate
