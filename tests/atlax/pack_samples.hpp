// Packs made by hand, header by header, so that a test can tell any lie.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// One entry as both headers describe it; what is not set is true.
struct PackedFile {
    std::string name;
    std::string content;
    bool deflated = false;
    std::uint32_t mode = 0100644;
    std::uint16_t flags = 0;
    std::int64_t claimedSize = -1;       ///< in both headers
    std::int64_t localClaimedSize = -1;  ///< in the local header only
    std::int64_t claimedCrc = -1;
    std::int64_t offset = -1;  ///< of the local header, as the directory says
    std::uint16_t method = 0xffff;
};

class PackBytes {
public:
    void u16(std::uint32_t v) { text_ += {static_cast<char>(v), static_cast<char>(v >> 8)}; }
    void u32(std::uint32_t v) {
        u16(v & 0xffff);
        u16(v >> 16);
    }
    void text(const std::string& t) { text_ += t; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
    const std::string& str() const { return text_; }

private:
    std::string text_;
};

inline std::string deflated(const std::string& content) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
    std::string out(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(out.size() - stream.avail_out);
    deflateEnd(&stream);
    return out;
}

/// The layout is that of PKWARE's APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16.
inline std::string packBytes(const std::vector<PackedFile>& files,
                             const std::string& comment = "") {
    PackBytes body, directory;
    for (const PackedFile& file : files) {
        const std::string packed = file.deflated ? deflated(file.content) : file.content;
        const auto trueCrc = crc32(0, reinterpret_cast<const Bytef*>(file.content.data()),
                                   static_cast<uInt>(file.content.size()));
        const auto crc = static_cast<std::uint32_t>(
            file.claimedCrc >= 0 ? static_cast<std::uint64_t>(file.claimedCrc) : trueCrc);
        const auto size = static_cast<std::uint32_t>(
            file.claimedSize >= 0 ? static_cast<std::size_t>(file.claimedSize)
                                  : file.content.size());
        const auto localSize = static_cast<std::uint32_t>(
            file.localClaimedSize >= 0 ? static_cast<std::size_t>(file.localClaimedSize) : size);
        const std::uint32_t offset =
            file.offset >= 0 ? static_cast<std::uint32_t>(file.offset) : body.size();
        const auto shared = [&](PackBytes& to, std::uint32_t unpackedSize) {
            to.u16(20);
            to.u16(file.flags);
            to.u16(file.method != 0xffff ? file.method : file.deflated ? 8 : 0);
            to.u32(0x00210000);
            to.u32(crc);
            to.u32(static_cast<std::uint32_t>(packed.size()));
            to.u32(unpackedSize);
            to.u16(static_cast<std::uint32_t>(file.name.size()));
            to.u16(0);
        };
        body.u32(0x04034b50);
        shared(body, localSize);
        body.text(file.name);
        body.text(packed);
        directory.u32(0x02014b50);
        directory.u16(0x0314);
        shared(directory, size);
        directory.u16(0);
        directory.u16(0);
        directory.u16(0);
        directory.u32(file.mode << 16);
        directory.u32(offset);
        directory.text(file.name);
    }
    PackBytes end;
    end.u32(0x06054b50);
    end.u32(0);
    end.u16(static_cast<std::uint32_t>(files.size()));
    end.u16(static_cast<std::uint32_t>(files.size()));
    end.u32(directory.size());
    end.u32(body.size());
    end.u16(static_cast<std::uint32_t>(comment.size()));
    end.text(comment);
    return body.str() + directory.str() + end.str();
}

inline std::vector<std::byte> asBytes(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    return {bytes.begin(), bytes.end()};
}

inline std::string asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
