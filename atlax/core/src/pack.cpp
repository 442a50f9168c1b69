#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/pack.hpp>
#include <cerrno>
#include <cstring>
#include <functional>
#include <set>

#include "utf8.hpp"

namespace atlax {

namespace {

// Layout and numbers from PKWARE's APPNOTE.TXT 6.3.10, sections 4.3.7, 4.3.12 and 4.3.16.
constexpr std::uint32_t localSignature = 0x04034b50;
constexpr std::uint32_t centralSignature = 0x02014b50;
constexpr std::uint32_t endSignature = 0x06054b50;
constexpr std::size_t localSize = 30;
constexpr std::size_t centralSize = 46;
constexpr std::size_t endSize = 22;
constexpr std::uint16_t utf8Flag = 1u << 11;
constexpr std::uint16_t knownFlags = utf8Flag | 0x6;  // and the two bits of deflate's effort
constexpr std::uint16_t stored = 0;
constexpr std::uint16_t deflate = 8;

constexpr std::size_t longestName = 255;
constexpr std::size_t pieceSize = 64 * 1024;

class MemorySource : public Pack::Source {
public:
    explicit MemorySource(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
    std::uint64_t size() const override { return bytes_.size(); }
    bool read(std::uint64_t offset, std::span<std::byte> out) const override {
        if (offset > bytes_.size() || out.size() > bytes_.size() - offset) return false;
        const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(offset);
        std::copy_n(from, out.size(), out.begin());
        return true;
    }

private:
    std::vector<std::byte> bytes_;
};

/// The file stays open, so what was checked is what is read, whatever its name comes to mean.
class FileSource : public Pack::Source {
public:
    explicit FileSource(const std::filesystem::path& file)
        : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        if (number_ < 0) throw Error(file.string() + ": cannot be opened: " + std::strerror(errno));
        struct stat info {};
        if (::fstat(number_, &info) != 0 || !S_ISREG(info.st_mode)) {
            ::close(number_);
            throw Error(file.string() + ": is not a regular file");
        }
        size_ = static_cast<std::uint64_t>(info.st_size);
    }
    ~FileSource() override { ::close(number_); }
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;

    std::uint64_t size() const override { return size_; }
    bool read(std::uint64_t offset, std::span<std::byte> out) const override {
        while (!out.empty()) {
            const auto got = ::pread(number_, out.data(), out.size(), static_cast<off_t>(offset));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            offset += static_cast<std::uint64_t>(got);
            out = out.subspan(static_cast<std::size_t>(got));
        }
        return true;
    }

private:
    int number_;
    std::uint64_t size_ = 0;
};

/// Little-endian numbers of a header whose length is known.
class Header {
public:
    explicit Header(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::uint16_t u16(std::size_t at) const {
        return static_cast<std::uint16_t>(byte(at) | byte(at + 1) << 8);
    }
    std::uint32_t u32(std::size_t at) const {
        return static_cast<std::uint32_t>(u16(at)) | static_cast<std::uint32_t>(u16(at + 2)) << 16;
    }
    std::string text(std::size_t at, std::size_t length) const {
        std::string out(length, '\0');
        if (length > 0) std::memcpy(out.data(), bytes_.data() + at, length);
        return out;
    }

private:
    unsigned byte(std::size_t at) const { return std::to_integer<unsigned>(bytes_[at]); }
    std::span<const std::byte> bytes_;
};

struct End {
    std::size_t entries = 0;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
};

struct Listed {
    PackEntry entry;
    std::uint16_t version = 0;  ///< needed to unpack it
    std::uint16_t flags = 0;
    std::uint64_t localOffset = 0;
    bool folder = false;
};

class Checker {
public:
    Checker(const Pack::Source& source, const std::string& name, const PackLimits& limits)
        : source_(source), name_(name), limits_(limits) {}

