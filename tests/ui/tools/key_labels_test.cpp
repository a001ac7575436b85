// Keys by label: meanings and names of the keys of many layouts.
#include "app/studio/shell/window/keyboard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <sstream>
#include <string_view>

#include "app/studio/frame/keymap.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/shell/menus/found.h"

namespace taxel::studio {
namespace {

/// GLFW's numbers of the keys, row by row: the characters of a US keyboard, and the key next to the left Shift.
constexpr std::string_view kPlaces = "`1234567890-=QWERTYUIOP[]ASDFGHJKL;'\\ZXCVBNM,./\xa1";

int number_of(char place) {
  return static_cast<unsigned char>(place);
}

/// Returns the labels that are listed row by row, with "none" for a key without a label.
KeyLabels labels(const std::string& rows) {
  KeyLabels result;
  std::istringstream stream(rows);
  std::string label;
  for (const char place : kPlaces)
    if (stream >> label && label != "none") result[number_of(place)] = label;
  return result;
}

// Labels as GLFW reports them on Linux.
const KeyLabels kUs = labels(R"(` 1 2 3 4 5 6 7 8 9 0 - = q w e r t y u i o p [ ] a s d f g h j k l ; ' \
                                z x c v b n m , . / <)");
const KeyLabels kGerman = labels(R"(^ 1 2 3 4 5 6 7 8 9 0 ß ´ q w e r t z u i o p ü + a s d f g h j k l ö ä #
                                    y x c v b n m , . - <)");
const KeyLabels kFrench = labels(R"(² & é " ' ( - è _ ç à ) = a z e r t y u i o p ^ $ q s d f g h j k l m ù *
                                    w x c v b n , ; : ! <)");
const KeyLabels kRussian = labels(R"(ё 1 2 3 4 5 6 7 8 9 0 - = й ц у к е н г ш щ з х ъ ф ы в а п р о л д ж э \
                                     я ч с м и т ь б ю . /)");
const KeyLabels kGreek = labels(R"(` 1 2 3 4 5 6 7 8 9 0 - = ; ς ε ρ τ υ θ ι ο π [ ] α σ δ φ γ η ξ κ λ ´ ' \
                                   ζ χ ψ ω β ν μ , . / «)");
const KeyLabels kDvorak = labels(R"(` 1 2 3 4 5 6 7 8 9 0 [ ] ' , . p y f g c r l / = a o e u i d h t n s - \
                                    ; q j k x b m w v z <)");
const KeyLabels kTurkish = labels(R"(" 1 2 3 4 5 6 7 8 9 0 * - q w e r t y u ı o p ğ ü a s d f g h j k l ş i ,
                                     z x c v b n m ö ç . <)");
const KeyLabels kCzech = labels(R"(; + ě š č ř ž ý á í é = ´ q w e r t z u i o p ú ) a s d f g h j k l ů § ¨
                                   y x c v b n m , . - \)");
const KeyLabels kBepo = labels(R"($ " « » ( ) @ + - / * = % b é p o è ^ v d l j z w a u i e , c t s r n m ç
                                  à y x . k ' q g h f ê)");
const KeyLabels kEsperanto = labels(R"(` 1 2 3 4 5 6 7 8 9 0 - = ŝ ĝ e r t ŭ u i o p ĵ ĥ a s d f g h j k l ; ' \
                                       z ĉ c v b n m , . / none)");
const std::vector<KeyLabels> kLayouts{kUs,      kGerman, kFrench, kRussian,   kGreek, kDvorak,
                                      kTurkish, kCzech,  kBepo,   kEsperanto, {}};

ImGuiKey meaning(const KeyLabels& layout, char place) {
  return meanings_of(layout).keys.at(number_of(place));
}

/// Returns the name of a key in texts.
std::string name(const KeyLabels& layout, ImGuiKey key) {
  return ui::chord_name(key, meanings_of(layout).names);
}

std::set<ImGuiKey> us_meanings() {
  std::set<ImGuiKey> all;
  for (const char place : kPlaces) all.insert(imgui_key(number_of(place)));
  return all;
}

/// Returns the meanings of a layout, in which no meaning may be missing or given twice.
std::set<ImGuiKey> distinct_meanings(const KeyLabels& layout) {
  std::set<ImGuiKey> found;
  for (const auto& [place, key] : meanings_of(layout).keys) EXPECT_TRUE(found.insert(key).second) << place;
  return found;
}

TEST(KeyLabels, GiveEachMeaningToOneKey) {
  for (const KeyLabels& layout : kLayouts) EXPECT_EQ(distinct_meanings(layout), us_meanings());
  EXPECT_EQ(us_meanings().size(), kPlaces.size());
  EXPECT_FALSE(us_meanings().contains(ImGuiKey_None));
}

TEST(KeyLabels, GiveEachMeaningToOneKeyInRandomLayouts) {
  constexpr std::array kSome = {"a", "Q", "z", "m", "1", "7", "-",  "=",   "/",
                                ".", "[", "ß", "я", "'", ",", "ch", "\xff"};
  std::mt19937 random(7);
  for (int round = 0; round < 500; ++round) {
    KeyLabels layout;
    for (const char place : kPlaces)
      if (random() % 3 != 0) layout[number_of(place)] = kSome.at(random() % kSome.size());
    ASSERT_EQ(distinct_meanings(layout), us_meanings()) << round;
  }
}

TEST(KeyLabels, PutLettersOnTheKeysWithTheirLabels) {
  for (const KeyLabels& layout : {kUs, kGerman, kFrench, kDvorak, kTurkish, kCzech, kBepo}) {
    std::size_t letters = 0;
    for (const auto& [place, label] : layout) {
      if (label.size() != 1 || label[0] < 'a' || label[0] > 'z') continue;
      EXPECT_EQ(meanings_of(layout).keys.at(place), ImGuiKey_A + (label[0] - 'a')) << label;
      ++letters;
    }
    EXPECT_EQ(letters, 26U);
  }
}

TEST(KeyLabels, PreferTheUsualPlaceOfALabelOnTwoKeys) {
  const KeyLabels layout{{'Y', "z"}, {'Z', "z"}, {'-', "="}, {'=', "="}};
  EXPECT_EQ(meaning(layout, 'Z'), ImGuiKey_Z);
  EXPECT_EQ(meaning(layout, 'Y'), ImGuiKey_Y);
  EXPECT_EQ(meaning(layout, '='), ImGuiKey_Equal);
}

TEST(KeyLabels, KeepPlacesWithoutLatinLetters) {
  for (const KeyLabels& layout : {kRussian, kGreek, kUs, KeyLabels()}) {
    for (const char place : kPlaces) EXPECT_EQ(meaning(layout, place), imgui_key(number_of(place))) << place;
    EXPECT_TRUE(meanings_of(layout).names.empty());
  }
}

TEST(KeyLabels, KeepDigitsThatNeedShiftInTheirRow) {
  for (const KeyLabels& layout : {kFrench, kCzech, kBepo})
    for (const char digit : std::string("0123456789")) {
      EXPECT_EQ(meaning(layout, digit), ImGuiKey_0 + (digit - '0'));
      EXPECT_EQ(name(layout, static_cast<ImGuiKey>(ImGuiKey_0 + (digit - '0'))), std::string(1, digit));
    }
}

TEST(KeyLabels, PutSignsOnTheKeysWithTheirLabels) {
  EXPECT_EQ(meaning(kGerman, '/'), ImGuiKey_Minus);
  EXPECT_EQ(name(kGerman, ImGuiKey_Minus), "-");
  EXPECT_EQ(meaning(kDvorak, '['), ImGuiKey_Slash);
  EXPECT_EQ(meaning(kDvorak, '\''), ImGuiKey_Minus);
  EXPECT_TRUE(meanings_of(kDvorak).names.empty());
  EXPECT_EQ(meaning(kCzech, '-'), ImGuiKey_Equal);
  EXPECT_EQ(meaning(kTurkish, '/'), ImGuiKey_Period);
  EXPECT_EQ(meaning(kCzech, '\xa1'), ImGuiKey_Backslash);
}

TEST(KeyLabels, NameSignsByTheirKeysWhereALayoutLacksThem) {
  EXPECT_EQ(meaning(kGerman, '-'), ImGuiKey_Slash) << "exchanged with the key - of a German keyboard";
  EXPECT_EQ(name(kGerman, ImGuiKey_Slash), "ß");
  EXPECT_EQ(name(kGerman, ImGuiKey_LeftBracket), "ü");
  EXPECT_EQ(name(kGerman, ImGuiKey_RightBracket), "+");
  EXPECT_EQ(name(kGerman, ImGuiKey_Equal), "´");
  EXPECT_EQ(meaning(kFrench, '-'), ImGuiKey_Minus) << "the label - is in the row of digits";
  EXPECT_EQ(name(kFrench, ImGuiKey_Minus), ")");
  EXPECT_EQ(name(kFrench, ImGuiKey_Period), ":");
  EXPECT_EQ(name(kFrench, ImGuiKey_Slash), "!");
  EXPECT_EQ(name(kFrench, ImGuiKey_Equal), "=");
  EXPECT_EQ(name(kEsperanto, ImGuiKey_Q), "ŝ") << "a letter that the layout lacks";
}

TEST(KeyLabels, NameTheTurkishIWithItsDot) {
  EXPECT_EQ(meaning(kTurkish, '\''), ImGuiKey_I);
  EXPECT_EQ(name(kTurkish, ImGuiKey_I), "İ");
}

TEST(KeyLabels, NameBothChordsOfARow) {
  const ui::KeyNames names = meanings_of(kGerman).names;
  EXPECT_EQ(ui::chord_names(ui::binding_of(ui::ScaleInterface{1}), names), "Ctrl+´");
  EXPECT_EQ(ui::chord_names(ui::binding_of(ui::RedoStep{}), names), "Ctrl+Shift+Z, Ctrl+Y");
}

TEST(KeyLabels, AreFoundInHelpAndPalette) {
  const ui::KeyNames names = meanings_of(kGerman).names;
  const std::vector<ui::HelpRow> rows = ui::find_help("ß", names);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].label, std::string("Show only these"));
  EXPECT_EQ(rows[0].keys, "ß");
  EXPECT_EQ(rows[1].keys, "Shift+ß");
  const std::vector<ui::Found> entries = ui::all_found(names);
  const std::vector<std::size_t> found = ui::find_entries("ß", entries);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(entries[found[0]].texts.name, "Show only these");
  EXPECT_TRUE(ui::find_help("ß").empty());
}

TEST(Keyboard, ReleasesThePressedKeyAfterAChangeOfLayout) {
  Keyboard keyboard;
  EXPECT_FALSE(keyboard.set_labels(kUs)) << "the names are those of a US keyboard before";
  EXPECT_EQ(keyboard.press('Y'), ImGuiKey_Y);
  EXPECT_TRUE(keyboard.set_labels(kGerman));
  EXPECT_FALSE(keyboard.set_labels(kGerman));
  EXPECT_EQ(keyboard.release('Y'), ImGuiKey_Y);
  EXPECT_EQ(keyboard.press('Y'), ImGuiKey_Z);
  EXPECT_EQ(keyboard.release('Y'), ImGuiKey_Z);
  EXPECT_EQ(keyboard.names(), meanings_of(kGerman).names);
  EXPECT_FALSE(keyboard.set_labels(kGerman));
}

TEST(Keyboard, KeepsKeysWithoutALabel) {
  Keyboard keyboard;
  keyboard.set_labels(kFrench);
  constexpr int kEscape = 256, kUnknown = -1;  // of GLFW
  EXPECT_EQ(keyboard.press(kEscape), ImGuiKey_Escape);
  EXPECT_EQ(keyboard.release(kEscape), ImGuiKey_Escape);
  EXPECT_EQ(keyboard.press(kUnknown), ImGuiKey_None);
}

}  // namespace
}  // namespace taxel::studio
