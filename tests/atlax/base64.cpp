#include <gtest/gtest.h>

#include <atlax/base64.hpp>
#include <span>
#include <string>

namespace {

std::string encoded(const std::string& text) {
    return atlax::toBase64(std::as_bytes(std::span(text)));
}

std::string decoded(const std::string& text) {
    const auto bytes = atlax::fromBase64(text);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The examples of RFC 4648, without padding.
TEST(Base64, IsThatOfTheStandard) {
    const std::pair<const char*, const char*> pairs[] = {
        {"", ""},           {"f", "Zg"},          {"fo", "Zm8"},         {"foo", "Zm9v"},
        {"foob", "Zm9vYg"}, {"fooba", "Zm9vYmE"}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [plain, letters] : pairs) {
        EXPECT_EQ(encoded(plain), letters);
        EXPECT_EQ(decoded(letters), plain);
    }
}

TEST(Base64, EveryByteComesBack) {
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    EXPECT_EQ(decoded(encoded(bytes)), bytes);
}

TEST(Base64, LineEndsCountForNothingAndOtherCharactersEndIt) {
    EXPECT_EQ(decoded("Zm9v\r\n YmFy"), "foobar");
    EXPECT_EQ(decoded("Zm9v.YmFy"), "foo");
    EXPECT_EQ(decoded("Zm8="), "fo");
}

}  // namespace