    std::vector<PackEntry> entries() {
        const End end = readEnd();
        std::vector<std::byte> central(end.size);
        if (!source_.read(end.offset, central)) refuse("it cannot be read");
        std::size_t at = 0;
        for (std::size_t i = 0; i < end.entries; ++i) at += readCentral(central, at);
        if (at != central.size()) refuse("its directory has bytes that belong to no entry");
        for (Listed& listed : listed_) checkLocal(listed, end.offset);
        checkOverlap();
        checkNames();
        std::vector<PackEntry> out;
        for (Listed& listed : listed_)
            if (!listed.folder) out.push_back(std::move(listed.entry));
        std::sort(out.begin(), out.end(),
                  [](const PackEntry& a, const PackEntry& b) { return a.name < b.name; });
        return out;
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const {
        throw Error(name_ + ": this pack is refused: " + reason);
    }
    [[noreturn]] void refuse(const std::string& entry, const std::string& reason) const {
        refuse("its entry \"" + printable(entry) + "\" " + reason);
    }

    End readEnd() const {
        const std::uint64_t size = source_.size();
        if (size > limits_.packBytes)
            refuse("it is larger than the " + std::to_string(limits_.packBytes) +
                   " bytes allowed here");
        std::array<std::byte, endSize> bytes{};
        if (size < endSize || !source_.read(size - endSize, bytes)) refuse("it is no zip file");
        const Header h(bytes);
        if (h.u32(0) != endSignature || h.u16(20) != 0)
            refuse("it is no zip file, is cut short, or has a comment");
        if (h.u16(4) != 0 || h.u16(6) != 0 || h.u16(8) != h.u16(10))
            refuse("it is one of several volumes");
        const End end{h.u16(10), h.u32(16), h.u32(12)};
        if (end.entries > limits_.entries)
            refuse("it has " + std::to_string(end.entries) + " entries, of which " +
                   std::to_string(limits_.entries) + " are allowed");
        if (end.offset + end.size != size - endSize)
            refuse("its directory is not where it says, or it is of the zip64 kind");
        return end;
    }

    std::size_t readCentral(std::span<const std::byte> central, std::size_t at) {
        if (central.size() - at < centralSize) refuse("its directory is cut short");
        const Header h(central.subspan(at));
        if (h.u32(0) != centralSignature) refuse("its directory is damaged");
        const std::size_t nameLength = h.u16(28);
        const std::size_t length = centralSize + nameLength + h.u16(30) + h.u16(32);
        if (central.size() - at < length) refuse("its directory is cut short");
        Listed listed;
        PackEntry& entry = listed.entry;
        entry.name = h.text(centralSize, nameLength);
        listed.version = h.u16(6);
        listed.flags = h.u16(8);
        entry.deflated = h.u16(10) == deflate;
        entry.crc = h.u32(16);
        entry.packedSize = h.u32(20);
        entry.size = h.u32(24);
        listed.localOffset = h.u32(42);
        listed.folder = entry.name.ends_with('/');
        checkKind(listed, h.u16(10), h.u32(38));
        if (h.u16(34) != 0) refuse(entry.name, "is in another volume");
        checkSizes(entry, listed.folder);
        listed_.push_back(std::move(listed));
        return length;
    }

    void checkKind(const Listed& listed, std::uint16_t method, std::uint32_t attributes) const {
        const std::string& name = listed.entry.name;
        const auto plain = listed.folder ? name.substr(0, name.size() - 1) : name;
        if (!isPlainName(plain))
            refuse(name, "has a name that leads out of the pack or is no name");
        const bool ascii = std::all_of(name.begin(), name.end(),
                                       [](char c) { return static_cast<unsigned char>(c) < 128; });
        if (!ascii && (listed.flags & utf8Flag) == 0)
            refuse(name, "has a name that is not marked as UTF-8");
        if ((listed.flags & 1u) != 0) refuse(name, "is encrypted");
        if ((listed.flags & ~knownFlags) != 0)
            refuse(name, "uses a feature of zip files that packs may not use");
        if (method != stored && method != deflate)
            refuse(name, "is compressed by a method other than deflate");
        // The upper half of the attributes is the mode of Unix, where it was packed on one.
        const std::uint32_t type = (attributes >> 16) & S_IFMT;
        if (type == S_IFLNK) refuse(name, "is a symbolic link");
        if (type != 0 && type != S_IFREG && type != S_IFDIR)
            refuse(name, "is neither a file nor a folder");
        if (type != 0 && (type == S_IFDIR) != listed.folder)
            refuse(name, "is called a folder in one place and a file in another");
    }

    void checkSizes(const PackEntry& entry, bool folder) {
        if (folder && (entry.size != 0 || entry.packedSize != 0 || entry.deflated))
            refuse(entry.name, "is a folder with content");
        if (!entry.deflated && entry.size != entry.packedSize)
            refuse(entry.name, "lies about its size: it is stored, but its two sizes differ");
        if (entry.size > limits_.fileBytes)
            refuse(entry.name, "would unpack to " + std::to_string(entry.size) +
                                   " bytes, of which " + std::to_string(limits_.fileBytes) +
                                   " are allowed");
        total_ += entry.size;
        if (total_ > limits_.totalBytes)
            refuse("it would unpack to more than the " + std::to_string(limits_.totalBytes) +
                   " bytes allowed here");
    }

    /// Readers differ in which of the two headers they believe, so both must say the same.
    void checkLocal(Listed& listed, std::uint64_t directory) const {
        PackEntry& entry = listed.entry;
        std::vector<std::byte> bytes(localSize + entry.name.size());
        if (listed.localOffset + bytes.size() > directory ||
            !source_.read(listed.localOffset, bytes))
            refuse(entry.name, "is not where the directory says");
        const Header h(bytes);
        if (h.u32(0) != localSignature || h.u16(26) != entry.name.size() ||
            h.text(localSize, entry.name.size()) != entry.name)
            refuse(entry.name, "is not where the directory says");
        if (h.u16(4) != listed.version || h.u16(6) != listed.flags ||
            h.u16(8) != (entry.deflated ? deflate : stored) || h.u32(14) != entry.crc ||
            h.u32(18) != entry.packedSize || h.u32(22) != entry.size)
            refuse(entry.name, "lies about its size or kind: its two headers differ");
        entry.offset = listed.localOffset + bytes.size() + h.u16(28);
        if (entry.offset + entry.packedSize > directory)
            refuse(entry.name, "lies about its size: it reaches beyond the end");
    }

    /// Entries that share bytes unpack to far more than the pack holds.
    void checkOverlap() {
        std::sort(listed_.begin(), listed_.end(),
                  [](const Listed& a, const Listed& b) { return a.localOffset < b.localOffset; });
        std::uint64_t end = 0;
        for (const Listed& listed : listed_) {
            if (listed.localOffset < end) refuse(listed.entry.name, "overlaps another entry");
            end = listed.entry.offset + listed.entry.packedSize;
        }
        if (!listed_.empty() && listed_.front().localOffset != 0)
            refuse("it has bytes before its first entry");
    }

    void checkNames() const {
        std::set<std::string, std::less<>> files, folders;
        for (const Listed& listed : listed_)
            if (!(listed.folder ? folders : files).insert(listed.entry.name).second)
                refuse(listed.entry.name, "stands there twice");
        for (const Listed& listed : listed_) {
            const std::string& name = listed.entry.name;
            for (auto at = name.find('/'); at != std::string::npos; at = name.find('/', at + 1))
                if (files.contains(std::string_view(name).substr(0, at)))
                    refuse(name, "lies below something that is a file");
        }
    }

    const Pack::Source& source_;
    const std::string& name_;
    const PackLimits& limits_;
    std::vector<Listed> listed_;
    std::uint64_t total_ = 0;
};

/// Unpacks an entry piece by piece and holds it to what the pack says of it.
class Unpacker {
public:
    using Sink = std::function<void(std::span<const std::byte>)>;

