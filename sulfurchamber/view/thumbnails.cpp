#include "thumbnails.hpp"

#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <chrono>
#include <cstdio>
#include <vector>

#include "palette.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;

constexpr float thumbnailMargin = 1.12f;
constexpr double smallestPictured = 0.6;   // metres
constexpr std::size_t mostCached = 600;    // files
constexpr std::uint64_t pictureStyle = 1;  // another number makes all pictures anew

std::uint64_t mixedIn(std::uint64_t hash, std::uint64_t value) {
    for (int i = 0; i < 8; ++i) hash = (hash ^ ((value >> (8 * i)) & 0xffu)) * 1099511628211ull;
    return hash;
}

// Of a file that is there; 0 otherwise.
std::uint64_t stampOf(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (error) return 0;
    const auto size = fs::file_size(file, error);
    if (error) return 0;
    std::uint64_t hash = mixedIn(14695981039346656037ull,
                                 static_cast<std::uint64_t>(time.time_since_epoch().count()));
    const bool isLight = palette::deep == palette::light.deep;
    return mixedIn(mixedIn(hash, size), pictureStyle + (isLight ? 1u << 16 : 0u)) | 1u;
}

void removeOldest(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".png")
            files.emplace_back(entry.last_write_time(error), entry.path());
    if (files.size() <= mostCached) return;
    std::sort(files.begin(), files.end());
    files.resize(files.size() - mostCached);
    for (const auto& [time, file] : files) fs::remove(file, error);
}

// All bodies but wide grounds, which would make the others small.
Bounds shownBounds(const sulfur::World& world) {
    constexpr double wide = 15;  // metres
    std::optional<Bounds> all;
    for (const sulfur::BodyId body : world.bodies()) {
        const auto bounds = world.bounds(body);
        if (bounds.high.x() - bounds.low.x() > wide) continue;
        if (!all) all = Bounds{bounds.low, bounds.high};
        all->include(bounds.low);
        all->include(bounds.high);
    }
    return all ? *all : interestingBounds(world).value_or(Bounds{{-3, 0}, {3, 4}});
}

}  // namespace

atlax::Image drawThumbnail(atlax::Canvas& canvas, const Workbench& bench, SkinTextures* textures,
                           atlax::PixelSize size) {
    const atlax::RenderTarget target = canvas.createTarget(size);
    const Bounds bounds = shownBounds(bench.document().world());
    const auto extent = [](double length) {
        return static_cast<float>(std::max(smallestPictured, length)) * thumbnailMargin;
    };
    const float zoom = std::min(static_cast<float>(size.width) / extent(bounds.size().x()),
                                static_cast<float>(size.height) / extent(bounds.size().y()));
    canvas.pushTarget(target);
    canvas.gradientRect({{0, 0}, size.toVec()}, palette::above, palette::deep);
    canvas.setCamera({atlax::Vec2(bounds.centre()), zoom});
    ViewOptions options;
    options.grid = options.rulers = false;
    ScenePainter painter;
    painter.setTextures(textures);
    painter.paint(canvas, bench, options, 1);
    canvas.popTarget();
    return canvas.read(target);
}

/// What a thread brings: a picture of the cache, or a scene to be drawn, or neither.
struct Thumbnails::Read {
    std::string file;
    std::uint64_t stamp = 0;
    atlax::Image picture;
    std::unique_ptr<Workbench> bench;
};

Thumbnails::Thumbnails(fs::path cacheFolder, SkinTextures* textures, atlax::PixelSize size)
    : folder_(std::move(cacheFolder)), textures_(textures), size_(size) {
    removeOldest(folder_);
}

Thumbnails::~Thumbnails() {
    if (reading_.valid()) reading_.wait();
}

fs::path Thumbnails::cacheFile(const fs::path& file, std::uint64_t stamp) const {
    std::uint64_t hash = stamp;
    for (const char c : file.string()) hash = mixedIn(hash, static_cast<unsigned char>(c));
    hash = mixedIn(hash, static_cast<std::uint64_t>(size_.width) << 32 |
                             static_cast<std::uint64_t>(size_.height));
    std::array<char, 24> name{};
    std::snprintf(name.data(), name.size(), "%016llx.png", static_cast<unsigned long long>(hash));
    return folder_ / name.data();
}

const atlax::Image* Thumbnails::of(const fs::path& file) {
    const std::string name = file.string();
    const auto known = known_.find(name);
    const std::uint64_t stamp = stampOf(file);
    if (known != known_.end() && known->second.stamp == stamp)
        return known->second.picture.empty() ? nullptr : &known->second.picture;
    if (stamp != 0 && std::find(due_.begin(), due_.end(), name) == due_.end()) due_.push_back(name);
    return known != known_.end() && !known->second.picture.empty() ? &known->second.picture
                                                                   : nullptr;
}

void Thumbnails::startNext() {
    while (!due_.empty() && !reading_.valid()) {
        const std::string name = due_.front();
        due_.pop_front();
        const std::uint64_t stamp = stampOf(name);
        const auto known = known_.find(name);
        if (stamp == 0 || (known != known_.end() && known->second.stamp == stamp)) continue;
        reading_ = std::async(std::launch::async, [name, stamp, cached = cacheFile(name, stamp)] {
            auto read = std::make_unique<Read>();
            read->file = name;
            read->stamp = stamp;
            try {
                std::error_code error;
                if (fs::exists(cached, error)) {
                    read->picture = atlax::loadImage(cached);
                    return read;
                }
            } catch (const std::exception&) {
                // A picture that was damaged is drawn again.
            }
            try {
                read->bench = std::make_unique<Workbench>();
                read->bench->document().open(name);
            } catch (const std::exception&) {
                read->bench.reset();
            }
            return read;
        });
    }
}

void Thumbnails::finish(atlax::Canvas& canvas) {
    const std::unique_ptr<Read> read = reading_.get();
    if (read->bench && read->picture.empty()) {
        read->picture = drawThumbnail(canvas, *read->bench, textures_, size_);
        ++drawn_;
        try {
            atlax::savePng(read->picture, cacheFile(read->file, read->stamp));
        } catch (const atlax::Error&) {
            // It is drawn again the next time.
        }
    }
    known_[read->file] = {read->stamp, std::move(read->picture)};
    ++revision_;
}

void Thumbnails::work(atlax::Canvas& canvas) {
    if (canvas.contextLost()) return;
    if (reading_.valid() && reading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        finish(canvas);
    startNext();
}

}  // namespace sulfurchamber
