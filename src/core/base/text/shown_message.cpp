#include "core/base/text/shown_message.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text/json_text.h"

namespace taxel {
namespace {

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Returns the length of the UTF-8 character at `at`, or 0 if there is none.
std::size_t length_of_character(std::string_view text, std::size_t at) {
  for (std::size_t length = 1; length <= 4; ++length)
    if (is_utf8(text.substr(at, length))) return length;
  return 0;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n') || byte == 0x7F;
}

std::string without_bad_bytes(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    if (length == 0 || is_control(text[i]))
      shown += '?';
    else
      shown += text.substr(i, length);
    i += std::max(length, std::size_t{1});
  }
  return shown;
}

}  // namespace

std::string shown_part(std::string_view text, std::size_t most) {
  if (text.size() <= most) return without_bad_bytes(text);
  constexpr std::string_view kGap = " ... ";
  std::size_t head = (most - kGap.size()) * 2 / 3, tail = text.size() - (most - kGap.size() - head);
  while (head > 0 && continues_character(text[head])) --head;
  while (tail < text.size() && continues_character(text[tail])) ++tail;
  return without_bad_bytes(text.substr(0, head)) + std::string(kGap) + without_bad_bytes(text.substr(tail));
}

std::string shown_message(const std::exception& error) {
  const auto* const own = dynamic_cast<const Error*>(&error);
  if (own == nullptr) return shown_part(error.what(), kMostShownLine);
  return Error(own->file(), shown_part(own->where()), shown_part(own->message())).what();
}

}  // namespace taxel
