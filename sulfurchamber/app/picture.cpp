#include "picture.hpp"

#include <sys/stat.h>

#include <atlax/backend.hpp>
#include <filesystem>
#include <optional>

#include "../view/palette.hpp"
#include "../view/scene_view.hpp"
#include "program_files.hpp"

namespace sulfurchamber {
namespace {

// The view, ended when the time has come.
class PictureApp final : public atlax::Application {
public:
    PictureApp(Workbench& bench, const Options& options)
        : bench_(bench), options_(options), view_(bench) {
        if (options.theme == "light") palette::choose(palette::light);
        view_.setSkins(skinStore());
    }

    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        view_.start(platform);
        view_.pauseAt(options_.at);
    }
    void event(const atlax::Event& event) override { view_.event(event); }
    void tick() override { view_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        if (!bench_.document().playing()) {
            if (asked_)
                platform_->quit();
            else
                platform_->requestScreenshot(options_.picture);
            asked_ = true;
        }
        view_.draw(canvas, alpha);
    }
    void stop() override { view_.stop(); }

private:
    Workbench& bench_;
    const Options& options_;
    SceneView view_;
    atlax::Platform* platform_ = nullptr;
    bool asked_ = false;
};

/// A picture that is written is another file than the one that was there.
std::optional<ino_t> fileNumber(const std::filesystem::path& file) {
    struct stat info {};
    if (::stat(file.c_str(), &info) != 0) return std::nullopt;
    return info.st_ino;
}

}  // namespace

int writePicture(Workbench& bench, const Options& options) {
    if (options.at > 0) bench.document().play();
    PictureApp app(bench, options);
    atlax::WindowOptions window;
    window.size = {options.width, options.height};
    window.tickRateHz = bench.document().world().settings().tickRate;
    const auto before = fileNumber(options.picture);
    const int code = atlax::runOffscreen(app, window);
    const auto after = fileNumber(options.picture);
    if (code == 0 && (!after || after == before)) return 1;  // the log says why
    return code;
}

}  // namespace sulfurchamber
