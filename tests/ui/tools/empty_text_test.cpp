// The text of panels that have nothing to display.
#include <gtest/gtest.h>

#include <string>

#include "app/studio/frame/shown.h"

namespace taxel::ui {
namespace {

TEST(EmptyText, SaysThatNothingIsOpenOnlyWhereNothingIs) {
  Shown shown;
  EXPECT_STREQ(shown.empty_text(), "Nothing is open.");
  shown.document.loading.active = true;
  EXPECT_STREQ(shown.empty_text(), "Loading ...");
  shown.document.loading.active = false;
  shown.document.name = "scene";
  EXPECT_EQ(std::string(shown.empty_text()).find("Nothing is open"), std::string::npos);
}

}  // namespace
}  // namespace taxel::ui
