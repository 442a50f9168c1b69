// Bytes that lie on the disk until they are wanted again: what the history keeps for long.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace sulfurchamber {

/// A file without a name, which is gone with the program however that ends.
///
/// One thread. Where the disk refuses, the bytes stay in memory: nothing is lost.
class Shelf {
public:
    /// The file lies in `folder`, or in the folder for temporary files where that is not usable.
    /// It is opened when it is first needed.
    explicit Shelf(std::filesystem::path folder = {});

    /// A place on the shelf. Its room is used again when it is gone. It may outlive the shelf.
    class Place {
    public:
        Place() = default;
        /// What was put there. Throws std::runtime_error when the disk does not give it back.
        std::string read() const;
        std::size_t size() const;

    private:
        friend class Shelf;
        struct Region;
        std::shared_ptr<const Region> region_;
    };

    /// Puts bytes away. Short ones stay in memory.
    Place put(std::string bytes);
    /// Bytes of the file that are in use.
    std::size_t used() const;

private:
    class File;
    std::shared_ptr<File> file_;
};

}  // namespace sulfurchamber
