#include <physfs.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/file_system.hpp>
#include <atlax/files.hpp>
#include <atomic>

#include "pack_io.hpp"
#include "utf8.hpp"

namespace atlax {

namespace fs = std::filesystem;

namespace {

std::atomic<bool> inUse{false};

std::string reason() {
    const char* text = PHYSFS_getErrorByCode(PHYSFS_getLastErrorCode());
    return text != nullptr ? text : "unknown reason";
}

std::string requirePlain(std::string_view name) {
    if (!isPlainName(name))
        throw Error(
            "\"" + printable(name) +
            "\" is not the name of a file: it must be relative, with '/', and without \"..\"");
    return std::string(name);
}

/// PhysicsFS would try other kinds of archives with what it does not know.
void keepOnlyZip() {
    std::vector<std::string> others;
    for (const PHYSFS_ArchiveInfo** i = PHYSFS_supportedArchiveTypes(); *i != nullptr; ++i)
        if (std::string_view((*i)->extension) != "ZIP") others.emplace_back((*i)->extension);
    for (const std::string& other : others) PHYSFS_deregisterArchiver(other.c_str());
}

class File {
public:
    explicit File(const std::string& name) : name_(name), file_(PHYSFS_openRead(name.c_str())) {
        if (file_ == nullptr) fail(reason());
    }
    ~File() { PHYSFS_close(file_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    template <class Buffer>
    Buffer read(std::size_t maxBytes) {
        const auto length = PHYSFS_fileLength(file_);
        if (length < 0) fail("its size is unknown");
        const auto size = static_cast<std::uint64_t>(length);
        if (size > maxBytes)
            fail("is larger than the " + std::to_string(maxBytes) + " bytes allowed here");
        Buffer out;
        out.resize(static_cast<std::size_t>(size));
        const auto got = PHYSFS_readBytes(file_, out.data(), size);
        if (got < 0 || static_cast<std::uint64_t>(got) != size) fail(reason());
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error("\"" + name_ + "\" cannot be read: " + why);
    }

    const std::string& name_;
    PHYSFS_File* file_;
};

template <class Buffer>
Buffer readMounted(std::string_view name, std::size_t maxBytes) {
    const std::string plain = requirePlain(name);
    PHYSFS_Stat info{};
    if (PHYSFS_stat(plain.c_str(), &info) == 0)
        throw Error("\"" + plain + "\" cannot be read: " + reason());
    if (info.filetype != PHYSFS_FILETYPE_REGULAR)
        throw Error("\"" + plain + "\" cannot be read: it is no plain file");
    return File(plain).read<Buffer>(maxBytes);
}

}  // namespace

FileSystem::FileSystem(const fs::path& writeFolder)
    : writeFolder_(fs::absolute(writeFolder).lexically_normal()) {
    if (inUse.exchange(true))
        throw Error("a second FileSystem cannot be made while the first one exists");
    if (PHYSFS_init(nullptr) == 0) {
        inUse = false;
        throw Error("files cannot be mounted: " + reason());
    }
    keepOnlyZip();
    PHYSFS_permitSymbolicLinks(0);
    mountWriteFolder();
}

FileSystem::~FileSystem() {
    PHYSFS_deinit();
    inUse = false;
}

/// It may not exist before the first write.
void FileSystem::mountWriteFolder() {
    std::error_code ignored;
    if (writeFolderMounted_ || !fs::is_directory(writeFolder_, ignored)) return;
    writeFolderMounted_ = PHYSFS_mount(writeFolder_.c_str(), "", 0) != 0;
}

/// PhysicsFS knows only "first" and "last".
void FileSystem::putWriteFolderFirst() {
    if (writeFolderMounted_) PHYSFS_unmount(writeFolder_.c_str());
    writeFolderMounted_ = false;
    mountWriteFolder();
}

void FileSystem::mountFolder(const fs::path& folder, std::string_view place) {
    const std::string where = place.empty() ? "" : requirePlain(place);
    const fs::path full = fs::absolute(folder).lexically_normal();
    std::error_code ignored;
    if (!fs::is_directory(full, ignored))
        throw Error(folder.string() + ": cannot be mounted: it is no folder");
    if (std::find(mounted_.begin(), mounted_.end(), full) != mounted_.end()) return;
    if (PHYSFS_mount(full.c_str(), where.c_str(), 0) == 0)
        throw Error(folder.string() + ": cannot be mounted: " + reason());
    mounted_.insert(mounted_.begin(), full);
    putWriteFolderFirst();
}

void FileSystem::mountPack(const fs::path& file, std::string_view place, const PackLimits& limits) {
    const std::string where = place.empty() ? "" : requirePlain(place);
    const fs::path full = fs::absolute(file).lexically_normal();
    if (std::find(mounted_.begin(), mounted_.end(), full) != mounted_.end()) return;
    const Pack pack = Pack::open(full, limits);
    pack.verify();
    mountPackIo(pack, full.string(), where);
    mounted_.insert(mounted_.begin(), full);
    putWriteFolderFirst();
}

void FileSystem::unmount(const fs::path& path) {
    const fs::path full = fs::absolute(path).lexically_normal();
    const auto found = std::find(mounted_.begin(), mounted_.end(), full);
    if (found == mounted_.end()) throw Error(path.string() + ": is not mounted");
    if (PHYSFS_unmount(full.c_str()) == 0)
        throw Error(path.string() + ": cannot be unmounted: " + reason());
    mounted_.erase(found);
}

bool FileSystem::exists(std::string_view name) const {
    if (!isPlainName(name)) return false;
    PHYSFS_Stat info{};
    return PHYSFS_stat(std::string(name).c_str(), &info) != 0 &&
           info.filetype == PHYSFS_FILETYPE_REGULAR;
}

std::vector<std::string> FileSystem::list(std::string_view folder) const {
    const std::string where = folder.empty() ? "" : requirePlain(folder);
    std::vector<std::string> out;
    const auto add = [](void* data, const char*, const char* name) {
        static_cast<std::vector<std::string>*>(data)->emplace_back(name);
        return PHYSFS_ENUM_OK;
    };
    PHYSFS_enumerate(where.c_str(), add, &out);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<std::byte> FileSystem::read(std::string_view name, std::size_t maxBytes) const {
    return readMounted<std::vector<std::byte>>(name, maxBytes);
}

std::string FileSystem::readText(std::string_view name, std::size_t maxBytes) const {
    return readMounted<std::string>(name, maxBytes);
}

void FileSystem::write(std::string_view name, std::span<const std::byte> bytes) {
    const fs::path plain = requirePlain(name);
    fs::path way = writeFolder_;
    for (const fs::path& part : plain) {
        way /= part;
        std::error_code ignored;
        if (fs::is_symlink(fs::symlink_status(way, ignored)))
            throw Error(way.string() + ": is a symbolic link, and nothing is written through it");
    }
    writeFileAtomic(way, bytes);
    mountWriteFolder();
}

void FileSystem::write(std::string_view name, std::string_view text) {
    write(name, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace atlax
