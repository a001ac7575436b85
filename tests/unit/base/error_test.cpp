// Texts of errors: file, place and message.
#include "core/base/error.h"

#include <gtest/gtest.h>

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

TEST(Error, NamesItsSeverity) {
  EXPECT_STREQ(to_string(Severity::note), "note");
  EXPECT_STREQ(to_string(Severity::warning), "warning");
  EXPECT_STREQ(to_string(Severity::error), "error");
}

}  // namespace
}  // namespace taxel
