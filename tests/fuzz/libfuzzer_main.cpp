// Joins the only target of a program to libFuzzer, whose own main() calls these functions.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "fuzz/mutation.h"
#include "fuzz/target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  taxel::fuzz::targets().front().run(std::string(data, data + size));
  return 0;
}

/// Half of the mutations are libFuzzer's own mutations of bytes. The other half exchanges whole words and numbers.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::string text(data, data + size);
  taxel::fuzz::mutate(text, seed);
  if (text.size() > max_size) text.resize(max_size);
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
