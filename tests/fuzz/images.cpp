// Whatever bytes are handed over as a picture, they are decoded or refused with atlax::Error, and
// what was decoded is as large as it says.
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <cstdlib>
#include <cstring>

namespace {

// A PNG of 3 x 2 pixels, which mutations begin with; a checksum guards little of it.
std::vector<std::byte> sample() {
    atlax::Image image({3, 2});
    image.setPixel(1, 1, {200, 100, 50, 128});
    return atlax::encodePng(image);
}

void check(const atlax::Image& image) {
    const auto pixels =
        static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
    if (image.empty() || image.bytes().size() != pixels * 4) std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    static const std::vector<std::byte> png = sample();
    if (size < 8 && seed % 2 == 0 && png.size() <= most) {
        std::memcpy(data, png.data(), png.size());
        size = png.size();
    }
    return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    try {
        check(atlax::decodeImage(bytes, "fuzz"));
    } catch (const atlax::Error&) {
    }
    try {
        check(atlax::decodeSvg(bytes, {64, 64}, "fuzz"));
    } catch (const atlax::Error&) {
    }
    return 0;
}
