// Whatever a pack holds, it is refused with atlax::Error, or PhysicsFS sees the very files in it
// that were checked: no more, no fewer, and with the same bytes.
#include <physfs.h>

#include <atlax/error.hpp>
#include <atlax/pack.hpp>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <random>

#include "pack_io.hpp"
#include "pack_samples.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

constexpr std::size_t mostBytes = 1u << 20;

using Files = std::map<std::string, std::vector<std::byte>>;

void require(bool truth) {
    if (!truth) std::abort();
}

void collect(const std::string& folder, Files& out) {
    char** names = PHYSFS_enumerateFiles(folder.c_str());
    require(names != nullptr);
    for (char** name = names; *name != nullptr; ++name) {
        const std::string path = folder.empty() ? *name : folder + "/" + *name;
        PHYSFS_Stat info{};
        require(PHYSFS_stat(path.c_str(), &info) != 0);
        require(info.filetype == PHYSFS_FILETYPE_REGULAR ||
                info.filetype == PHYSFS_FILETYPE_DIRECTORY);
        if (info.filetype == PHYSFS_FILETYPE_DIRECTORY) {
            collect(path, out);
            continue;
        }
        require(info.filesize >= 0 && static_cast<std::size_t>(info.filesize) <= mostBytes);
        PHYSFS_File* file = PHYSFS_openRead(path.c_str());
        require(file != nullptr);
        std::vector<std::byte> bytes(static_cast<std::size_t>(info.filesize));
        require(PHYSFS_readBytes(file, bytes.data(), bytes.size()) ==
                static_cast<PHYSFS_sint64>(bytes.size()));
        PHYSFS_close(file);
        out.emplace(path, std::move(bytes));
    }
    PHYSFS_freeList(names);
}

/// Mounted as atlax::FileSystem mounts it.
Files seenByPhysicsFs(const atlax::Pack& pack) {
    require(PHYSFS_init(nullptr) != 0);
    Files out;
    atlax::mountPackIo(pack, "fuzz.zip", "");
    collect("", out);
    PHYSFS_deinit();
    return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    const std::vector<std::byte> bytes(begin, begin + size);
    std::optional<atlax::Pack> pack;
    try {
        pack = atlax::Pack::fromBytes(
            bytes, "fuzz", {.totalBytes = mostBytes, .fileBytes = mostBytes, .entries = 100});
        pack->verify();
    } catch (const atlax::Error&) {
        return 0;
    }
    // From here on an error is a finding.
    Files checked;
    for (const atlax::PackEntry& entry : pack->entries())
        checked.emplace(entry.name, pack->read(entry.name, mostBytes));
    require(seenByPhysicsFs(*pack) == checked);
    return 0;
}

/// Bytes alone would hardly ever become a zip file, so half of the inputs are made as one, with
/// lies in their headers.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned int seed) {
    std::minstd_rand random(seed);
    if (size > 0 && random() % 4 != 0) return LLVMFuzzerMutate(data, size, maxSize);
    static const std::vector<std::string> names{"a",    "b/c", "b/",  "b",    "../x", "d/../e",
                                                "/abs", "A",   "a/b", "\xc3", "a:b",  "\xc3\xa4"};
    std::vector<PackedFile> files(random() % 4 + 1);
    for (PackedFile& file : files) {
        file.name = names[random() % names.size()];
        if (!file.name.ends_with('/')) file.content = std::string(random() % 200, 'x');
        file.deflated = random() % 2 == 0;
        if (file.name.ends_with('/')) file.deflated = false;
        file.mode = file.name.ends_with('/') ? 040755 : random() % 8 == 0 ? 0120777 : 0100644;
        file.flags = random() % 4 == 0 ? 1u << 11 : 0;
        if (random() % 8 == 0) file.claimedSize = static_cast<std::int64_t>(random() % 300);
        if (random() % 8 == 0) file.localClaimedSize = static_cast<std::int64_t>(random() % 300);
        if (random() % 8 == 0) file.offset = static_cast<std::int64_t>(random() % 300);
    }
    const std::string made = packBytes(files);
    if (made.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, made.data(), made.size());
    return made.size();
}
