// Questions about PNG files, for scripts: `colourful FILE`, `light FILE`, `same A B`, `differ A B`.
// Exit 0 means yes.
#include <algorithm>
#include <atlax/image.hpp>
#include <cstdio>
#include <exception>
#include <set>
#include <string>
#include <vector>

namespace {

std::vector<std::uint8_t> bytesOf(const atlax::Image& image) {
    const auto bytes = image.bytes();
    return {bytes.begin(), bytes.end()};
}

// Neither blank nor one flat colour: many colours, and light pixels on a dark ground.
bool colourful(const atlax::Image& image) {
    std::set<std::array<std::uint8_t, 4>> colours;
    int light = 0;
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const auto pixel = image.pixel(x, y);
            const int sum = pixel[0] + pixel[1] + pixel[2];
            light += sum > 360 ? 1 : 0;
            dark += sum < 150 ? 1 : 0;
            if (colours.size() < 1000) colours.insert(pixel);
        }
    const int all = image.width() * image.height();
    std::printf("%zu colours, %d light and %d dark of %d pixels\n", colours.size(), light, dark,
                all);
    return colours.size() > 60 && light > all / 400 && dark > all / 10;
}

// Most of it is nearly white.
bool light(const atlax::Image& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const auto pixel = image.pixel(x, y);
            count += pixel[0] + pixel[1] + pixel[2] > 600 ? 1 : 0;
        }
    return count > image.width() * image.height() / 2;
}

bool ask(const std::vector<std::string>& words) {
    if (words.size() == 2 && words[0] == "light") return light(atlax::loadImage(words[1]));
    if (words.size() == 2 && words[0] == "colourful") return colourful(atlax::loadImage(words[1]));
    if (words.size() != 3)
        throw std::runtime_error("usage: colourful FILE | light FILE | same A B | differ A B");
    const bool same = bytesOf(atlax::loadImage(words[1])) == bytesOf(atlax::loadImage(words[2]));
    return words[0] == "same" ? same : !same;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return ask({argv + 1, argv + argc}) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
