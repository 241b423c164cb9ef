#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/fuzz_target.hpp"

/// What fuzzers run for hours, in a second: their seeds, what once broke a reader, and some changes
/// of these, the same ones each time.
namespace plastica::fuzz {
namespace {

namespace fs = std::filesystem;

struct Sample {
  std::string name;
  std::string content;
};

/// The files of a reader's folder; none if it has none.
std::vector<Sample> samples_of(std::string_view folder, std::string_view reader) {
  const fs::path path = fs::path(PLASTICA_SOURCE_DIR "/tests/fuzz") / folder / reader;
  std::vector<Sample> samples;
  if (!fs::is_directory(path)) return samples;
  for (const auto& entry : fs::directory_iterator(path)) {
    samples.push_back({entry.path().filename().string(), content_of(entry.path().string())});
  }
  std::ranges::sort(samples, {}, &Sample::name);
  return samples;
}

void expect_contract(const Target& target, const std::string& content, const std::string& name) {
  const Bytes bytes(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
  try {
    target.run(bytes);
  } catch (const std::exception& error) {
    ADD_FAILURE() << target.name << ", " << name << ": " << error.what() << "\n"
                  << ::testing::PrintToString(content.substr(0, 2000));
  }
}

/// Changes some bytes, or moves, repeats and cuts pieces, also those of another sample.
std::string changed(std::string content, const std::string& other, std::mt19937& random) {
  const auto below = [&](std::size_t end) { return end == 0 ? 0 : random() % end; };
  for (std::size_t left = 1 + below(4); left > 0; --left) {
    const std::size_t at = below(content.size() + 1);
    const std::size_t size = below(std::min<std::size_t>(content.size() - at, 24) + 1);
    const std::size_t from = below(other.size() + 1);
    switch (below(5)) {
      case 0: content.insert(at, 1, static_cast<char>(below(256))); break;
      case 1: content.erase(at, size); break;
      case 2: content.insert(at, content.substr(at, size)); break;
      case 3: content.insert(at, other, from, below(24)); break;
      default:
        if (at < content.size()) content[at] = static_cast<char>(content[at] ^ (1 << below(8)));
    }
  }
  return content;
}

class Fuzzed : public ::testing::TestWithParam<Target> {};

TEST_P(Fuzzed, SeedsAndReproducersAreReadOrRefused) {
  const std::vector<Sample> seeds = samples_of("corpus", GetParam().name);
  EXPECT_GE(seeds.size(), 3U);
  for (const Sample& sample : seeds) expect_contract(GetParam(), sample.content, sample.name);
  for (const Sample& sample : samples_of("reproducers", GetParam().name)) {
    expect_contract(GetParam(), sample.content, sample.name);
  }
  expect_contract(GetParam(), "", "nothing");
}

TEST_P(Fuzzed, ChangedSeedsAreReadOrRefused) {
  std::vector<Sample> seeds = samples_of("corpus", GetParam().name);
  std::ranges::copy(samples_of("reproducers", GetParam().name), std::back_inserter(seeds));
  ASSERT_FALSE(seeds.empty());
  std::mt19937 random(1);
  // A result takes a hundred times as long as all else.
  const int changes = GetParam().name.starts_with("result") ? 4 : 200;
  for (int i = 0; i < changes && !HasFailure(); ++i) {
    const Sample& one = seeds[random() % seeds.size()];
    const Sample& other = seeds[random() % seeds.size()];
    expect_contract(GetParam(), changed(one.content, other.content, random),
                    one.name + ", change " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzzed, ::testing::ValuesIn(targets()),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace plastica::fuzz
