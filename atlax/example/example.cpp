#include "example.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "transcript.hpp"

using namespace atlax;

namespace {

const Color night = Color::hex(0x0B1026);
const Color dusk = Color::hex(0x27406B);
const Color amber = Color::hex(0xFFB347);
const Color ice = Color::hex(0x9FD8FF);

Image checkerboard() {
    constexpr int side = 64;
    Image image({side, side});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool light = (x / 8 + y / 8) % 2 == 0;
            image.setPixel(x, y, {255, 255, 255, static_cast<std::uint8_t>(light ? 255 : 64)});
        }
    return image;
}

}  // namespace

Example::Example(ExampleOptions options) : options_(std::move(options)) {
    if (options_.seconds) meter_.emplace(*options_.seconds);
}

void Example::say(const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

void Example::start(Platform& platform) {
    platform_ = &platform;
    font_ = Font::standard();
    makePictures();
    if (options_.load) load_.emplace();
    const Vec2 size = platform.size().toVec();
    say("started " + std::to_string(std::lround(size.x)) + " " +
        std::to_string(std::lround(size.y)) + " scale " +
        std::to_string(std::lround(platform.scaleFactor() * 100)) + " %");
}

void Example::makePictures() {
    checker_ = platform_->canvas().createTexture(checkerboard());
    if (options_.effects) post_.emplace(platform_->canvas());
}

bool Example::restoreGraphics() {
    makePictures();
    say("graphics restored");
    return true;
}

void Example::stop() {
    if (meter_) {
        say(meter_->report(platform_->clock()));
        const CanvasStatistics cost = platform_->canvas().statistics();
        say("a frame: " + std::to_string(cost.triangles) + " triangles in " +
            std::to_string(cost.drawCalls) + " draw calls");
    }
    // They belong to the canvas, which goes after this.
    post_.reset();
    say("stopped");
}

void Example::event(const Event& event) {
    if (const std::string line = describe(event); !line.empty()) say(line);
    if (const auto* text = std::get_if<TextEvent>(&event)) typed_ += text->utf8;
    if (const auto* wheel = std::get_if<WheelEvent>(&event)) turned_ += wheel->notches.y;
    const auto* key = std::get_if<KeyEvent>(&event);
    if (key == nullptr || key->repeat) return;
    if (key->down) command(key->key);
    // When the key is up, so that no picture shows it held.
    if (!key->down && key->key == Key::F12) takePicture();
}

void Example::command(Key key) {
    switch (key) {
        case Key::F1:
            chooseFile();
            break;
        case Key::F2:
            textInput_ = !textInput_;
            platform_->setTextInput(textInput_);
            break;
        case Key::F3:
            platform_->setClipboard(typed_);
            break;
        case Key::F4:
            pasted_ = platform_->clipboard();
            say("clipboard " + pasted_);
            break;
        case Key::F5:
            cursor_ = (cursor_ + 1) % cursorCount;
            platform_->setCursor(static_cast<Cursor>(cursor_));
            break;
        case Key::F6:
            cursorVisible_ = !cursorVisible_;
            platform_->setCursorVisible(cursorVisible_);
            break;
        default:
            commandWindow(key);
    }
}

void Example::commandWindow(Key key) {
    switch (key) {
        case Key::F7:
            platform_->setWindowSize({400, 300});
            break;
        case Key::F8:
            platform_->setWindowSize({640, 480});
            break;
        case Key::F9:
            platform_->setMinimised(true);
            break;
        case Key::F10:
            platform_->clock().setPaused(!platform_->clock().paused());
            break;
        case Key::F11:
            platform_->setFullscreen(!platform_->fullscreen());
            say(platform_->fullscreen() ? "fullscreen" : "windowed");
            break;
        default:
            break;
    }
}

void Example::takePicture() {
    platform_->requestScreenshot(options_.pictures /
                                 ("picture" + std::to_string(++pictures_) + ".png"));
}

void Example::chooseFile() {
    if (!platform_->hasFileDialogs()) {
        say("no file dialogs");
        return;
    }
    const auto file = platform_->chooseFile(
        {.title = "Choose a text", .folder = options_.pictures, .kinds = {{"Texts", {"txt"}}}});
    say(file ? "chose " + file->filename().string() : "chose nothing");
}

void Example::tick() {
    before_ = angle_;
    if (!options_.still) angle_ += platform_->clock().tickSeconds();
}

void Example::draw(Canvas& canvas, double alpha) {
    if (meter_ && meter_->frame(platform_->clock(), alpha)) platform_->quit();
    if (post_) post_->begin();
    drawScene(canvas, alpha);
    if (post_) post_->end(std::array<PostEffect, 2>{Bloom{}, Vignette{}});
    drawState(canvas);
}

// A landscape in metres, ten of them high, with one thing of each kind that a canvas draws.
void Example::drawScene(Canvas& canvas, double alpha) {
    canvas.gradientRect({{0, 0}, canvas.size().toVec()}, night, dusk);
    const Camera camera = Camera::withHeight({0, 4}, 10, canvas.size());
    canvas.setCamera(camera.parallax(0.3f));
    for (int i = -4; i <= 4; ++i) {
        const float x = static_cast<float>(i) * 3;
        const Vec2 mountain[] = {{x - 2.5f, 0}, {x + 2.5f, 0}, {x, 2.2f}};
        canvas.polygon(mountain, Color::hex(0x1B2B4B));
    }
    canvas.setCamera(camera);
    canvas.rect({{-20, -2}, {40, 2}}, Color::hex(0x141A2E));
    const float angle = static_cast<float>(before_ + (angle_ - before_) * alpha);
    const Vec2 hub{-3, 1.5f};
    canvas.circleOutline(hub, 1.5f, 0.15f, amber);
    for (int i = 0; i < 6; ++i) {
        const float a = angle + static_cast<float>(i) * 1.0471976f;
        canvas.line(hub, hub + Vec2{std::cos(a), std::sin(a)} * 1.4f, 0.08f, amber);
    }
    canvas.sprite(checker_, {1, 1.2f}, {2, 2}, {.angle = 0.3f + turned_ * 0.1f, .tint = ice});
    canvas.capsule({3, 0.4f}, {4.5f, 2}, 0.4f, Color::hex(0xE0605A));
    if (load_) load_->draw(canvas, checker_, angle);
    canvas.setBlend(Blend::Additive);
    canvas.glow({0, 6}, 2, amber.faded(0.7f));
    canvas.setBlend(Blend::Alpha);
}

void Example::drawState(Canvas& canvas) {
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const InputState& input = platform_->input();
    canvas.circleOutline(input.mouse / scale, 10, 2, colors::white);
    std::string text = "typed: " + typed_ + "\nclipboard: " + pasted_ +
                       "\ntext input: " + (textInput_ ? "on" : "off") +
                       "\ncursor: " + (cursorVisible_ ? std::to_string(cursor_) : "hidden") +
                       "\nheld:";
    for (int key = 1; key < keyCount; ++key)
        if (input.isDown(static_cast<Key>(key)))
            text += " " + std::string(keyName(static_cast<Key>(key)));
    canvas.text(*font_, text, {12, 12},
                {.size = 16, .color = colors::white, .alignY = AlignY::Top});
}
