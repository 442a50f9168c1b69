// A window of SDL2 that shows a world, in some hundred lines. World::draw calls a visitor, which
// draws capsules as thick lines and discs as many-sided polygons. The mouse picks things up, the
// space bar drops a crate. The world keeps its own rate and is drawn between two ticks, whatever
// the screen's.
#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>
#include <vector>

using namespace sulfur;

constexpr int width = 960, height = 480;
constexpr float scale = 90;  // pixels per metre

SDL_FPoint toScreen(Point p) {
    return {0.5f * width + scale * float(p.x()), height - 60 - scale * float(p.y())};
}
Point mouse() {
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    return {(x - 0.5 * width) / double(scale), (height - 60 - y) / double(scale)};
}

class Painter final : public DebugDraw {
public:
    explicit Painter(SDL_Renderer* renderer) : renderer_(renderer) {}

    void body(const Body& b) override {
        const bool fixed = b.kind == BodyKind::fixed;
        colour_ = fixed ? SDL_Color{77, 85, 96, 255} : SDL_Color{47, 98, 160, 255};
        if (b.asleep) colour_ = {140, 165, 195, 255};
    }
    void capsule(const Capsule& c) override {
        const SDL_FPoint a = toScreen(c.a), b = toScreen(c.b);
        const float r = scale * float(c.radius), length = std::hypot(b.x - a.x, b.y - a.y);
        const float x = r * (b.y - a.y) / length, y = r * (a.x - b.x) / length;
        round(c.a, r);
        round(c.b, r);
        fill({{a.x + x, a.y + y}, {b.x + x, b.y + y}, {b.x - x, b.y - y}, {a.x - x, a.y - y}});
    }
    void disc(const Disc& d) override { round(d.centre, scale * float(d.radius)); }
    void grab(const Grab& g) override {
        const SDL_FPoint a = toScreen(g.info.point), b = toScreen(g.info.target);
        SDL_SetRenderDrawColor(renderer_, 184, 69, 45, 255);
        SDL_RenderDrawLineF(renderer_, a.x, a.y, b.x, b.y);
    }

private:
    void round(Point centre, float radius) {
        const SDL_FPoint c = toScreen(centre);
        std::vector<SDL_FPoint> rim;
        for (float angle = 0; angle < 6.28f; angle += 0.2618f)
            rim.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
        fill(rim);
    }
    void fill(const std::vector<SDL_FPoint>& corners) {
        std::vector<SDL_Vertex> fan;
        for (std::size_t i = 2; i < corners.size(); ++i)
            for (const SDL_FPoint& corner : {corners[0], corners[i - 1], corners[i]})
                fan.push_back({corner, colour_, {0, 0}});
        SDL_RenderGeometry(renderer_, nullptr, fan.data(), int(fan.size()), nullptr, 0);
    }

    SDL_Renderer* renderer_;
    SDL_Color colour_ = {};
};

/// Writes what is on the screen to a file. Returns whether there is more than background.
bool save(SDL_Renderer* renderer, const char* file) {
    SDL_Surface* picture =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888);
    SDL_RenderReadPixels(renderer, nullptr, picture->format->format, picture->pixels,
                         picture->pitch);
    const auto* pixels = static_cast<const Uint32*>(picture->pixels);
    const auto background = std::count(pixels, pixels + width * height, 0xfffbfaf6);
    return SDL_SaveBMP(picture, file) == 0 && background > 0 &&
           background < width * height * 95 / 100;
}

/// With the name of a file it shows two seconds of the world and leaves a picture (BMP) of the
/// last.
int main(int argc, char** argv) {
    SDL_Init(SDL_INIT_VIDEO);
    SDL_Window* window = SDL_CreateWindow("Sulfur", 0, 0, width, height, 0);
    SDL_Renderer* renderer = SDL_CreateRenderer(window, -1, 0);
    if (renderer == nullptr) return std::fprintf(stderr, "no window: %s\n", SDL_GetError()), 1;

    World world;
    world.add(shapes::ground({.points = {{-5, 5}, {-5, 0}, {5, 0}, {5, 5}}}));
    const Blueprint crate = shapes::box({.size = {0.9, 0.45}, .radius = 0.04});
    const Blueprint ball = shapes::ball({.radius = 0.2});
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 8; ++i)
            world.add((row + i) % 3 == 0 ? ball : crate,
                      {.position = {1.2 * i - 4.1, 0.7 + row}, .angle = 0.1 * (8 * row + i)});
    Painter painter(renderer);
    GrabId hand;
    double clock = 0;  // s, of the world
    for (bool running = true, good = true;; SDL_Delay(argc > 1 ? 0 : 16)) {
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
            if (event.type == SDL_QUIT) running = false;
            if (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_SPACE)
                world.add(crate, {.position = {0, 5}});
            const auto near = world.nearestParticle(mouse(), 0.5);
            if (event.type == SDL_MOUSEBUTTONDOWN && near &&
                world.kind(world.info(*near).body) == BodyKind::dynamic)
                hand = world.grab(*near, mouse());
            if (event.type == SDL_MOUSEBUTTONUP && world.contains(hand)) world.release(hand);
        }
        if (world.contains(hand)) world.setTarget(hand, mouse());
        clock += 1 / 60.;
        while (world.time() < clock) world.step();

        SDL_SetRenderDrawColor(renderer, 251, 250, 246, 255);
        SDL_RenderClear(renderer);
        const double ahead = (world.time() - clock) / double(world.tickDuration());  // ticks
        world.draw(painter, {.alpha = std::clamp(1 - ahead, 0.0, 1.0)});
        if (argc > 1 && clock > 2) good = save(renderer, argv[1]), running = false;
        SDL_RenderPresent(renderer);
        if (!running) return SDL_Quit(), good ? 0 : 1;
    }
}
