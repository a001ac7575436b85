#include "core/base/text/words.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace taxel {
namespace {

constexpr std::size_t kLongestWord = 40;

/// Number of letters to insert, delete or replace to get from one word to the other (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// Returns the word without separators, in lower case.
std::string plain_letters(std::string_view word) {
  std::string letters;
  for (const char c : word)
    if (c != '_' && c != '-' && c != ' ') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return letters;
}

/// Returns true if one of the words is the beginning of the other, as "max_angle" of "max_angle_deg".
bool is_beginning(const std::string& a, const std::string& b) {
  constexpr std::size_t kShortest = 4;
  return std::min(a.size(), b.size()) >= kShortest && (a.starts_with(b) || b.starts_with(a));
}

}  // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
  constexpr std::size_t kMaxLetters = 2;
  if (word.size() > kLongestWord) return {};
  const std::string letters = plain_letters(word);
  std::string_view best;
  std::size_t nearest = kMaxLetters + 1;
  for (const std::string_view candidate : candidates) {
    const std::string other = plain_letters(candidate);
    // Most letters must agree: two words of three letters are not similar because one letter is the same.
    const std::size_t most = std::min(kMaxLetters, std::min(letters.size(), other.size()) / 2);
    std::size_t distance = edit_distance(letters, other);
    if (distance > most && is_beginning(letters, other))
      distance = kMaxLetters;
    else if (distance > most)
      continue;
    if (distance < nearest) best = candidate, nearest = distance;
  }
  return best;
}

std::string meant_word(std::string_view word, std::span<const std::string_view> candidates) {
  const std::string_view nearest = nearest_word(word, candidates);
  return nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
}

}  // namespace taxel
