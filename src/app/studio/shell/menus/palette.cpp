#include "app/studio/shell/menus/palette.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

#include "app/studio/frame/synonyms.h"
#include "app/studio/nouns/menus/window_commands.h"

namespace taxel::ui {

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool is_command(const Binding& b) {
  return b.context != Context::gesture && b.context != Context::widget && !b.command.is<Escape>() &&
         !b.command.is<OpenPalette>();
}

bool has_word_with(const std::string& name, const std::string& start) {
  for (std::size_t at = name.find(start); at != std::string::npos; at = name.find(start, at + 1))
    if (at == 0 || std::isalnum(static_cast<unsigned char>(name[at - 1])) == 0) return true;
  return false;
}

bool letters_in_order(const std::string& name, const std::string& letters) {
  std::size_t next = 0;
  for (const char c : name)
    if (next < letters.size() && c == letters[next]) ++next;
  return next == letters.size();
}

constexpr int kLettersOnly = 4, kNoMatch = 9;

/// How well a command is meant: 0 best.
int rank_of(const Binding& b, const std::string& typed, const KeyNames& names) {
  const std::string name = lower(b.label);
  if (name.starts_with(typed)) return 0;
  if (has_word_with(name, typed)) return 1;
  const std::string all = name + " " + lower(b.menu != nullptr ? b.menu : "") + " " + lower(chord_names(b, names)) +
                          " " + std::string(synonyms_of(b.label));
  std::istringstream words(typed);
  bool in_names = true, in_all = true;
  for (std::string word; words >> word;) {
    in_names = in_names && has_word_with(name, word);
    in_all = in_all && all.find(word) != std::string::npos;
  }
  if (in_names) return 2;
  if (in_all) return 3;
  std::string letters;
  std::copy_if(typed.begin(), typed.end(), std::back_inserter(letters), [](char c) { return c != ' '; });
  return letters_in_order(name, letters) ? kLettersOnly : kNoMatch;
}

}  // namespace

std::vector<const Binding*> find_commands(std::string_view typed, const KeyNames& names) {
  std::string text = lower(typed);
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  std::vector<std::pair<int, const Binding*>> found;
  for (const Binding& b : bindings()) {
    if (!is_command(b)) continue;
    if (const int rank = rank_of(b, text, names); rank < kNoMatch) found.emplace_back(rank, &b);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Binding*> commands;
  for (const auto& [rank, binding] : found)
    if (rank < kLettersOnly || found.front().first == kLettersOnly) commands.push_back(binding);
  return commands;
}

}  // namespace taxel::ui
