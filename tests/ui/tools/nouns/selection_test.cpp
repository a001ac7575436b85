// The selection of taxels: clicks, taxels that the layout does not have, and indices.
#include "app/studio/frame/viewer.h"

#include <gtest/gtest.h>

namespace taxel::ui {
namespace {

/// A layout of taxels 4, 7 and 9.
Layout three_taxels() {
  Layout layout;
  layout.taxels.resize(3);
  layout.taxels[0].id = 4, layout.taxels[1].id = 7, layout.taxels[2].id = 9;
  return layout;
}

TEST(ClickTaxel, SelectsOneTaxelOrTogglesWithShift) {
  Selection selection;
  click_taxel(selection, 4, false);
  click_taxel(selection, 7, true);
  EXPECT_EQ(selection.taxels, (std::vector<int>{4, 7}));
  click_taxel(selection, 4, true);
  EXPECT_EQ(selection.taxels, (std::vector<int>{7}));
  click_taxel(selection, 9, false);
  EXPECT_EQ(selection.taxels, (std::vector<int>{9}));
}

TEST(KeepOnly, DropsTaxelsThatTheLayoutDoesNotHave) {
  Selection selection;
  selection.taxels = {9, 5, 4};
  selection.keep_only(three_taxels());
  EXPECT_EQ(selection.taxels, (std::vector<int>{9, 4}));
}

TEST(SelectedIndices, AscendWhateverTheOrderOfSelection) {
  Selection selection;
  selection.taxels = {9, 5, 4};
  EXPECT_EQ(selected_indices(selection, three_taxels()), (std::vector<int>{0, 2}));
  EXPECT_EQ(active_index(selection, three_taxels()), 0) << "taxel 4 was selected last";
  selection.taxels = {9, 5};
  EXPECT_EQ(active_index(selection, three_taxels()), -1) << "the layout has no taxel 5";
}

}  // namespace
}  // namespace taxel::ui
