// Lists of jobs: expansion, ranges, random values, and ids that depend on the content alone.
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/files.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

DefaultLayout our_fingertip() {
  return {read_sensor_source(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json"), "v 1 2 3\n"};
}

/// Returns the jobs of a list whose default layout is our fingertip.
JobList expand(const std::string& text, const std::filesystem::path& folder = ".") {
  JobSources sources(our_fingertip);
  return parse_job_list(text, "jobs.jsonl", folder, sources);
}

/// Returns a text on one line, as a list of jobs needs it.
std::string on_one_line(std::string text) {
  std::erase(text, '\n');
  return text;
}

std::vector<std::string> values_of(const JobList& list) {
  std::vector<std::string> values;
  for (const Job& job : list.jobs) {
    std::string text;
    for (const JobChange& change : job.changes) text += change.value + " ";
    values.push_back(text);
  }
  return values;
}

/// Returns the message of a line that gives no jobs.
std::string broken(const std::string& line) {
  const JobList list = expand(line);
  return list.broken.size() == 1 && list.jobs.empty() ? list.broken[0].message : "accepted";
}

TEST(JobList, ExpandsListsAndRangesWithTheLastParameterFastest) {
  const JobList list = expand(on_one_line(R"({"scenario": {"kind": "press"}, "set": {
    "/scenario/depth": {"from": 0.0005, "to": 0.001, "count": 3}, "/layout/material/modulus": {"values": [3e4, 5e4]}},
    "repeat": 2})"));
  EXPECT_TRUE(list.broken.empty());
  const std::vector<std::string> expected{"0.0005 30000.0 ",  "0.0005 30000.0 ",  "0.0005 50000.0 ",
                                          "0.0005 50000.0 ",  "0.00075 30000.0 ", "0.00075 30000.0 ",
                                          "0.00075 50000.0 ", "0.00075 50000.0 ", "0.001 30000.0 ",
                                          "0.001 30000.0 ",   "0.001 50000.0 ",   "0.001 50000.0 "};
  EXPECT_EQ(values_of(list), expected);
  EXPECT_EQ(list.jobs[4].scenario.as<scenarios::Press>().depth, 0.00075);
  EXPECT_EQ(list.jobs[7].number, 7);
  EXPECT_EQ(list.jobs[7].task, "fingertip press");
}

TEST(JobList, GivesEachModelOneKey) {
  const JobList list =
      expand(R"({"scenario": {"kind": "press"}, "set": {"/layout/sampling/seed": {"values": [1, 2, 42]}}, "repeat": 2})"
             "\n"
             R"({"scenario": {"kind": "roll"}})");
  std::vector<std::string> keys;
  for (const Job& job : list.jobs) keys.push_back(job.layout_key);
  ASSERT_EQ(keys.size(), 7U);
  EXPECT_EQ(keys[0], keys[1]);
  EXPECT_NE(keys[1], keys[2]);
  EXPECT_NE(keys[2], keys[4]);
  EXPECT_EQ(keys[4], keys[6]);  // 42 is the seed of the layout
}

TEST(JobList, GivesTheSameJobsWhereverTheLineIs) {
  const std::string line =
      on_one_line(R"({"scenario": {"kind": "press"}, "set": {"/scenario/depth": {"uniform": [0.0005, 0.001]}},
    "repeat": 3, "seed": 5})");
  const JobList alone = expand(line), later = expand("{\"scenario\": {\"kind\": \"roll\"}}\n\n" + line);
  ASSERT_EQ(alone.jobs.size(), 3U);
  ASSERT_EQ(later.jobs.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(alone.jobs[i].id, later.jobs[i + 1].id);
    EXPECT_EQ(alone.jobs[i].seed, later.jobs[i + 1].seed);
    EXPECT_EQ(alone.jobs[i].changes, later.jobs[i + 1].changes);
  }
  EXPECT_EQ(later.jobs[1].line, 3);
}

