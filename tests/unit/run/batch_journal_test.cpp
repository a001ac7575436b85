// The journal of a batch: replay of whole, cut and damaged journals.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/files.h"
#include "core/base/rng.h"
#include "core/run/batch/batch_folder.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

const BatchIdentity kIdentity{"0123abcd", "taxel 0.1.0", {false, true, 16}};

/// Returns the text of a journal with `count` groups.
std::string journal_of(const TempFolder& folder, int count) {
  const std::filesystem::path path = folder / "journal";
  BatchJournal journal(path, kIdentity);
  for (int i = 0; i < count; ++i) journal.add_group("group" + std::to_string(i));
  return read_file(path);
}

TEST(BatchJournal, ReturnsItsGroups) {
  const TempFolder folder;
  const std::string text = journal_of(folder, 3);
  const JournalContent content = replay_journal(text, "journal");
  EXPECT_EQ(content.identity, kIdentity);
  EXPECT_EQ(content.groups, (std::set<std::string>{"group0", "group1", "group2"}));
  EXPECT_FALSE(content.is_complete);
  BatchJournal journal(folder / "journal", kIdentity);
  journal.forget_group("group1");
  journal.complete();
  const JournalContent later = replay_journal(read_file(folder / "journal"), "journal");
  EXPECT_EQ(later.groups, (std::set<std::string>{"group0", "group2"}));
  EXPECT_TRUE(later.is_complete);
}

TEST(BatchJournal, KeepsAllWholeLinesOfACutJournal) {
  const TempFolder folder;
  const std::string text = journal_of(folder, 20);
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const std::string cut = text.substr(0, size);
    const JournalContent content = replay_journal(cut, "journal");
    const auto lines = static_cast<std::size_t>(std::ranges::count(cut, '\n'));
    EXPECT_EQ(content.identity.has_value(), lines > 0);
    EXPECT_EQ(content.groups.size(), lines > 0 ? lines - 1 : 0);
    EXPECT_EQ(content.broken_lines, cut.empty() || cut.back() == '\n' ? 0U : 1U);
  }
}

TEST(BatchJournal, IsWholeAgainAfterItWasCut) {
  const TempFolder folder;
  const std::string text = journal_of(folder, 10);
  const CounterRng rng(4);
  for (std::uint64_t i = 0; i < 30; ++i) {
    write_file_atomically(folder / "journal", text.substr(0, rng.bits(i) % text.size()));
    BatchJournal journal(folder / "journal", kIdentity);
    for (int k = 0; k < 10; ++k)
      if (!journal.content().groups.contains("group" + std::to_string(k)))
        journal.add_group("group" + std::to_string(k));
    const JournalContent content = replay_journal(read_file(folder / "journal"), "journal");
    EXPECT_EQ(content.broken_lines, 0U);
    EXPECT_EQ(content.groups.size(), 10U);
  }
}

TEST(BatchJournal, SkipsDamagedLines) {
  const TempFolder folder;
  std::string text = journal_of(folder, 3);
  text[text.find("group1") + 5] = '7';
  const JournalContent content = replay_journal(text, "journal");
  EXPECT_EQ(content.groups, (std::set<std::string>{"group0", "group2"}));
  EXPECT_EQ(content.broken_lines, 1U);
}

TEST(BatchJournal, RefusesOtherFilesAndVersions) {
  EXPECT_EQ(complaint_of([] { replay_journal("hello\nworld\n", "j"); }), "j: is not the journal of a batch");
  EXPECT_EQ(complaint_of(
                [] { replay_journal("0d6d1cf07d1d2f3d {\"format\":\"taxel-batch-journal\",\"version\":2}\n", "j"); }),
            "j: is not the journal of a batch");  // a checksum that is not the line's
  // The checksum of this line is right.
  EXPECT_EQ(complaint_of(
                [] { replay_journal("6c23cf61380fd70e {\"format\":\"taxel-batch-journal\",\"version\":3}\n", "j"); }),
            "j: /version: is 3, this program continues version 2: finish the batch with the program that began it, or "
            "give another folder");
}

TEST(BatchJournal, NamesTheDifferenceBetweenBatches) {
  const auto complaint = [](const BatchIdentity& other) {
    return complaint_of([&] { check_same_batch(kIdentity, other, "j"); });
  };
  const std::string begin = "j: belongs to another batch: ", end = "; give another folder, or remove this one";
  EXPECT_EQ(complaint(kIdentity), "accepted");
  EXPECT_EQ(complaint({"ffff", "taxel 0.1.0", {false, true, 16}}), begin + "its list has other jobs" + end);
  EXPECT_EQ(complaint({"0123abcd", "taxel 0.2.0", {false, true, 16}}),
            begin + "it was begun by taxel 0.1.0, this is taxel 0.2.0" + end);
  EXPECT_EQ(complaint({"0123abcd", "taxel 0.1.0", {true, true, 16}}), begin + "its numbers have 32 bits" + end);
  EXPECT_EQ(complaint({"0123abcd", "taxel 0.1.0", {false, false, 16}}), begin + "it records poses" + end);
  EXPECT_EQ(complaint({"0123abcd", "taxel 0.1.0", {false, true, 8}}), begin + "its groups have up to 16 jobs" + end);
}

}  // namespace
}  // namespace taxel::test
