#include "fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "core/base/rng.h"

namespace taxel::fuzz {
namespace {

/// Values at which readers are likely to fail: limits of number types, values without meaning, magic numbers of other
/// formats.
constexpr std::array<std::string_view, 40> kValues{"0",
                                                   "-0",
                                                   "1",
                                                   "-1",
                                                   "2",
                                                   "3",
                                                   "0.5",
                                                   "1e-9",
                                                   "1e6",
                                                   "1e30",
                                                   "1e308",
                                                   "-1e308",
                                                   "1e309",
                                                   "5e-324",
                                                   "nan",
                                                   "inf",
                                                   "127",
                                                   "255",
                                                   "65536",
                                                   "2147483647",
                                                   "2147483648",
                                                   "-2147483648",
                                                   "4294967295",
                                                   "9007199254740993",
                                                   "9223372036854775807",
                                                   "9223372036854775808",
                                                   "18446744073709551615",
                                                   "18446744073709551616",
                                                   "1.5e3",
                                                   "null",
                                                   "true",
                                                   "\"\"",
                                                   "\"a\"",
                                                   "[]",
                                                   "[0]",
                                                   "{}",
                                                   "",
                                                   "\n",
                                                   ",",
                                                   "\xff"};

/// Random numbers for the changes of one input.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : rng_(seed) {}
  /// Returns a number below `end`, which is at least 1.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(rng_.bits(count_++) % end); }

 private:
  CounterRng rng_;
  std::uint64_t count_ = 0;
};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' || c == '_';
}

/// The part [begin, end) of the input.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Returns the word or number at or behind a random position.
Range random_word(const std::string& input, Dice& dice) {
  const std::size_t at = dice.below(input.size());
  const auto found = std::find_if(input.begin() + static_cast<std::ptrdiff_t>(at), input.end(), is_word);
  auto begin = static_cast<std::size_t>(found - input.begin()), end = begin;
  while (begin > 0 && is_word(input[begin - 1])) --begin;
  while (end < input.size() && is_word(input[end])) ++end;
  return {begin, end};
}

Range random_line(const std::string& input, Dice& dice) {
  const std::size_t at = dice.below(input.size());
  const std::size_t before = at == 0 ? std::string::npos : input.rfind('\n', at - 1), after = input.find('\n', at);
  return {before == std::string::npos ? 0 : before + 1, after == std::string::npos ? input.size() : after + 1};
}

Range random_bytes(const std::string& input, Dice& dice) {
  const std::size_t begin = dice.below(input.size());
  return {begin, begin + 1 + dice.below(std::min<std::size_t>(input.size() - begin, 64))};
}

Range random_range(const std::string& input, Dice& dice) {
  const std::size_t kind = dice.below(4);
  if (kind < 2) return random_word(input, dice);
  return kind == 2 ? random_line(input, dice) : random_bytes(input, dice);
}

void mutate_once(std::string& input, Dice& dice) {
  if (input.empty()) input = kValues[dice.below(kValues.size())];
  if (input.empty()) return;
  const Range from = random_range(input, dice), to = random_range(input, dice);
  const std::string text = input.substr(from.begin, from.end - from.begin);
  switch (dice.below(8)) {
    case 0:
      input.insert(to.begin, text);
      break;  // double the word
    case 1:
      input.replace(to.begin, to.end - to.begin, text);
      break;  // move the word to another place
    case 2:
      input.erase(to.begin, to.end - to.begin);
      break;  // remove the word
    case 3:
      input[dice.below(input.size())] ^= static_cast<char>(1U << dice.below(8));
      break;
    case 4:
      input.resize(to.begin);
      break;  // cut off the end
    default:
      input.replace(to.begin, to.end - to.begin, kValues[dice.below(kValues.size())]);
      break;
  }
}

}  // namespace

void mutate(std::string& input, std::uint64_t seed) {
  Dice dice(seed);
  const std::size_t changes = 1 + dice.below(4);
  for (std::size_t i = 0; i < changes; ++i) mutate_once(input, dice);
}

}  // namespace taxel::fuzz
