#include "shelf.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <map>
#include <stdexcept>
#include <system_error>

namespace sulfurchamber {
namespace {

constexpr std::size_t shortBytes = 512;  // what costs less in memory than as an entry of the disk

// Not all file systems have files that never had a name.
int openNameless(const std::filesystem::path& folder) {
    const int nameless = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (nameless >= 0) return nameless;
    std::string name = (folder / "sulfurchamber-history-XXXXXX").string();
    const int file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
    return file;
}

}  // namespace

// The file, and which of its parts are free.
class Shelf::File {
public:
    explicit File(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~File() {
        if (handle_ >= 0) ::close(handle_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    /// Where they lie now, or nothing when the disk refuses.
    bool write(std::string_view bytes, std::size_t& at) {
        if (!isOpen()) return false;
        at = take(bytes.size());
        for (std::size_t done = 0; done < bytes.size();) {
            const auto written = ::pwrite(handle_, bytes.data() + done, bytes.size() - done,
                                          static_cast<off_t>(at + done));
            if (written <= 0) {
                release(at, bytes.size());
                return false;
            }
            done += static_cast<std::size_t>(written);
        }
        return true;
    }

    std::string read(std::size_t at, std::size_t size) const {
        std::string bytes(size, '\0');
        for (std::size_t done = 0; done < size;) {
            const auto got =
                ::pread(handle_, bytes.data() + done, size - done, static_cast<off_t>(at + done));
            if (got <= 0)
                throw std::runtime_error("the disk does not give back a step of the history");
            done += static_cast<std::size_t>(got);
        }
        return bytes;
    }

    void release(std::size_t at, std::size_t size) {
        used_ -= size;
        auto next = free_.emplace(at, size).first;
        if (next != free_.begin()) {
            const auto before = std::prev(next);
            if (before->first + before->second == at) {
                before->second += size;
                free_.erase(next);
                next = before;
            }
        }
        const auto after = std::next(next);
        if (after != free_.end() && next->first + next->second == after->first) {
            next->second += after->second;
            free_.erase(after);
        }
        if (next->first + next->second != end_) return;
        end_ = next->first;
        free_.erase(next);
        // A file that cannot be shortened is only longer than it need be.
        [[maybe_unused]] const int ignored = ::ftruncate(handle_, static_cast<off_t>(end_));
    }

    std::size_t used() const { return used_; }

private:
    bool isOpen() {
        if (handle_ >= 0 || refused_) return handle_ >= 0;
        if (!folder_.empty()) {
            std::error_code error;
            std::filesystem::create_directories(folder_, error);
            handle_ = openNameless(folder_);
        }
        std::error_code error;
        const auto usual = std::filesystem::temp_directory_path(error);
        if (handle_ < 0 && !error) handle_ = openNameless(usual);
        refused_ = handle_ < 0;
        return !refused_;
    }

    std::size_t take(std::size_t size) {
        used_ += size;
        for (auto hole = free_.begin(); hole != free_.end(); ++hole) {
            const auto [at, room] = *hole;
            if (room < size) continue;
            free_.erase(hole);
            if (room > size) free_.emplace(at + size, room - size);
            return at;
        }
        end_ += size;
        return end_ - size;
    }

    std::filesystem::path folder_;
    std::map<std::size_t, std::size_t> free_;  // holes: where, how large
    std::size_t end_ = 0;
    std::size_t used_ = 0;
    int handle_ = -1;
    bool refused_ = false;
};

struct Shelf::Place::Region {
    std::shared_ptr<File> file;  // null: the bytes are here
    std::size_t at = 0;
    std::size_t size = 0;
    std::string bytes;

    Region() = default;
    Region(const Region&) = delete;
    Region& operator=(const Region&) = delete;
    ~Region() {
        if (file) file->release(at, size);
    }
};

Shelf::Shelf(std::filesystem::path folder) : file_(std::make_shared<File>(std::move(folder))) {}

Shelf::Place Shelf::put(std::string bytes) {
    auto region = std::make_shared<Place::Region>();
    region->size = bytes.size();
    if (bytes.size() > shortBytes && file_->write(bytes, region->at))
        region->file = file_;
    else
        region->bytes = std::move(bytes);
    Place place;
    place.region_ = std::move(region);
    return place;
}

std::size_t Shelf::used() const {
    return file_->used();
}

std::string Shelf::Place::read() const {
    if (!region_) return {};
    return region_->file ? region_->file->read(region_->at, region_->size) : region_->bytes;
}

std::size_t Shelf::Place::size() const {
    return region_ ? region_->size : 0;
}

}  // namespace sulfurchamber
