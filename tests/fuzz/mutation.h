// Changes of an input that keep most of its form: numbers, words and lines are exchanged, doubled or left out.
#pragma once

#include <cstdint>
#include <string>

namespace taxel::fuzz {

/// Changes `input` once to four times. The same seed makes the same changes.
void mutate(std::string& input, std::uint64_t seed);

}  // namespace taxel::fuzz
