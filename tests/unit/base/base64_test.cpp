// Base64: the test vectors of RFC 4648, all bytes, and texts that are no Base64.
#include "core/base/text/base64.h"

#include <gtest/gtest.h>

#include <utility>

namespace taxel {
namespace {

TEST(Base64, AgreesWithTheVectorsOfTheRfc) {
  using Pair = std::pair<const char*, const char*>;
  for (const auto& [bytes, text] : {Pair{"", ""}, Pair{"f", "Zg=="}, Pair{"fo", "Zm8="}, Pair{"foo", "Zm9v"},
                                    Pair{"foob", "Zm9vYg=="}, Pair{"fooba", "Zm9vYmE="}, Pair{"foobar", "Zm9vYmFy"}}) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
  EXPECT_EQ(from_base64("Zm9vYg"), "foob") << "without padding";
}

TEST(Base64, ReturnsAllBytesUnchanged) {
  std::string bytes;
  for (int i = 0; i < 1024; ++i) bytes += static_cast<char>(i * i + i / 256);
  for (std::size_t size = bytes.size() - 3; size <= bytes.size(); ++size)
    EXPECT_EQ(from_base64(base64(bytes.substr(0, size))), bytes.substr(0, size));
}

TEST(Base64, RefusesOtherTexts) {
  for (const char* text : {"Z", "Zm9vY", "Zm9v YmFy", "Zm9v\n", "Zm9*", "Z=9v", "Zg===", "\xC3\xA4\xC3\xA4"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace taxel
