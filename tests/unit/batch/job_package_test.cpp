// Packages of jobs: the shard of a package that has travelled is the shard of the group on the machine of the list.
#include "core/sim/batch/job_package.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/shard.h"
#include "core/sim/batch/run_batch.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

const std::string kLine =
    R"({"layout": ")" TAXEL_SOURCE_DIR
    R"(/assets/layouts/fingertip.taxels.json", "scenario": {"kind": "press", "hold": 0, "clearance": 0.0002, )"
    R"("tilt_deg": 20, "shape": "plate"}, "set": {"/layout/sampling/density": 1e5, )"
    R"("/scenario/depth": {"values": [0.0004, 0.0006, 0.0008]}}})";

class PackageOfJobs : public testing::Test {
 protected:
  JobSources sources_;
  JobList list_ = parse_job_list(kLine, "jobs.jsonl", "/", sources_);
  JobGroup group_ = group_jobs(list_, 16).front();
  JobPackage package_ = pack_group(list_, group_, {}, sources_);

  /// Returns the package as a worker gets it: as text, with the names of copies.
  [[nodiscard]] JobPackage travelled() const {
    JobPackage package = parse_package(package_to_json(package_));
    for (auto& [original, copy] : package.files) copy = original;
    return package;
  }
  static std::string run(const JobPackage& package, JobSources& sources) {
    JobRunner runner(sources);
    return run_package(package, sources, runner, {});
  }
};

TEST_F(PackageOfJobs, HasTheSameTextAfterReading) {
  ASSERT_EQ(package_.jobs.size(), 3U);
  EXPECT_EQ(package_.files.size(), 1U);  // the mesh
  const std::string text = package_to_json(package_);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(package_to_json(parse_package(text)), text);
}

TEST_F(PackageOfJobs, GivesTheShardOfTheGroup) {
  std::vector<const Job*> jobs;
  for (const std::size_t job : group_.jobs) jobs.push_back(&list_.jobs[job]);
  JobRunner runner(sources_);
  const std::string expected = shard_bytes(runner.run(group_.id, jobs, {}, {}), {});
  JobSources elsewhere;
  EXPECT_EQ(run(travelled(), elsewhere), expected);
}

TEST_F(PackageOfJobs, ReadsTheCopyOfTheMesh) {
  const fs::path folder = fs::path(testing::TempDir()) / "job_package_test";
  JobPackage package = travelled();
  const std::string original = package.files.begin()->first, copy = (folder / "skin.obj").string();
  make_folder(folder);
  write_file_atomically(copy, read_file(original));
  package.files = {{"/nowhere/skin.obj", copy}};
  package.source->file = "/nowhere/finger.taxels.json";
  Layout layout = sources_.source(list_.jobs.front().layout).layout;
  const std::string name = layout.mesh.file;
  const std::size_t at = package.source->layout_json.find(name);
  ASSERT_NE(at, std::string::npos);
  package.source->layout_json.replace(at, name.size(), "skin.obj");
  JobSources elsewhere, here;
  EXPECT_EQ(run(package, elsewhere), run(travelled(), here));
}

TEST_F(PackageOfJobs, GivesFailedJobsTheirReasonAndRunsTheOthers) {
  JobPackage package = travelled();
  package.jobs.front().error = "the worker ended";
  JobSources elsewhere;
  const ShardHead head = Shard(run(package, elsewhere), "shard").head();
  EXPECT_EQ(head.outcomes[0].error, "the worker ended");
  EXPECT_EQ(head.outcomes[0].rows, 0);
  EXPECT_GT(head.outcomes[1].rows, 0);
  EXPECT_GT(head.outcomes[2].rows, 0);
}

TEST_F(PackageOfJobs, FailsAsAWhole) {
  const ShardHead head = Shard(failed_shard(package_, "the node is lost"), "shard").head();
  EXPECT_EQ(head.group, group_.id);
  ASSERT_EQ(head.outcomes.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(head.outcomes[k].id, list_.jobs[group_.jobs[k]].id);
    EXPECT_EQ(head.outcomes[k].error, "the node is lost");
  }
}

TEST_F(PackageOfJobs, IsRefusedWithItsField) {
  const std::string text = package_to_json(package_);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    try {
      parse_package(changed);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(refusal(R"("version":1)", R"("version":2)"), "/version: must be 1, is 2");
  EXPECT_EQ(refusal(R"("id":)", R"("name":)").substr(0, 10), "/jobs/0/id");
  EXPECT_NE(refusal(R"("kind":"press")", R"("kind":"push")").find("kind"), std::string::npos);
  EXPECT_THROW(parse_package(text.substr(0, text.size() / 2)), Error);
  EXPECT_THROW(parse_package("[]"), Error);
}

}  // namespace
}  // namespace taxel