    Unpacker(const Pack& pack, const PackEntry& entry, Sink sink)
        : pack_(pack), entry_(entry), sink_(std::move(sink)) {}

    void run() {
        entry_.deflated ? inflateAll() : copyAll();
        if (done_ != entry_.size)
            refuse("lies about its size: it unpacks to fewer bytes than it says");
        if (crc_ != entry_.crc) refuse("is damaged: its checksum is wrong");
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const {
        throw Error(pack_.name() + ": \"" + entry_.name + "\" " + reason);
    }

    std::span<const std::byte> nextPiece(std::vector<std::byte>& buffer) {
        const auto length = std::min<std::uint64_t>(entry_.packedSize - taken_, buffer.size());
        const auto piece = std::span(buffer).first(static_cast<std::size_t>(length));
        if (!pack_.source()->read(entry_.offset + taken_, piece)) refuse("cannot be read");
        taken_ += length;
        return piece;
    }

    void deliver(std::span<const std::byte> bytes) {
        if (bytes.size() > entry_.size - done_)
            refuse("lies about its size: it unpacks to more bytes than it says");
        done_ += bytes.size();
        crc_ = static_cast<std::uint32_t>(::crc32(
            crc_, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
        sink_(bytes);
    }

    void copyAll() {
        std::vector<std::byte> in(pieceSize);
        while (taken_ < entry_.packedSize) deliver(nextPiece(in));
    }

    void inflateAll() {
        z_stream stream{};
        if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) refuse("cannot be unpacked");
        const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, ::inflateEnd);
        std::vector<std::byte> in(pieceSize), out(pieceSize);
        int state = Z_OK;
        while (state != Z_STREAM_END) {
            if (stream.avail_in == 0) {
                const auto piece = nextPiece(in);
                if (piece.empty()) refuse("is damaged: its compressed bytes end too early");
                stream.next_in = reinterpret_cast<Bytef*>(in.data());
                stream.avail_in = static_cast<uInt>(piece.size());
            }
            stream.next_out = reinterpret_cast<Bytef*>(out.data());
            stream.avail_out = static_cast<uInt>(out.size());
            state = ::inflate(&stream, Z_NO_FLUSH);
            if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
                refuse("is damaged: its compressed bytes cannot be read");
            deliver(std::span(out).first(out.size() - stream.avail_out));
        }
        if (stream.avail_in != 0 || taken_ != entry_.packedSize)
            refuse("lies about its size: it has compressed bytes beyond its end");
    }

    const Pack& pack_;
    const PackEntry& entry_;
    Sink sink_;
    std::uint64_t taken_ = 0;
    std::uint64_t done_ = 0;
    std::uint32_t crc_ = 0;
};

}  // namespace

bool isPlainName(std::string_view name) {
    if (name.empty() || name.size() > longestName || !isUtf8(name)) return false;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        if (u < 32 || u == 127 || c == '\\' || c == ':') return false;
    }
    while (true) {
        const auto end = name.find('/');
        const auto part = name.substr(0, end);
        if (part.empty() || part == "." || part == "..") return false;
        if (end == std::string_view::npos) return true;
        name.remove_prefix(end + 1);
    }
}

Pack::Pack(std::shared_ptr<const Source> source, std::string name, const PackLimits& limits)
    : source_(std::move(source)), name_(std::move(name)) {
    entries_ = Checker(*source_, name_, limits).entries();
}

Pack Pack::open(const std::filesystem::path& file, const PackLimits& limits) {
    return Pack(std::make_shared<FileSource>(file), file.string(), limits);
}

Pack Pack::fromBytes(std::vector<std::byte> bytes, std::string name, const PackLimits& limits) {
    return Pack(std::make_shared<MemorySource>(std::move(bytes)), std::move(name), limits);
}

const PackEntry* Pack::find(std::string_view name) const {
    const auto found =
        std::lower_bound(entries_.begin(), entries_.end(), name,
                         [](const PackEntry& e, std::string_view n) { return e.name < n; });
    return found != entries_.end() && found->name == name ? &*found : nullptr;
}

std::vector<std::byte> Pack::read(std::string_view name, std::size_t maxBytes) const {
    const PackEntry* entry = find(name);
    if (entry == nullptr)
        throw Error(name_ + ": there is no file \"" + printable(name) + "\" in this pack");
    if (entry->size > maxBytes)
        throw Error(name_ + ": \"" + entry->name + "\" is larger than the " +
                    std::to_string(maxBytes) + " bytes allowed here");
    std::vector<std::byte> out;
    // Grows with what really comes, so that a lie costs no memory.
    Unpacker(*this, *entry, [&](std::span<const std::byte> bytes) {
        out.insert(out.end(), bytes.begin(), bytes.end());
    }).run();
    return out;
}

void Pack::verify() const {
    for (const PackEntry& entry : entries_)
        Unpacker(*this, entry, [](std::span<const std::byte>) {}).run();
}

}  // namespace atlax
