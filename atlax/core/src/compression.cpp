#include <zstd.h>

#include <algorithm>
#include <atlax/compression.hpp>
#include <atlax/error.hpp>
#include <string>

namespace atlax {

namespace {

constexpr int lowestLevel = 1;
constexpr int highestLevel = 19;
/// The window of level 19, and the most that a reader is ready to hold.
constexpr int windowLog = 23;

void require(std::size_t result, const char* what) {
    if (ZSTD_isError(result) != 0)
        throw Error(std::string(what) + ": " + ZSTD_getErrorName(result));
}

[[noreturn]] void tooLarge(std::size_t maxBytes) {
    throw Error("compressed data would unpack to more than the " + std::to_string(maxBytes) +
                " bytes allowed here");
}

}  // namespace

struct CompressingStream::Implementation {
    std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context{ZSTD_createCCtx(),
                                                                    ZSTD_freeCCtx};
    Sink sink;
    std::vector<std::byte> out = std::vector<std::byte>(ZSTD_CStreamOutSize());
    bool finished = false;

    void pass(std::span<const std::byte> bytes, ZSTD_EndDirective how) {
        if (finished) throw Error("a compressed stream was written to after its end");
        ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
        while (true) {
            ZSTD_outBuffer buffer{out.data(), out.size(), 0};
            const auto left = ZSTD_compressStream2(context.get(), &buffer, &in, how);
            require(left, "data cannot be compressed");
            if (buffer.pos > 0) sink(std::span(out).first(buffer.pos));
            if (how == ZSTD_e_continue ? in.pos == in.size : left == 0) return;
        }
    }
};

CompressingStream::CompressingStream(Sink sink, int level)
    : implementation_(std::make_unique<Implementation>()) {
    if (level < lowestLevel || level > highestLevel)
        throw Error("a compression level of " + std::to_string(level) + " is outside of " +
                    std::to_string(lowestLevel) + " to " + std::to_string(highestLevel));
    auto& self = *implementation_;
    if (self.context == nullptr) throw Error("data cannot be compressed: out of memory");
    self.sink = std::move(sink);
    ZSTD_CCtx_setParameter(self.context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(self.context.get(), ZSTD_c_checksumFlag, 1);
}

CompressingStream::~CompressingStream() = default;

void CompressingStream::write(std::span<const std::byte> bytes) {
    implementation_->pass(bytes, ZSTD_e_continue);
}

void CompressingStream::flush() {
    implementation_->pass({}, ZSTD_e_flush);
}

void CompressingStream::finish() {
    if (implementation_->finished) return;
    implementation_->pass({}, ZSTD_e_end);
    implementation_->finished = true;
}

struct DecompressingStream::Implementation {
    std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context{ZSTD_createDCtx(),
                                                                    ZSTD_freeDCtx};
    Source source;
    std::vector<std::byte> in = std::vector<std::byte>(ZSTD_DStreamInSize());
    ZSTD_inBuffer input{in.data(), 0, 0};
    std::size_t left = 0;
    std::size_t maxBytes = 0;
    bool ended = false;

    void refill() {
        input.size = std::min(source(in), in.size());
        input.pos = 0;
    }

    /// The frame is over: nothing may follow, and nothing may have come beyond the limit.
    void end() {
        ended = true;
        if (input.pos == input.size) refill();
        if (input.size != input.pos) throw Error("compressed data goes on after its end");
    }

    void step(ZSTD_outBuffer& out) {
        if (input.pos == input.size) {
            refill();
            if (input.size == 0) throw Error("compressed data is cut short");
        }
        const auto result = ZSTD_decompressStream(context.get(), &out, &input);
        require(result, "compressed data is damaged");
        if (result == 0) end();
    }

    /// At the limit: one byte more is one too many, but the end of the frame may still come.
    void requireEnd() {
        while (!ended) {
            std::byte extra{};
            ZSTD_outBuffer out{&extra, 1, 0};
            step(out);
            if (out.pos != 0) tooLarge(maxBytes);
        }
    }
};

DecompressingStream::DecompressingStream(Source source, std::size_t maxBytes)
    : implementation_(std::make_unique<Implementation>()) {
    auto& self = *implementation_;
    if (self.context == nullptr) throw Error("data cannot be decompressed: out of memory");
    self.source = std::move(source);
    self.left = maxBytes;
    self.maxBytes = maxBytes;
    ZSTD_DCtx_setParameter(self.context.get(), ZSTD_d_windowLogMax, windowLog);
}

DecompressingStream::~DecompressingStream() = default;

std::size_t DecompressingStream::read(std::span<std::byte> out) {
    auto& self = *implementation_;
    const std::size_t wanted = std::min(out.size(), self.left);
    ZSTD_outBuffer buffer{out.data(), wanted, 0};
    while (!self.ended && buffer.pos < wanted) self.step(buffer);
    self.left -= buffer.pos;
    if (self.left == 0) self.requireEnd();
    return buffer.pos;
}

std::vector<std::byte> compress(std::span<const std::byte> bytes, int level) {
    std::vector<std::byte> out;
    CompressingStream stream(
        [&](std::span<const std::byte> part) { out.insert(out.end(), part.begin(), part.end()); },
        level);
    stream.write(bytes);
    stream.finish();
    return out;
}

std::vector<std::byte> decompress(std::span<const std::byte> bytes, std::size_t maxBytes) {
    DecompressingStream stream(
        [&](std::span<std::byte> in) {
            const auto length = std::min(in.size(), bytes.size());
            std::copy_n(bytes.begin(), length, in.begin());
            bytes = bytes.subspan(length);
            return length;
        },
        maxBytes);
    std::vector<std::byte> out;
    std::vector<std::byte> piece(64 * 1024);
    while (const auto got = stream.read(piece))
        out.insert(out.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
    return out;
}

}  // namespace atlax
