#include <librsvg/rsvg.h>
#include <libxml/xmlerror.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <cmath>
#include <memory>
#include <string>

namespace atlax {

namespace {

constexpr std::size_t mostSvgBytes = 4u << 20;

template <auto release>
struct Release {
    template <class T>
    void operator()(T* object) const {
        release(object);
    }
};
using Drawing = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Pen = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using Problem = std::unique_ptr<GError, Release<g_error_free>>;

[[noreturn]] void refuseSvg(const std::string& name, const std::string& reason) {
    throw Error(name + ": " + reason);
}

[[noreturn]] void refuseSvg(const std::string& name, const std::string& what,
                            const Problem& problem) {
    refuseSvg(name, what + (problem ? std::string(": ") + problem->message : std::string()));
}

void ignoreMessage(void*, const char*, ...) {}

/// The XML reader below librsvg writes some complaints to standard error by itself, although the
/// reason of the refusal says as much. Of this thread, and only while it lives.
class QuietXml {
public:
    QuietXml() { xmlSetGenericErrorFunc(nullptr, ignoreMessage); }
    ~QuietXml() { xmlSetGenericErrorFunc(context_, before_); }
    QuietXml(const QuietXml&) = delete;
    QuietXml& operator=(const QuietXml&) = delete;

private:
    xmlGenericErrorFunc before_ = xmlGenericError;
    void* context_ = xmlGenericErrorContext;
};

/// Nothing that the drawing refers to is loaded: it was given no place of its own, from which other
/// files could be reached.
Drawing read(std::span<const std::byte> bytes, const std::string& name) {
    const QuietXml quiet;
    GError* error = nullptr;
    Drawing drawing(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(bytes.data()),
                                              bytes.size(), &error));
    const Problem problem(error);
    if (drawing == nullptr) refuseSvg(name, "is not an SVG drawing", problem);
    return drawing;
}

struct Extent {
    double width = 1;
    double height = 1;
};

/// Only the ratio counts: the drawing's own size, or that of its viewBox, or a square.
Extent extentOf(RsvgHandle* drawing) {
    Extent extent;
    if (!rsvg_handle_get_intrinsic_size_in_pixels(drawing, &extent.width, &extent.height)) {
        gboolean hasBox = FALSE;
        RsvgRectangle box{};
        rsvg_handle_get_intrinsic_dimensions(drawing, nullptr, nullptr, nullptr, nullptr, &hasBox,
                                             &box);
        extent = hasBox ? Extent{box.width, box.height} : Extent{};
    }
    const auto usable = [](double side) { return std::isfinite(side) && side > 0; };
    return usable(extent.width) && usable(extent.height) ? extent : Extent{};
}

PixelSize fitted(const Extent& extent, PixelSize into) {
    const double scale = std::min(into.width / extent.width, into.height / extent.height);
    const auto side = [&](double length, int most) {
        return static_cast<int>(std::clamp(std::round(length * scale), 1.0, double(most)));
    };
    return {side(extent.width, into.width), side(extent.height, into.height)};
}

Surface paint(RsvgHandle* drawing, PixelSize size, const std::string& name) {
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.width, size.height));
    const Pen pen(cairo_create(surface.get()));
    const RsvgRectangle all{0, 0, static_cast<double>(size.width),
                            static_cast<double>(size.height)};
    GError* error = nullptr;
    const bool drawn = rsvg_handle_render_document(drawing, pen.get(), &all, &error) != 0;
    const Problem problem(error);
    if (!drawn) refuseSvg(name, "cannot be drawn", problem);
    cairo_surface_flush(surface.get());
    if (const auto status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
        refuseSvg(name, std::string("cannot be drawn: ") + cairo_status_to_string(status));
    return surface;
}

/// From premultiplied words of Cairo to bytes with straight alpha.
Image toImage(cairo_surface_t* surface, PixelSize size) {
    Image image(size);
    const unsigned char* rows = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < size.height; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(rows + std::ptrdiff_t{y} * stride);
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t word = row[x];
            const std::uint32_t alpha = word >> 24;
            const auto straight = [&](std::uint32_t part) {
                if (alpha == 0) return std::uint8_t{0};
                return static_cast<std::uint8_t>(std::min(255u, (part * 255 + alpha / 2) / alpha));
            };
            image.setPixel(x, y,
                           {straight(word >> 16 & 255), straight(word >> 8 & 255),
                            straight(word & 255), static_cast<std::uint8_t>(alpha)});
        }
    }
    return image;
}

}  // namespace

Image loadSvg(const std::filesystem::path& file, PixelSize size) {
    return decodeSvg(readBytes(file, mostSvgBytes), size, file.string());
}

Image decodeSvg(std::span<const std::byte> bytes, PixelSize size, const std::string& name) {
    if (bytes.size() > mostSvgBytes) refuseSvg(name, "is larger than 4 MiB");
    if (size.width < 1 || size.height < 1 || size.width > Image::maxSide ||
        size.height > Image::maxSide)
        refuseSvg(name,
                  "was asked for at a size outside of 1 to " + std::to_string(Image::maxSide));
    const Drawing drawing = read(bytes, name);
    const PixelSize pixels = fitted(extentOf(drawing.get()), size);
    return toImage(paint(drawing.get(), pixels, name).get(), pixels);
}

}  // namespace atlax
