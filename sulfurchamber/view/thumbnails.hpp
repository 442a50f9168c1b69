// Small pictures of scene files, drawn as the sandbox draws scenes, and kept between runs.
#pragma once

#include <atlax/canvas.hpp>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <string>

#include "../model/workbench.hpp"

namespace sulfurchamber {

class SkinTextures;

/// All that a scene shows, in a picture of this size. The canvas's context must be current.
atlax::Image drawThumbnail(atlax::Canvas& canvas, const Workbench& bench, SkinTextures* textures,
                           atlax::PixelSize size);

/// Pictures by file. They are made when somebody asks: a thread reads the scene, the next frame
/// draws it. A file that changes gets another picture. Main thread.
class Thumbnails {
public:
    /// The folder is made when a picture is written; what was written long ago is removed.
    Thumbnails(std::filesystem::path cacheFolder, SkinTextures* textures, atlax::PixelSize size);
    ~Thumbnails();

    atlax::PixelSize size() const { return size_; }
    /// Null as long as it is not there, and for a file that cannot be read.
    const atlax::Image* of(const std::filesystem::path& file);
    /// One piece of the work that is due, less than a frame; within a frame or with the context
    /// current.
    void work(atlax::Canvas& canvas);
    /// Whether pictures are still to come.
    bool working() const { return !due_.empty() || reading_.valid(); }
    /// Grows with each picture.
    std::uint64_t revision() const { return revision_; }
    /// How many were drawn, rather than read from the cache.
    std::size_t drawn() const { return drawn_; }

private:
    struct Read;
    struct Known {
        std::uint64_t stamp = 0;  ///< of the file when it was read
        atlax::Image picture;
    };
    std::filesystem::path cacheFile(const std::filesystem::path& file, std::uint64_t stamp) const;
    void finish(atlax::Canvas& canvas);
    void startNext();

    std::filesystem::path folder_;
    SkinTextures* textures_;
    atlax::PixelSize size_;
    std::map<std::string, Known> known_;
    std::deque<std::string> due_;
    std::future<std::unique_ptr<Read>> reading_;
    std::uint64_t revision_ = 0;
    std::size_t drawn_ = 0;
};

}  // namespace sulfurchamber
