// The description of a data set: who wrote it, the jobs that failed, and folders that are no data set.
#include "core/run/batch/data_set_meta.h"

#include <gtest/gtest.h>

#include "core/base/files.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

constexpr const char* kInfo = R"({"codebase_version": "v3.0", "features": {}})";
constexpr const char* kHead =
    R"({"format": "taxel-data-set", "version": 1, "program": "taxel 9", "bits": 64, "episodes": 12, "failed": 1})";

/// A folder with the two files of every data set, to be broken.
class DataSetHeadFolder : public testing::Test {
 protected:
  DataSetHeadFolder() {
    make_folder(folder_ / "meta");
    write(kDataSetInfoFile, kInfo);
    write(kDataSetHeadFile, kHead);
  }
  void write(const char* name, const std::string& text) const { write_file_atomically(folder_ / name, text); }
  [[nodiscard]] std::string complaint() const {
    return complaint_of([&] { read_data_set_head(folder_ / ""); });
  }
  /// Returns a message about a file of the folder.
  [[nodiscard]] std::string about(const char* name, const std::string& message) const {
    return (folder_ / "" / name).string() + ": " + message;
  }

  TempFolder folder_;
};

TEST_F(DataSetHeadFolder, HasTheProgramAndTheJobsThatFailed) {
  write(kFailedJobsFile, R"({"line":3,"error":"is not JSON"})"
                         "\n"
                         R"({"line":2,"number":5,"job":"ab","error":"unstable","changes":{"/scenario/depth":0.001}})"
                         "\n");
  const DataSetHead head = read_data_set_head(folder_ / "");
  EXPECT_EQ(head.program, "taxel 9");
  EXPECT_EQ(head.bits, 64);
  EXPECT_EQ(head.episodes, 12);
  ASSERT_EQ(head.broken.size(), 1U);
  EXPECT_EQ(head.broken[0].line, 3);
  ASSERT_EQ(head.failed.size(), 1U);
  EXPECT_EQ(head.failed[0].number, 5);
  EXPECT_EQ(head.failed[0].error, "unstable");
  EXPECT_EQ(head.failed[0].changes, (std::vector<JobChange>{{"/scenario/depth", "0.001"}}));
}

TEST_F(DataSetHeadFolder, RefusesNewerVersionsWithTheRemedy) {
  write(kDataSetHeadFile, R"({"format": "taxel-data-set", "version": 2})");
  EXPECT_EQ(complaint(), about(kDataSetHeadFile, "/version: is 2, this program reads version 1: update this program"));
  write(kDataSetInfoFile, R"({"codebase_version": "v4.0"})");
  EXPECT_EQ(complaint(), about(kDataSetInfoFile,
                               "/codebase_version: is v4.0, this program reads v3.0: write the data "
                               "set by `taxel batch` of this version"));
}

TEST_F(DataSetHeadFolder, NamesMissingFilesWithTheRemedy) {
  std::filesystem::remove(folder_ / kDataSetHeadFile);
  EXPECT_EQ(complaint(), about(kDataSetHeadFile,
                               "no such file: only data sets of `taxel batch` hold the jobs of their "
                               "episodes; make one by that command"));
  std::filesystem::remove(folder_ / kDataSetInfoFile);
  EXPECT_EQ(complaint(), about(kDataSetInfoFile,
                               "no such file: the folder is no data set of `taxel batch`, or was "
                               "copied in part"));
  make_folder(folder_ / ".batch");
  EXPECT_EQ(complaint(), about(kDataSetInfoFile,
                               "no such file: the batch is not finished; run the same `taxel batch` "
                               "command again"));
  EXPECT_EQ(complaint_of([&] { read_data_set_head(folder_ / "gone"); }),
            (folder_ / "gone").string() + ": no such folder");
}

TEST_F(DataSetHeadFolder, NamesDamagedFiles) {
  const std::vector<std::pair<std::string, std::string>> heads{
      {"{", "line 1, column 2: is not JSON"},
      {"[]", "must be an object"},
      {"{}", "/format: must be taxel-data-set"},
      {R"({"format": "taxel-data-set"})", "/version: is missing"},
      {R"({"format": "taxel-data-set", "version": 1, "program": "p", "bits": 16})", "/bits: must be 32 or 64, is 16"},
      {R"({"format": "taxel-data-set", "version": 1, "program": "p", "bits": 32, "episodes": -1})",
       "/episodes: must be a whole number, 0 or more, is -1"}};
  for (const auto& [text, message] : heads) {
    write(kDataSetHeadFile, text);
    EXPECT_EQ(complaint().substr(0, about(kDataSetHeadFile, message).size()), about(kDataSetHeadFile, message));
  }
  write(kDataSetHeadFile, kHead);
  for (const char* line : {"{", "3", R"({"line": 1})", R"({"line": 1, "error": 2})",
                           R"({"line": 1, "error": "e", "number": 0, "job": "", "changes": []})"}) {
    write(kFailedJobsFile, "\n" + std::string(line) + "\n");
    EXPECT_TRUE(complaint().starts_with(about(kFailedJobsFile, "line 2: "))) << complaint();
  }
}

TEST(EpisodeChanges, AreValuesByPointer) {
  EXPECT_EQ(parse_changes(R"({"/scenario/depth": 0.25, "/layout/name": "a b"})", "file", "row 1"),
            (std::vector<JobChange>{{"/scenario/depth", "0.25"}, {"/layout/name", "\"a b\""}}));
  EXPECT_EQ(complaint_of([] { parse_changes("[1", "file", "row 1"); }), "file: row 1: must be a JSON object, is [1");
  EXPECT_EQ(number_of_json("0.25"), 0.25);
  EXPECT_EQ(number_of_json("\"0.25\""), std::nullopt);
  EXPECT_EQ(number_of_json("1 2"), std::nullopt);
}

}  // namespace
}  // namespace taxel::test
