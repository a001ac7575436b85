#include "core/base/text/sensor_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace taxel {
namespace {

using Texts = std::vector<std::string>;

/// A word or an abbreviation in names of bodies, and the word that a label has for it.
struct Abbreviation {
  std::string_view text, word;
};

/// Abbreviations of fingers, of two letters: of the Shadow, Allegro and LEAP hands.
constexpr std::array kFingers = {Abbreviation{"ff", "index"},  Abbreviation{"if", "index"},
                                 Abbreviation{"mf", "middle"}, Abbreviation{"rf", "ring"},
                                 Abbreviation{"lf", "little"}, Abbreviation{"pf", "little"},
                                 Abbreviation{"th", "thumb"}};
/// Whole words for fingers. A name like "index_middle" has its finger first and its link second.
constexpr std::array kFingerWords = {
    Abbreviation{"index", "index"},   Abbreviation{"forefinger", "index"}, Abbreviation{"middle", "middle"},
    Abbreviation{"ring", "ring"},     Abbreviation{"little", "little"},    Abbreviation{"pinky", "little"},
    Abbreviation{"pinkie", "little"}, Abbreviation{"thumb", "thumb"},      Abbreviation{"palm", "palm"}};
constexpr std::array kSides = {Abbreviation{"rh", "right"}, Abbreviation{"right", "right"}, Abbreviation{"r", "right"},
                               Abbreviation{"lh", "left"},  Abbreviation{"left", "left"},   Abbreviation{"l", "left"}};
/// Links that follow an abbreviation without a separator, as in "ffdistal".
constexpr std::array<std::string_view, 12> kLinks = {"distal",     "middle",       "proximal", "knuckle",
                                                     "metacarpal", "base",         "hub",      "tip",
                                                     "medial",     "intermediate", "pip",      "mcp"};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

Texts words_of_name(const std::string& name) {
  Texts words(1);
  for (const char c : name) {
    if (std::string_view("_- /:,").find(c) == std::string_view::npos) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::optional<std::string> meaning(std::span<const Abbreviation> known, const std::string& text) {
  const auto found = std::ranges::find(known, text, &Abbreviation::text);
  return found == known.end() ? std::nullopt : std::optional<std::string>(found->word);
}

/// The parts of the name of a body of a hand. Texts are empty if the name does not have them.
struct HandName {
  std::string side, finger, link;
};

/// Splits a word like "ffdistal". Returns false if the word is something else.
bool split_word(const std::string& word, HandName& name) {
  constexpr std::size_t kLetters = 2;
  if (word.size() <= kLetters || std::ranges::find(kLinks, word.substr(kLetters)) == kLinks.end()) return false;
  const auto finger = meaning(kFingers, word.substr(0, kLetters));
  if (finger) name.finger = *finger, name.link = word.substr(kLetters);
  return finger.has_value();
}

HandName hand_name(const std::string& text) {
  HandName name;
  for (const std::string& written : words_of_name(text)) {
    const std::string word = lower(written);
    if (name.finger.empty()) {
      if (const auto side = meaning(kSides, word); side && name.side.empty()) {
        name.side = *side;
        continue;
      }
      if (split_word(word, name)) continue;
      auto finger = meaning(kFingers, word);
      if (!finger) finger = meaning(kFingerWords, word);
      if (finger) {
        name.finger = *finger;
        continue;
      }
    }
    name.link += (name.link.empty() ? "" : " ") + written;
  }
  return name;
}

/// Returns the number of words at the beginning (or the end) that all names have in common.
std::size_t shared_words(const std::vector<Texts>& names, bool at_end) {
  std::size_t shared = names.empty() ? 0 : names.front().size();
  for (const Texts& words : names) {
    std::size_t same = 0;
    const auto at = [at_end](const Texts& list, std::size_t i) { return list[at_end ? list.size() - 1 - i : i]; };
    while (same < std::min(shared, words.size()) && at(words, same) == at(names.front(), same)) ++same;
    shared = same;
  }
  return shared;
}

/// Returns possible names of each sensor, the shortest first. The last one is the whole name.
std::vector<Texts> possible_names(const Texts& names) {
  std::vector<Texts> possible(names.size());
  std::vector<Texts> others;  // words of names without a finger
  for (const std::string& name : names)
    if (hand_name(name).finger.empty()) others.push_back(words_of_name(name));
  const std::size_t first = shared_words(others, false), last = shared_words(others, true);
  const bool keeps_words = std::ranges::all_of(others, [&](const Texts& name) { return name.size() > first + last; });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const HandName hand = hand_name(names[i]); !hand.finger.empty()) {
      possible[i].push_back(hand.finger);
      const std::string linked = hand.link.empty() ? hand.finger : hand.finger + " " + hand.link;
      possible[i].push_back(linked);
      if (!hand.side.empty()) possible[i].push_back(hand.side + " " + linked);
    } else if (others.size() > 1 && keeps_words) {
      const Texts words = words_of_name(names[i]);
      const auto begin = words.begin() + static_cast<std::ptrdiff_t>(first);
      possible[i].push_back(fmt::format("{}", fmt::join(begin, words.end() - static_cast<std::ptrdiff_t>(last), " ")));
    }
    possible[i].push_back(names[i]);
  }
  return possible;
}

}  // namespace

std::string sensor_name(const std::string& body, const std::set<std::string>& taken) {
  std::string start = body;
  for (char& c : start)
    if (c == ',' || std::isspace(static_cast<unsigned char>(c)) != 0) c = '_';
  std::string name = start;
  for (int number = 2; taken.contains(name); ++number) name = fmt::format("{}_{}", start, number);
  return name;
}

Texts short_sensor_names(const Texts& names) {
  if (names.size() < 2) return names;
  const std::vector<Texts> possible = possible_names(names);
  std::vector<std::size_t> level(names.size(), 0);
  Texts shortened(names.size());
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    std::map<std::string, int> counts;
    for (std::size_t i = 0; i < names.size(); ++i) ++counts[shortened[i] = possible[i][level[i]]];
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (counts[shortened[i]] == 1 || level[i] + 1 == possible[i].size()) continue;
      ++level[i];
      is_changed = true;
    }
  }
  return shortened;
}

}  // namespace taxel
