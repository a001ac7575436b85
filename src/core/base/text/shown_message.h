// Messages as they are shown. A message may quote a file, so it may be long, and its bytes need not be text.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>

namespace taxel {

/// Largest length of a place or of a sentence that is shown, and of a line with the file, the place and the sentence.
inline constexpr std::size_t kMostShown = 300, kMostShownLine = 900;

/// Returns a text as a part of a message: bytes that are no UTF-8 and control characters but line breaks as "?", and of
/// a text of more than `most` bytes the beginning and the end.
std::string shown_part(std::string_view text, std::size_t most = kMostShown);

/// Returns what() of an exception for a message. Place and sentence of an Error are shown parts, its file is whole.
std::string shown_message(const std::exception& error);

}  // namespace taxel
