#include <gtest/gtest.h>

#include "plastica/io/scene_digest.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::io {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::record_of;

const std::string kMasses =
    "[[mass]]\nat = { segment = 2 }\nmass = '500 g'\n"
    "[[mass]]\nat = 'end'\nmass = '2 kg'\n"
    "inertia = ['100 kg cm^2', '0 kg m^2', '0.02 kg m^2']\n"
    "[[mass]]\nat = '25 %'\nmass = '0 kg'\ninertia = ['0 kg m^2', '1 kg m^2', '0 kg m^2']\n";

TEST(SceneMasses, AreReadWithTheirUnits) {
  const auto masses =
      parse_scene_file(cantilever_text("-1 N", kMasses), "s.toml").setup.scene.masses;
  ASSERT_EQ(masses.size(), 3U);
  EXPECT_EQ(masses[0].at.segment, 2);
  EXPECT_DOUBLE_EQ(masses[0].mass, 0.5);
  EXPECT_FALSE(masses[0].has_rotational_inertia());
  EXPECT_EQ(masses[1].at.fraction, 1.0);
  EXPECT_EQ(masses[1].mass, 2.0);
  EXPECT_NEAR(masses[1].inertia[0], 0.01, 1e-16);
  EXPECT_EQ(masses[1].inertia[2], 0.02);
  EXPECT_EQ(masses[2].mass, 0.0);
  EXPECT_TRUE(masses[2].has_rotational_inertia());
}

TEST(SceneMasses, AreStoredAndReadBack) {
  const ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  const SceneRecord record = record_of(cantilever_text("-1 N", kMasses));
  write_scene_store(path, record);
  const auto& written = record.setup.scene.masses;
  const auto read = read_scene_store(path).setup.scene.masses;
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].at.fraction, 0.5);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].at.fraction, written[i].at.fraction);
    EXPECT_EQ(read[i].mass, written[i].mass);
    EXPECT_EQ(read[i].inertia, written[i].inertia);
  }
}

// Files of versions before masses have no such table.
TEST(SceneMasses, AreNoTableWhereThereAreNone) {
  const ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  write_scene_store(path, record_of(cantilever_text()));
  EXPECT_FALSE(Hdf5File::open(path).root().exists("masses"));
  EXPECT_TRUE(read_scene_store(path).setup.scene.masses.empty());
}

TEST(SceneMasses, ChangeTheDigest) {
  plastica::Setup setup;
  std::vector<std::uint64_t> digests{scene_digest(setup)};
  const auto add = [&] { digests.push_back(scene_digest(setup)); };
  setup.scene.masses.push_back({Place::end(), 1.0, {}});
  add();
  setup.scene.masses[0].mass = 2.0;
  add();
  setup.scene.masses[0].inertia[1] = 1.0;
  add();
  setup.scene.masses[0].at = {0.5, {}};
  add();
  setup.scene.masses.push_back(setup.scene.masses[0]);
  add();
  std::sort(digests.begin(), digests.end());
  EXPECT_EQ(std::unique(digests.begin(), digests.end()), digests.end());
}

}  // namespace
}  // namespace plastica::io