TEST(JobList, TakesIdsFromContentAndNotFromNames) {
  const TempFolder folder;
  const std::string layout = read_file(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
  std::string moved = layout;
  const std::string relative = "../meshes/fingertip.obj", name = "other.obj";
  ASSERT_NE(moved.find(relative), std::string::npos);
  moved.replace(moved.find(relative), relative.size(), name);
  write_file_atomically(folder / "other.obj", read_file(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj"));
  write_file_atomically(folder / "copy.json", moved);
  write_file_atomically(folder / "press.json", R"({"depth": 1e-3, "kind": "press"})");
  const JobList list = expand(
      "{\"layout\": \"copy.json\", \"scenario\": \"press.json\"}\n"
      "{\"scenario\": {\"kind\": \"press\", \"depth\": 0.001}}\n"
      "{\"scenario\": {\"kind\": \"press\", \"depth\": 0.002}}",
      folder.path());
  ASSERT_EQ(list.jobs.size(), 2U);  // the second line is the first one in other words
  ASSERT_EQ(list.repeats.size(), 1U);
  EXPECT_EQ(list.repeats[0], "line 2: 1 of its jobs are listed before, the first in line 1, and run once");
  EXPECT_NE(list.jobs[0].id, list.jobs[1].id);
}

TEST(JobList, NamesMeshesByTheirBytes) {
  JobSources sources(our_fingertip);
  const MeshFile mesh = sources.mesh_file("", {});
  EXPECT_EQ(mesh.bytes, "v 1 2 3\n");
  EXPECT_EQ(mesh.name.size(), 64U + 4U);
  EXPECT_TRUE(mesh.name.ends_with(".obj"));
  const MeshFile same =
      sources.mesh_file(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json", {{"/layout/sampling/seed", "3"}});
  EXPECT_EQ(same.bytes, read_file(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj"));
  EXPECT_NE(JobSources::portable_json(sources.source("")).find("\"meshes/" + same.name + "\""), std::string::npos);
}

TEST(JobList, DrawsOtherValuesForOtherSeedsAndRepetitions) {
  const auto line = [](int seed) {
    return on_one_line(R"({"scenario": {"kind": "press"}, "set": {"/scenario/depth": {"uniform": [0.0005, 0.001]},
      "/scenario/tilt_deg": {"normal": [30, 2]}, "/layout/material/modulus": {"log_uniform": [1e4, 1e6]}},
      "repeat": 50, "seed": )") +
           std::to_string(seed) + "}";
  };
  std::set<std::string> values;
  for (const int seed : {1, 2})
    for (const Job& job : expand(line(seed)).jobs) {
      EXPECT_TRUE(job.error.empty()) << job.error;
      const double depth = job.scenario.as<scenarios::Press>().depth;
      EXPECT_TRUE(depth >= 0.0005 && depth <= 0.001);
      for (const JobChange& change : job.changes) values.insert(change.value);
    }
  EXPECT_EQ(values.size(), 300U);
}

TEST(JobList, NamesTheBrokenLineAndKeepsTheOthers) {
  const JobList list =
      expand("{\"scenario\": {\"kind\": \"press\"}}\nnonsense\n{\"scenario\": {\"kind\": \"roll\"}}\n{");
  EXPECT_EQ(list.jobs.size(), 2U);
  ASSERT_EQ(list.broken.size(), 2U);
  EXPECT_EQ(list.broken[0].line, 2);
  EXPECT_TRUE(list.broken[0].message.starts_with("line 1, column 2: is not JSON")) << list.broken[0].message;
  EXPECT_EQ(list.broken[1].line, 4);
}

TEST(JobList, NamesUnknownParameters) {
  const std::string press = R"({"scenario": {"kind": "press"}, "set": )";
  EXPECT_EQ(broken(press + R"({"/scenario/dept": {"values": [1, 2]}}})"),
            "/scenario/dept: unknown key; did you mean \"depth\"?");
  EXPECT_EQ(broken(press + R"({"/layout/material/stiffness": 3}})"),
            "/layout/material/stiffness: is not a parameter of a layout (docs/layout_format.md lists them)");
  EXPECT_EQ(broken(press + R"({"/depth": 3}})"), "/set/~1depth: must begin with /layout/ or /scenario/");
  EXPECT_EQ(broken(press + R"({"/layout/taxels/99/radius": 3}})"),
            "/layout/taxels/99/radius: \"99\" is not an index of an array of 12");
  EXPECT_EQ(broken(press + R"({"/layout/material/modulus/x": 3}})"),
            "/layout/material/modulus/x: \"x\" is below a value without keys");
  EXPECT_EQ(broken(press + R"({"/scenario/depth": {"uniform": [2, 1]}}})"),
            "/set/~1scenario~1depth/uniform: the lower limit 2 is above the upper limit 1");
  EXPECT_EQ(broken(press + R"({"/scenario/depth": {"from": 0, "to": 1, "count": 1.5}}})"),
            "/set/~1scenario~1depth/count: must be a whole number from 2 to 1000000, is 1.5");
  EXPECT_EQ(broken(R"({"scenario": {"kind": "press"}, "depth": 1})"), "/depth: unknown key");
  EXPECT_EQ(broken(R"({"layout": "x.json"})"), "/scenario: is missing");
  EXPECT_TRUE(broken(R"({"layout": "gone.json", "scenario": {}})").ends_with("gone.json: no such file"));
}

TEST(JobList, FailsOnlyTheJobsWithAWrongValue) {
  const JobList list =
      expand(R"({"scenario": {"kind": "press"}, "set": {"/scenario/depth": {"values": [0.001, -1, "deep"]}}})");
  ASSERT_EQ(list.jobs.size(), 3U);
  EXPECT_EQ(list.jobs[0].error, "");
  EXPECT_EQ(list.jobs[1].error, "/scenario/depth: must be greater than 0, is -1");
  EXPECT_EQ(list.jobs[2].error, "/scenario/depth: must be a number, is \"deep\"");
}

TEST(JobList, RefusesMoreThanAMillionJobs) {
  EXPECT_EQ(broken(R"({"scenario": {"kind": "press"}, "set": {"/scenario/depth": {"from": 1, "to": 2, "count": 1e6},)"
                   R"("/scenario/speed": {"values": [1, 2]}}})"),
            "/set: gives more than 1000000 jobs");
  EXPECT_EQ(complaint_of([] {
              expand(R"({"scenario": {}, "set": {"/scenario/depth": {"from": 0.001, "to": 0.002, "count": 1000}}, )"
                     R"("repeat": 1001})");
            }),
            "jobs.jsonl: line 1: the list has more than 1000000 jobs");
}

TEST(Draws, ReachTheMomentsOfTheirDistributions) {
  constexpr int kCount = 20000;
  const auto mean_of = [&](const Draw& draw, auto&& of) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < kCount; ++seed) sum += of(draw_number(draw, seed, "/scenario/depth"));
    return sum / kCount;
  };
  const auto itself = [](double v) { return v; };
  EXPECT_NEAR(mean_of({Distribution::uniform, 2, 6}, itself), 4, 0.05);
  EXPECT_NEAR(mean_of({Distribution::log_uniform, 1, 100}, [](double v) { return std::log10(v); }), 1, 0.03);
  EXPECT_NEAR(mean_of({Distribution::normal, 3, 2}, itself), 3, 0.06);
  EXPECT_NEAR(mean_of({Distribution::normal, 3, 2}, [](double v) { return (v - 3) * (v - 3); }), 4, 0.2);
}

TEST(Draws, DifferBetweenParameters) {
  const Draw draw{Distribution::uniform, 0, 1};
  EXPECT_NE(draw_number(draw, 7, "/scenario/depth"), draw_number(draw, 7, "/scenario/speed"));
  EXPECT_EQ(draw_number(draw, 7, "/scenario/depth"), draw_number(draw, 7, "/scenario/depth"));
}

TEST(Draws, RangeBeginsAndEndsExactly) {
  EXPECT_EQ(value_of_range(0.1, 0.7, 0, 7), 0.1);
  EXPECT_EQ(value_of_range(0.1, 0.7, 6, 7), 0.7);
}

TEST(JobRates, RefusesEpisodesOfDifferentRatesAndUnevenRows) {
  const auto complaint = [](const std::string& lines) {
    return complaint_of([&] { check_rates(expand(lines), "jobs.jsonl"); });
  };
  const std::string sweep = R"({"scenario": {"kind": "sweep", "speed": 0.01}})", newline = "\n",
                    faster = R"({"scenario": {"kind": "sweep", "speed": 0.02}})",
                    uneven = R"({"scenario": {"kind": "press", "record_interval": 0.0123}})",
                    press = R"({"scenario": {"kind": "press", "record_interval": 0.01}})";
  const std::string remedy = ": --fps N resamples all episodes to N rows a second, or give each rate a list of its own";
  EXPECT_EQ(complaint(sweep + newline + press), "accepted");
  EXPECT_EQ(complaint(sweep + newline + press + newline + faster),
            "jobs.jsonl: has episodes of different rows a second, 100 (line 1), 200 (line 3)" + remedy);
  EXPECT_TRUE(complaint(uneven).starts_with("jobs.jsonl: line 1: has a row every ")) << complaint(uneven);
}

}  // namespace
}  // namespace taxel::test
