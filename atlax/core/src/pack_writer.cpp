#include <zip.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/pack.hpp>
#include <cstring>
#include <map>

#include "utf8.hpp"

namespace atlax {

namespace fs = std::filesystem;

namespace {

/// Names as they stand in the pack, in the order in which they are packed.
std::map<std::string, fs::path> filesBelow(const fs::path& folder, const PackLimits& limits) {
    std::error_code failed;
    fs::recursive_directory_iterator it(folder, failed);
    if (failed) throw Error(folder.string() + ": cannot be packed: " + failed.message());
    std::map<std::string, fs::path> out;
    for (; it != fs::recursive_directory_iterator(); it.increment(failed)) {
        const fs::path& file = it->path();
        const auto kind = it->symlink_status().type();
        if (kind == fs::file_type::directory) continue;
        if (kind != fs::file_type::regular)
            throw Error(file.string() + ": is a link or no plain file, which a pack cannot hold");
        const std::string name = file.lexically_relative(folder).generic_string();
        if (!isPlainName(name))
            throw Error(folder.string() + ": a pack cannot hold a file of the name \"" +
                        printable(name) + "\"");
        out.emplace(name, file);
        if (out.size() > limits.entries)
            throw Error(folder.string() + ": has more than the " + std::to_string(limits.entries) +
                        " files that a pack may hold");
    }
    if (failed) throw Error(folder.string() + ": cannot be packed: " + failed.message());
    return out;
}

/// An archive that is being made in memory; thrown away unless it was finished.
class Writer {
public:
    Writer() {
        zip_error_t error;
        zip_error_init(&error);
        target_ = zip_source_buffer_create(nullptr, 0, 0, &error);
        if (target_ == nullptr) throw Error("a pack cannot be made: out of memory");
        zip_source_keep(target_);
        archive_ = zip_open_from_source(target_, ZIP_TRUNCATE, &error);
        if (archive_ != nullptr) return;
        zip_source_free(target_);
        zip_source_free(target_);
        throw Error(std::string("a pack cannot be made: ") + zip_error_strerror(&error));
    }
    ~Writer() {
        if (archive_ != nullptr) zip_discard(archive_);
        zip_source_free(target_);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// `bytes` must live until finish().
    void add(const std::string& name, std::span<const std::byte> bytes) {
        zip_source_t* source = zip_source_buffer(archive_, bytes.data(), bytes.size(), 0);
        const auto index =
            source == nullptr ? -1 : zip_file_add(archive_, name.c_str(), source, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            zip_source_free(source);
            fail(name);
        }
        const auto at = static_cast<zip_uint64_t>(index);
        constexpr zip_uint16_t firstDay = (0 << 9) | (1 << 5) | 1;  // 1 January 1980, midnight
        constexpr zip_uint32_t plainFile = 0100644u << 16;
        if (zip_set_file_compression(archive_, at, ZIP_CM_DEFLATE, 9) != 0 ||
            zip_file_set_dostime(archive_, at, 0, firstDay, 0) != 0 ||
            zip_file_set_external_attributes(archive_, at, 0, ZIP_OPSYS_UNIX, plainFile) != 0)
            fail(name);
    }

    std::vector<std::byte> finish() {
        if (zip_close(archive_) != 0) fail("");
        archive_ = nullptr;
        zip_stat_t info;
        zip_stat_init(&info);
        if (zip_source_stat(target_, &info) != 0 || zip_source_open(target_) != 0)
            throw Error("the finished pack cannot be read back");
        std::vector<std::byte> out(info.size);
        const auto got = zip_source_read(target_, out.data(), out.size());
        zip_source_close(target_);
        if (got < 0 || static_cast<std::size_t>(got) != out.size())
            throw Error("the finished pack cannot be read back");
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& name) const {
        throw Error((name.empty() ? "the pack" : name) +
                    " cannot be packed: " + zip_error_strerror(zip_get_error(archive_)));
    }

    zip_source_t* target_ = nullptr;
    zip_t* archive_ = nullptr;
};

/// A link below the folder would lead what is unpacked out of it.
void requireNoLinks(const fs::path& folder, const std::string& name) {
    fs::path way = folder;
    for (const fs::path& part : fs::path(name)) {
        way /= part;
        std::error_code ignored;
        if (fs::is_symlink(fs::symlink_status(way, ignored)))
            throw Error(way.string() + ": is a symbolic link, and nothing is unpacked through it");
    }
}

}  // namespace

std::size_t makePack(const fs::path& folder, const fs::path& file, const PackLimits& limits) {
    const auto files = filesBelow(folder, limits);
    if (files.empty()) throw Error(folder.string() + ": holds no files that could be packed");
    std::vector<std::vector<std::byte>> contents;
    std::uint64_t total = 0;
    Writer writer;
    for (const auto& [name, path] : files) {
        contents.push_back(readBytes(path, limits.fileBytes));
        total += contents.back().size();
        if (total > limits.totalBytes)
            throw Error(folder.string() + ": holds more than the " +
                        std::to_string(limits.totalBytes) + " bytes that a pack may hold");
        writer.add(name, contents.back());
    }
    const std::vector<std::byte> bytes = writer.finish();
    Pack::fromBytes(bytes, file.string(), limits).verify();
    writeFileAtomic(file, bytes);
    return files.size();
}

std::size_t unpack(const Pack& pack, const fs::path& folder) {
    pack.verify();
    for (const PackEntry& entry : pack.entries()) requireNoLinks(folder, entry.name);
    for (const PackEntry& entry : pack.entries())
        writeFileAtomic(folder / entry.name, pack.read(entry.name, entry.size));
    return pack.entries().size();
}

}  // namespace atlax
