#include "pack_io.hpp"

#include <physfs.h>

#include <algorithm>
#include <atlax/error.hpp>

namespace atlax {

namespace {

/// One position in a pack. PhysicsFS duplicates it for every file that it opens.
struct Reader {
    std::shared_ptr<const Pack::Source> source;
    std::uint64_t at = 0;
};

PHYSFS_Io* makeIo(std::shared_ptr<const Pack::Source> source, std::uint64_t at);

Reader& readerOf(PHYSFS_Io* io) {
    return *static_cast<Reader*>(io->opaque);
}

PHYSFS_sint64 readIo(PHYSFS_Io* io, void* buffer, PHYSFS_uint64 length) {
    Reader& reader = readerOf(io);
    const std::uint64_t left = reader.source->size() - reader.at;
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(length, left));
    if (!reader.source->read(reader.at, std::span(static_cast<std::byte*>(buffer), wanted))) {
        PHYSFS_setErrorCode(PHYSFS_ERR_IO);
        return -1;
    }
    reader.at += wanted;
    return static_cast<PHYSFS_sint64>(wanted);
}

PHYSFS_sint64 refuseWrite(PHYSFS_Io*, const void*, PHYSFS_uint64) {
    PHYSFS_setErrorCode(PHYSFS_ERR_READ_ONLY);
    return -1;
}

int seekIo(PHYSFS_Io* io, PHYSFS_uint64 offset) {
    Reader& reader = readerOf(io);
    if (offset > reader.source->size()) {
        PHYSFS_setErrorCode(PHYSFS_ERR_PAST_EOF);
        return 0;
    }
    reader.at = offset;
    return 1;
}

PHYSFS_sint64 tellIo(PHYSFS_Io* io) {
    return static_cast<PHYSFS_sint64>(readerOf(io).at);
}

PHYSFS_sint64 lengthIo(PHYSFS_Io* io) {
    return static_cast<PHYSFS_sint64>(readerOf(io).source->size());
}

PHYSFS_Io* duplicateIo(PHYSFS_Io* io) {
    try {
        return makeIo(readerOf(io).source, 0);
    } catch (const std::bad_alloc&) {
        PHYSFS_setErrorCode(PHYSFS_ERR_OUT_OF_MEMORY);
        return nullptr;
    }
}

int flushIo(PHYSFS_Io*) {
    return 1;
}

void destroyIo(PHYSFS_Io* io) {
    delete static_cast<Reader*>(io->opaque);
    delete io;
}

PHYSFS_Io* makeIo(std::shared_ptr<const Pack::Source> source, std::uint64_t at) {
    auto reader = std::make_unique<Reader>(Reader{std::move(source), at});
    auto io = std::make_unique<PHYSFS_Io>();
    io->version = 0;
    io->opaque = reader.release();
    io->read = readIo;
    io->write = refuseWrite;
    io->seek = seekIo;
    io->tell = tellIo;
    io->length = lengthIo;
    io->duplicate = duplicateIo;
    io->flush = flushIo;
    io->destroy = destroyIo;
    return io.release();
}

}  // namespace

void mountPackIo(const Pack& pack, const std::string& mounted, const std::string& place) {
    PHYSFS_Io* io = makeIo(pack.source(), 0);
    if (PHYSFS_mountIo(io, mounted.c_str(), place.c_str(), 0) != 0) return;
    const char* why = PHYSFS_getErrorByCode(PHYSFS_getLastErrorCode());
    destroyIo(io);
    throw Error(pack.name() + ": cannot be mounted: " + (why != nullptr ? why : "unknown reason"));
}

}  // namespace atlax
