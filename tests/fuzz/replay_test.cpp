// Runs every reader on its seeds, on inputs that once failed, and on changed seeds: a short fuzzing campaign with the
// same inputs in every run. scripts/fuzz runs the long campaigns.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <regex>
#include <sstream>

#include "core/base/files.h"
#include "fuzz/mutation.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {
namespace fs = std::filesystem;

const fs::path kTests = fs::path(TAXEL_SOURCE_DIR) / "tests";

/// A row of tests/fuzz/CMakeLists.txt.
struct Reader {
  std::string name;
  std::size_t most_bytes = 0;
  std::vector<std::string> patterns;  ///< names of fixtures, with the wildcard *
};

std::vector<Reader> readers() {
  std::vector<Reader> all;
  std::istringstream lines(read_file(TAXEL_FUZZ_READERS));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Reader& reader = all.emplace_back();
    words >> reader.name >> reader.most_bytes;
    for (std::string pattern; words >> pattern;) reader.patterns.push_back(pattern);
  }
  return all;
}

bool matches(const std::string& name, const std::string& pattern) {
  return std::regex_match(name, std::regex(std::regex_replace(pattern, std::regex("\\*"), ".*")));
}

/// Returns the files of a folder whose names match, in the order of their names. Empty if there is no such folder.
std::vector<fs::path> files_of(const fs::path& folder, const std::string& pattern) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
    if (matches(entry.path().filename().string(), pattern)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> seeds_of(const Reader& reader) {
  std::vector<fs::path> seeds = files_of(kTests / "fuzz" / "seeds" / reader.name, "*");
  for (const std::string& pattern : reader.patterns)
    for (const fs::path& file : files_of(kTests / "fixtures" / "broken", pattern)) seeds.push_back(file);
  return seeds;
}

/// Returns the input as text that fits into a message.
std::string quoted(const std::string& input) {
  std::string text;
  for (const char c : input.substr(0, 2000))
    text += std::isprint(static_cast<unsigned char>(c)) != 0 || c == '\n'
                ? std::string(1, c)
                : "\\x" + std::to_string(static_cast<unsigned char>(c));
  return text;
}

class Fuzz : public testing::TestWithParam<Target> {
 protected:
  /// Limits the memory, so that a reader with runaway allocation fails alone and not with every program of the machine.
  /// Sanitizers reserve more addresses than the limit.
  static void SetUpTestSuite() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit limit{std::size_t{6} << 30U, std::size_t{6} << 30U};
    setrlimit(RLIMIT_AS, &limit);
#endif
  }
  static Reader reader() {
    const std::vector<Reader> all = readers();
    const auto found = std::find_if(all.begin(), all.end(), [](const Reader& r) { return r.name == GetParam().name; });
    return found == all.end() ? Reader{} : *found;
  }

  /// Runs one input, which must take at most 5 s.
  static void run(const std::string& input) {
    const auto begin = std::chrono::steady_clock::now();
    try {
      GetParam().run(input);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << quoted(input);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << quoted(input);
  }
};

TEST_P(Fuzz, HasSeeds) {
  EXPECT_GT(reader().most_bytes, 0U) << "no row in tests/fuzz/CMakeLists.txt";
  EXPECT_FALSE(seeds_of(reader()).empty());
}

TEST_P(Fuzz, SurvivesSeedsAndPastFindings) {
  std::vector<fs::path> files = seeds_of(reader());
  for (const fs::path& file : files_of(kTests / "fuzz" / "crashes" / reader().name, "*")) files.push_back(file);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    run(read_file(file));
  }
}

TEST_P(Fuzz, SurvivesChangedSeeds) {
  constexpr std::uint64_t kRuns = 2000;
  const std::vector<fs::path> files = seeds_of(reader());
  ASSERT_FALSE(files.empty());
  std::vector<std::string> seeds;
  for (const fs::path& file : files) seeds.push_back(read_file(file));
  for (std::uint64_t i = 0; i < kRuns && !HasFailure(); ++i) {
    std::string input = seeds[i % seeds.size()];
    mutate(input, i);
    run(input.substr(0, reader().most_bytes));
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz, testing::ValuesIn(targets()),
                         [](const testing::TestParamInfo<Target>& target) { return target.param.name; });

}  // namespace
}  // namespace taxel::fuzz
