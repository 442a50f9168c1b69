#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace atlax {

/// Compresses to one zstd frame with a checksum, for replays and snapshots. `level` is 1 (fast) to
/// 19 (small); 3 suits most. Any thread. Throws Error for a level outside of that.
std::vector<std::byte> compress(std::span<const std::byte> bytes, int level = 3);

/// The opposite. Throws Error when the result would be larger than `maxBytes`, and when the input
/// is not exactly one whole, undamaged frame. Memory grows with what really comes out, never with
/// what the input claims. Any thread.
std::vector<std::byte> decompress(std::span<const std::byte> bytes, std::size_t maxBytes);

/// Compresses what is written to it bit by bit. Owns its buffers; one thread at a time.
class CompressingStream {
public:
    /// Takes compressed bytes; valid only during the call. What it throws passes through.
    using Sink = std::function<void(std::span<const std::byte>)>;

    /// Throws Error for a level outside of 1..19.
    explicit CompressingStream(Sink sink, int level = 3);
    ~CompressingStream();
    CompressingStream(const CompressingStream&) = delete;
    CompressingStream& operator=(const CompressingStream&) = delete;

    /// Throws Error after finish().
    void write(std::span<const std::byte> bytes);
    /// Hands over everything that was written so far, so that it can be read even if the program
    /// ends here. Costs some compression.
    void flush();
    /// Ends the frame. Without it the reader sees a stream that is cut short. Called again it does
    /// nothing; never called by the destructor, which could not report a failure.
    void finish();

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Decompresses bit by bit. Owns its buffers, of which the largest has 8 MiB whatever the input
/// says; one thread at a time.
class DecompressingStream {
public:
    /// Fills the span with compressed bytes and returns how many; 0 at the end. What it throws
    /// passes through.
    using Source = std::function<std::size_t(std::span<std::byte>)>;

    /// More than `maxBytes` in all is refused.
    DecompressingStream(Source source, std::size_t maxBytes);
    ~DecompressingStream();
    DecompressingStream(const DecompressingStream&) = delete;
    DecompressingStream& operator=(const DecompressingStream&) = delete;

    /// Fills as much of `out` as there is and returns its length; less than asked for only at the
    /// end. Throws Error when the input is damaged, cut short, continues after its end or exceeds
    /// the limit; what was read before is then sound except for the checksum, which stands at the
    /// end.
    std::size_t read(std::span<std::byte> out);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
