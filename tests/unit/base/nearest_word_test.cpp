// The known word that a misspelt word probably means.
#include "core/base/text/words.h"

#include <gtest/gtest.h>

#include <array>

namespace taxel {
namespace {

constexpr std::array<std::string_view, 7> kWords = {"center",    "normal",        "radius", "id",
                                                    "max_depth", "max_angle_deg", "tare"};

TEST(NearestWord, IsAtMostTwoLettersAway) {
  EXPECT_EQ(nearest_word("centre", kWords), "center");
  EXPECT_EQ(nearest_word("normals", kWords), "normal");
  EXPECT_EQ(nearest_word("radus", kWords), "radius");
  EXPECT_EQ(nearest_word("taer", kWords), "tare");
  EXPECT_EQ(nearest_word("rad", kWords), "");
}

TEST(NearestWord, DoesNotCountCaseAndSeparators) {
  EXPECT_EQ(nearest_word("Center", kWords), "center");
  EXPECT_EQ(nearest_word("maxDepth", kWords), "max_depth");
  EXPECT_EQ(nearest_word("max-depth", kWords), "max_depth");
  EXPECT_EQ(nearest_word("ID", kWords), "id");
}

TEST(NearestWord, MayBeABeginning) {
  EXPECT_EQ(nearest_word("max_angle", kWords), "max_angle_deg");
  EXPECT_EQ(nearest_word("center_of_the_taxel", kWords), "center");
  EXPECT_EQ(nearest_word("max", kWords), "");  // too short to tell
}

TEST(NearestWord, IsEmptyForOtherWords) {
  EXPECT_EQ(nearest_word("serial", kWords), "");
  EXPECT_EQ(nearest_word("", kWords), "");
  EXPECT_EQ(nearest_word("x", kWords), "");
  EXPECT_EQ(nearest_word("xy", kWords), "");
  EXPECT_EQ(nearest_word(std::string(1000, 'r'), kWords), "");
  EXPECT_EQ(nearest_word("center", {}), "");
}

TEST(NearestWord, IsAskedFor) {
  EXPECT_EQ(meant_word("centre", kWords), "; did you mean \"center\"?");
  EXPECT_EQ(meant_word("serial", kWords), "");
}

}  // namespace
}  // namespace taxel
