// Changes of an input that keep most of its form: numbers, words and lines are exchanged, doubled or removed.
#pragma once

#include <cstdint>
#include <string>

namespace taxel::fuzz {

/// Changes `input` one to four times. The same seed gives the same changes.
void mutate(std::string& input, std::uint64_t seed);

}  // namespace taxel::fuzz
