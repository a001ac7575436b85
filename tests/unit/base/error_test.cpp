// Texts of errors: file, place and message.
#include "core/base/error.h"

#include <gtest/gtest.h>

#include "core/base/text/message.h"

namespace taxel {
namespace {

TEST(Error, JoinsFilePlaceAndMessage) {
  EXPECT_STREQ(Error("a.json", "/taxels/3", "radius is 0").what(), "a.json: /taxels/3: radius is 0");
  EXPECT_STREQ(Error("a.json", "no such file").what(), "a.json: no such file");
  EXPECT_STREQ(Error("only this").what(), "only this");
  const Error error("a.json", "/taxels/3", "radius is 0");
  EXPECT_EQ(error.file(), "a.json");
  EXPECT_EQ(error.where(), "/taxels/3");
  EXPECT_EQ(error.message(), "radius is 0");
}

TEST(ShownMessage, IsCutBetweenCharactersAndKeepsBothEnds) {
  EXPECT_EQ(shown_part("short"), "short");
  const std::string exact(kMostShown, 'x');
  EXPECT_EQ(shown_part(exact), exact);
  for (std::size_t shift = 0; shift < 4; ++shift) {
    std::string text(shift, 'a');
    for (int i = 0; i < 50'000; ++i) text += "\u00e9";
    const std::string shown = shown_part(text);
    EXPECT_LE(shown.size(), kMostShown);
    EXPECT_GE(shown.size(), kMostShown - 2);
    EXPECT_EQ(shown.find('?'), std::string::npos) << shown;
    EXPECT_TRUE(shown.ends_with("\u00e9")) << shown;
  }
}

TEST(ShownMessage, HasNeitherControlCharactersNorBytesThatAreNoText) {
  EXPECT_EQ(shown_part("is \x89PNG\x1b[2J and \xc3\xa9\xc3"), "is ?PNG?[2J and \xc3\xa9?");
  EXPECT_EQ(shown_part("two\nlines"), "two\nlines");
}

TEST(ShownMessage, KeepsTheFileAndCutsPlaceAndSentence) {
  const std::string file = "/" + std::string(1000, 'f'), key = "/" + std::string(100'000, 'k');
  const std::string shown = shown_message(Error(file, key, "is \"" + std::string(100'000, 'v') + "\", must be 1"));
  EXPECT_TRUE(shown.starts_with(file + ": /kkk")) << shown;
  EXPECT_TRUE(shown.ends_with("vvv\", must be 1")) << shown;
  EXPECT_LE(shown.size(), file.size() + 2 * kMostShown + 4);
  EXPECT_EQ(shown_message(std::runtime_error("lost")), "lost");
}

TEST(Error, NamesItsSeverity) {
  EXPECT_STREQ(to_string(Severity::note), "note");
  EXPECT_STREQ(to_string(Severity::warning), "warning");
  EXPECT_STREQ(to_string(Severity::error), "error");
}

}  // namespace
}  // namespace taxel
