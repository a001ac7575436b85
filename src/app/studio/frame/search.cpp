// Search of named entries by typed words.
//
// Each typed word takes the best of its matches in the texts of an entry. A match is worth the weight of the text,
// which is largest for the name, times the likeness of the two words, which is 1 for equal words. An entry's score is
// the sum over the typed words, plus advantages for a name that equals or begins with the whole typed text.
#include "app/studio/frame/search.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <utility>

namespace taxel::ui {
namespace {

using Words = std::vector<std::string>;

bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte >= 0x80;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// Returns the parts of a text between the characters that `is_part` refuses.
template <class IsPart>
Words parts_of(std::string_view text, const IsPart& is_part) {
  Words parts;
  std::string part;
  for (const char c : text) {
    if (is_part(c)) {
      part += c;
    } else if (!part.empty()) {
      parts.push_back(std::exchange(part, {}));
    }
  }
  if (!part.empty()) parts.push_back(part);
  return parts;
}

/// Returns the words of a text, without the possessive "'s".
Words words_of_text(std::string_view text) {
  Words words = parts_of(text, is_letter);
  std::erase(words, "s");
  return words;
}

/// Returns a word without the ending of a plural.
std::string_view stem(std::string_view word) {
  constexpr std::size_t kShortest = 4;
  if (word.size() >= kShortest && word.ends_with('s') && !word.ends_with("ss")) word.remove_suffix(1);
  return word;
}

/// Returns the number of typing errors that a word of this length may have.
std::size_t allowed_errors(std::size_t letters) {
  constexpr std::size_t kOneFrom = 4, kTwoFrom = 6;
  return letters >= kTwoFrom ? 2 : letters >= kOneFrom ? 1 : 0;
}

/// Whether words with typing errors match.
enum class Errors { match, differ };

/// Returns how alike a typed word and a word of a text are: 1 if they are equal, 0 if they do not match.
double likeness(std::string_view typed, std::string_view word, Errors with_errors) {
  constexpr double kSameStem = 0.95, kBeginning = 0.7, kLonger = 0.2, kInside = 0.4, kErrors[] = {0.9, 0.6, 0.5};
  constexpr std::size_t kShortestInside = 4;
  if (typed == word) return 1;
  if (stem(typed) == stem(word)) return kSameStem;
  if (word.starts_with(typed))
    return kBeginning + kLonger * static_cast<double>(typed.size()) / static_cast<double>(word.size());
  if (typed.size() >= kShortestInside && word.find(typed) != std::string_view::npos) return kInside;
  if (with_errors == Errors::differ) return 0;
  const std::size_t most = allowed_errors(std::min(typed.size(), word.size()));
  const std::size_t errors = most > 0 ? typing_errors(stem(typed), stem(word), most) : 1;
  return errors <= most ? kErrors[errors] : 0;
}

double best_likeness(const std::string& typed, const Words& words, Errors with_errors = Errors::match) {
  double best = 0;
  for (const std::string& word : words) best = std::max(best, likeness(typed, word, with_errors));
  return best;
}

/// The typed text in its parts.
struct Query {
  std::string text;  ///< in lower case, without outer spaces
  Words words;
  Words keys;  ///< parts between spaces, which may be chords
};

Query query_of(std::string_view typed) {
  constexpr std::array kLeftOut = {"a",  "an", "the", "to", "of", "for", "in",   "on",   "with", "my",  "is",
                                   "it", "do", "i",   "me", "at", "can", "this", "that", "how",  "and", "show"};
  Query query;
  query.text = lower_case(typed);
  query.text.erase(0, query.text.find_first_not_of(' '));
  query.text.erase(query.text.find_last_not_of(' ') + 1);
  query.keys = parts_of(query.text, [](char c) { return c != ' '; });
  query.words = words_of_text(query.text);
  Words kept = query.words;
  std::erase_if(kept, [&](const std::string& word) {
    return std::find(kLeftOut.begin(), kLeftOut.end(), word) != kLeftOut.end();
  });
  if (!kept.empty()) query.words = std::move(kept);
  return query;
}

/// How well an entry matches.
struct Match {
  std::size_t entry = 0;
  std::size_t missing = 0;  ///< number of typed words without a match
  double score = 0;
};

/// Returns whether all typed parts are chords of the entry.
bool is_chord_of(const Query& query, const Words& chords) {
  return !chords.empty() && std::all_of(query.keys.begin(), query.keys.end(), [&](const std::string& key) {
    return std::find(chords.begin(), chords.end(), key) != chords.end();
  });
}

Match match_of(const Query& query, const SearchWords& entry, std::size_t index) {
  constexpr double kName = 10, kWords = 8.5, kPlace = 4, kHelp = 3, kWhole = 100, kBegins = 12, kPhrase = 6,
                   kCovered = 3, kLeastOfHelp = 0.7;
  Match match{index, 0, entry.bias};
  double covered = 0;
  for (const std::string& word : query.words) {
    const double of_name = best_likeness(word, entry.name), of_help = best_likeness(word, entry.help, Errors::differ);
    const double best =
        std::max({kName * of_name, kWords * best_likeness(word, entry.words), kPlace * best_likeness(word, entry.place),
                  of_help >= kLeastOfHelp ? kHelp * of_help : 0});
    match.missing += best > 0 ? 0 : 1;
    match.score += best;
    covered += of_name;
  }
  if (!entry.name.empty()) match.score += kCovered * covered / static_cast<double>(entry.name.size());
  if (entry.whole_name == query.text) match.score += kWhole;
  if (entry.whole_name.starts_with(query.text)) match.score += kBegins;
  const bool is_phrase = query.keys.size() > 1 && entry.further.find(query.text) != std::string::npos;
  if (is_phrase) match.score += kPhrase;
  if (!query.keys.empty() && is_chord_of(query, entry.chords)) match = {index, 0, match.score + kWhole};
  return match;
}

bool has_letters_in_order(const std::string& name, const Words& words) {
  std::string letters;
  for (const std::string& word : words) letters += word;
  std::size_t next = 0;
  for (const char c : name)
    if (next < letters.size() && c == letters[next]) ++next;
  return next == letters.size();
}

}  // namespace

SearchWords::SearchWords(const SearchTexts& texts)
    : whole_name(lower_case(texts.name)),
      further(lower_case(texts.words)),
      name(words_of_text(whole_name)),
      words(words_of_text(further)),
      place(words_of_text(lower_case(texts.place))),
      help(words_of_text(lower_case(texts.help))),
      chords(parts_of(lower_case(texts.keys), [](char c) { return c != ' ' && c != ','; })),
      bias(texts.bias) {}

std::size_t typing_errors(std::string_view a, std::string_view b, std::size_t most) {
  const std::size_t longer = std::max(a.size(), b.size()), shorter = std::min(a.size(), b.size());
  constexpr std::size_t kLongest = 40;
  if (longer - shorter > most || longer > kLongest) return most + 1;
  // Rows of the table of distances between the first i letters of a and the first j letters of b.
  std::array<std::size_t, kLongest + 1> before{}, last{}, row{};
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (is_same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(last, row);
  }
  return std::min(last[b.size()], most + 1);
}

std::vector<std::size_t> search(std::string_view typed, std::span<const SearchWords* const> entries) {
  constexpr std::size_t kFew = 3, kLongestText = 200;
  const Query query = query_of(typed.substr(0, kLongestText));
  std::vector<Match> matches;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Match match = query.text.empty() ? Match{i} : match_of(query, *entries[i], i);
    if (match.missing <= (query.words.size() > 1 ? 1 : 0) && (match.score > entries[i]->bias || query.text.empty()))
      matches.push_back(match);
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return std::pair(a.missing, -a.score) < std::pair(b.missing, -b.score);
  });
  const auto whole = static_cast<std::size_t>(
      std::count_if(matches.begin(), matches.end(), [](const Match& match) { return match.missing == 0; }));
  if (whole >= kFew) matches.resize(whole);
  std::vector<std::size_t> found;
  for (const Match& match : matches) found.push_back(match.entry);
  if (!found.empty() || query.words.empty()) return found;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (has_letters_in_order(entries[i]->whole_name, query.words)) found.push_back(i);
  return found;
}

}  // namespace taxel::ui
