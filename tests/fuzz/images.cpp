// Whatever bytes are handed over as a picture, they are decoded or refused with atlax::Error, and
// what was decoded is as large as it says.
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

constexpr std::string_view drawing =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><defs><linearGradient id="a">
<stop offset="0" stop-color="red"/></linearGradient></defs><path d="M1 1L8 2Q3 4 5 8z" fill="url(#a)"
transform="rotate(9)"/><circle cx="4" cy="4" r="2" stroke="#00f" opacity=".5"/><text>x</text></svg>)svg";

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

// What fontconfig has read of the machine's fonts, for texts in drawings, it keeps to the end.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT: the sanitizer's name
    return "leak:libfontconfig";
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    static const std::vector<std::byte> png = sample();
    if (size < 8 && seed % 2 == 0 && png.size() <= most) {
        std::memcpy(data, png.data(), png.size());
        size = png.size();
    } else if (size < 8 && drawing.size() <= most) {
        std::memcpy(data, drawing.data(), drawing.size());
        size = drawing.size();
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
