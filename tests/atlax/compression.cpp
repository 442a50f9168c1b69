#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/compression.hpp>
#include <atlax/error.hpp>
#include <random>

namespace {

using namespace atlax;
using Bytes = std::vector<std::byte>;

/// Compresses by about half.
Bytes sample(std::size_t size) {
    std::mt19937 random(3);
    Bytes out(size);
    for (auto& b : out) b = static_cast<std::byte>(random() % 16);
    return out;
}

TEST(Compression, goesThereAndBack) {
    for (const std::size_t size : {0u, 1u, 1000u, 3'000'000u}) {
        const Bytes bytes = sample(size);
        const Bytes packed = compress(bytes);
        EXPECT_EQ(decompress(packed, size), bytes) << size;
        if (size > 1000) {
            EXPECT_LT(packed.size(), size * 6 / 10);
        }
    }
    EXPECT_EQ(decompress(compress(sample(5000), 19), 5000), sample(5000));
}

TEST(Compression, outputIsBounded) {
    const Bytes packed = compress(Bytes(50'000'000));
    EXPECT_LT(packed.size(), 20'000u);
    EXPECT_THROW(decompress(packed, 1'000'000), Error);
    EXPECT_THROW(decompress(packed, 49'999'999), Error);
    EXPECT_THROW(decompress(compress(sample(1)), 0), Error);
    EXPECT_EQ(decompress(packed, 50'000'000).size(), 50'000'000u);
}

TEST(Compression, damageIsNoticed) {
    const Bytes bytes = sample(2000);
    const Bytes packed = compress(bytes);
    for (std::size_t length = 0; length < packed.size(); ++length)
        EXPECT_THROW(decompress(std::span(packed).first(length), 5000), Error) << length;
    Bytes longer = packed;
    longer.push_back(std::byte{0});
    EXPECT_THROW(decompress(longer, 5000), Error);
    std::mt19937 random(9);
    for (int i = 0; i < 500; ++i) {
        Bytes bad = packed;
        bad[random() % bad.size()] ^= static_cast<std::byte>(1u << random() % 8);
        try {
            EXPECT_EQ(decompress(bad, 5000), bytes) << "a change that changes nothing";
        } catch (const Error&) {
        }
    }
}

TEST(Compression, levelsAreChecked) {
    EXPECT_THROW(compress({}, 0), Error);
    EXPECT_THROW(compress({}, 20), Error);
}

TEST(Compression, streamsTakeAnyPieces) {
    const Bytes bytes = sample(700'000);
    Bytes packed;
    CompressingStream writer(
        [&](std::span<const std::byte> p) { packed.insert(packed.end(), p.begin(), p.end()); });
    for (std::size_t at = 0; at < bytes.size(); at += 997)
        writer.write(std::span(bytes).subspan(at, std::min<std::size_t>(997, bytes.size() - at)));
    writer.finish();
    writer.finish();
    EXPECT_THROW(writer.write(bytes), Error);

    std::size_t at = 0;
    DecompressingStream reader(
        [&](std::span<std::byte> in) {
            const auto length = std::min({in.size(), packed.size() - at, std::size_t{313}});
            std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(at), length, in.begin());
            at += length;
            return length;
        },
        bytes.size());
    Bytes out, piece(1234);
    while (const auto got = reader.read(piece))
        out.insert(out.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
    EXPECT_EQ(out, bytes);
}

TEST(Compression, whatWasFlushedCanBeReadAfterACrash) {
    Bytes packed;
    CompressingStream writer(
        [&](std::span<const std::byte> p) { packed.insert(packed.end(), p.begin(), p.end()); });
    const Bytes bytes = sample(5000);
    writer.write(bytes);
    writer.flush();
    bool given = false;
    DecompressingStream reader(
        [&](std::span<std::byte> in) {
            if (given) return std::size_t{0};
            given = true;
            std::copy(packed.begin(), packed.end(), in.begin());
            return packed.size();
        },
        1'000'000);
    Bytes out(5000);
    EXPECT_EQ(reader.read(out), 5000u);
    EXPECT_EQ(out, bytes);
    EXPECT_THROW(reader.read(out), Error) << "it is cut short";
}

}  // namespace
