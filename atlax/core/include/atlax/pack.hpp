#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

/// What a pack may ask of its reader. Sizes in bytes.
struct PackLimits {
    std::uint64_t packBytes = std::uint64_t{1} << 31;   ///< the pack itself
    std::uint64_t totalBytes = std::uint64_t{1} << 30;  ///< all of its files together, unpacked
    std::uint64_t fileBytes = std::uint64_t{1} << 28;   ///< one of its files, unpacked
    std::size_t entries = 20'000;                       ///< files and folders
};

/// One file of a pack.
struct PackEntry {
    std::string name;              ///< relative, with '/', without ".." or "."
    std::uint64_t size = 0;        ///< unpacked, bytes
    std::uint64_t packedSize = 0;  ///< in the pack, bytes
    std::uint64_t offset = 0;      ///< of the packed bytes in the pack
    std::uint32_t crc = 0;         ///< CRC-32 of the unpacked bytes
    bool deflated = false;         ///< else stored as it is
};

/// A compressed pack: a zip file of the plainest kind, read without trust.
///
/// Whoever holds a Pack holds one that was checked: every name stays below the pack's root, no
/// entry is a link or encrypted, no two entries share a name or bytes, the two descriptions that a
/// zip file has of each entry agree, and everything is within the limits. What an entry unpacks to
/// is compared with its declared size and checksum when it is read, or for all at once by verify().
///
/// Refused are also features that no pack needs and that readers understand differently: zip64,
/// several volumes, comments, data descriptors, bytes before the first entry, methods other than
/// "stored" and "deflate".
///
/// Owns the open file (or the bytes) and reads from it at explicit offsets, so a const Pack may be
/// read by several threads at once. A cheap value: copies share the file. Memory is used for the
/// list of entries and for what is being read. Errors are atlax::Error with the pack's name and the
/// reason.
class Pack {
public:
    /// Where the bytes come from; implementations are safe to read from several threads.
    class Source {
    public:
        virtual ~Source() = default;
        virtual std::uint64_t size() const = 0;
        /// Fills `out` from `offset`; false when not all of it could be read.
        virtual bool read(std::uint64_t offset, std::span<std::byte> out) const = 0;
    };

    /// Throws Error when the file cannot be opened or is refused. Nothing is unpacked yet.
    static Pack open(const std::filesystem::path& file, const PackLimits& limits = {});
    /// The same for a pack in memory; `name` is for messages.
    static Pack fromBytes(std::vector<std::byte> bytes, std::string name,
                          const PackLimits& limits = {});

    /// Sorted by name. Folders are not listed: they follow from the names. Valid as long as the
    /// pack.
    std::span<const PackEntry> entries() const { return entries_; }
    /// Null when there is no such file.
    const PackEntry* find(std::string_view name) const;

    /// Unpacks one file of at most `maxBytes`. Throws Error when there is no such file, when it is
    /// larger, or when it does not unpack to what the pack says of it.
    std::vector<std::byte> read(std::string_view name, std::size_t maxBytes) const;

    /// Unpacks every file once, in pieces of bounded size, and throws Error at the first that is
    /// not what the pack says. Takes time in proportion to the unpacked size.
    void verify() const;

    const std::string& name() const { return name_; }
    const std::shared_ptr<const Source>& source() const { return source_; }

private:
    Pack(std::shared_ptr<const Source> source, std::string name, const PackLimits& limits);

    std::shared_ptr<const Source> source_;
    std::string name_;
    std::vector<PackEntry> entries_;
};

/// Whether a name may stand in a pack or be looked for in mounted files: UTF-8, relative, at most
/// 255 bytes, parts separated by single '/', none of them "." or "..", without ':', '\\' and
/// control characters. Any thread.
bool isPlainName(std::string_view name);

/// Makes a pack of every regular file below `folder`, sorted by name and with a fixed date, so that
/// the same files give the same bytes. The pack is written beside `file` and renamed, and is read
/// back and verified before. Throws Error for a symbolic link or another thing that is no plain
/// file, for names that a pack cannot hold, and for what exceeds the limits; `file` is then as
/// before. Returns the number of files packed. One thread.
std::size_t makePack(const std::filesystem::path& folder, const std::filesystem::path& file,
                     const PackLimits& limits = {});

/// Unpacks everything below `folder`, which is made. The pack is verified first, so a bad one
/// writes nothing; files that exist already are replaced, each atomically, but nothing is written
/// through a symbolic link that stands below `folder`. Throws Error. Returns the number of files
/// written. One thread.
std::size_t unpack(const Pack& pack, const std::filesystem::path& folder);

}  // namespace atlax
