#include <algorithm>
#include <atlax/error.hpp>
#include <cstring>

#include "canvas_impl.hpp"
#include "shader.hpp"

namespace atlax {

namespace {

void setFilter(const TextureOptions& options) {
    const GLint far = !options.smooth   ? GL_NEAREST
                      : options.mipmaps ? GL_LINEAR_MIPMAP_LINEAR
                                        : GL_LINEAR;
    const GLint wrap = options.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, far);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, options.smooth ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, std::clamp(options.mipmapLevels, 0, 14));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

void requireSize(PixelSize size) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    limit = std::min(limit, Image::maxSide);
    if (size.empty() || size.width > limit || size.height > limit)
        throw Error("a picture of " + std::to_string(size.width) + " x " +
                    std::to_string(size.height) + " pixels does not fit this graphics card (1 to " +
                    std::to_string(limit) + ")");
}

/// Restores the framebuffer that was bound, whatever happens in between.
class FramebufferGuard {
public:
    FramebufferGuard() { glGetIntegerv(GL_FRAMEBUFFER_BINDING, &previous_); }
    ~FramebufferGuard() { glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous_)); }
    FramebufferGuard(const FramebufferGuard&) = delete;
    FramebufferGuard& operator=(const FramebufferGuard&) = delete;

private:
    GLint previous_ = 0;
};

void flipRows(Image& image) {
    const auto stride = static_cast<std::size_t>(image.width()) * 4;
    const auto bytes = image.bytes();
    for (int top = 0, bottom = image.height() - 1; top < bottom; ++top, --bottom) {
        auto* a = bytes.data() + static_cast<std::size_t>(top) * stride;
        auto* b = bytes.data() + static_cast<std::size_t>(bottom) * stride;
        std::swap_ranges(a, a + stride, b);
    }
}

}  // namespace

std::vector<std::uint8_t> premultiplied(const Image& image) {
    std::vector<std::uint8_t> out(image.bytes().begin(), image.bytes().end());
    for (std::size_t i = 0; i + 3 < out.size(); i += 4) {
        const unsigned alpha = out[i + 3];
        for (std::size_t c = i; c < i + 3; ++c)
            out[c] = static_cast<std::uint8_t>((out[c] * alpha + 127) / 255);
    }
    return out;
}

void unpremultiply(Image& image) {
    const auto bytes = image.bytes();
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        const unsigned alpha = bytes[i + 3];
        if (alpha == 0 || alpha == 255) continue;
        for (std::size_t c = i; c < i + 3; ++c)
            bytes[c] =
                static_cast<std::uint8_t>(std::min(255u, (bytes[c] * 255u + alpha / 2) / alpha));
    }
}

GLuint detail::nameOf(const Texture& texture) {
    return texture.object_ ? texture.object_->name : 0;
}

PixelSize Texture::size() const {
    return object_ ? object_->size : PixelSize{};
}

PixelSize RenderTarget::size() const {
    return object_ ? object_->texture->size : PixelSize{};
}

Texture RenderTarget::texture() const {
    return object_ ? Texture(object_->texture) : Texture();
}

Texture Canvas::createTexture(const Image& image, TextureOptions options) {
    requireSize(image.size());
    const std::vector<std::uint8_t> pixels = premultiplied(image);
    GLuint name = 0;
    glGenTextures(1, &name);
    auto object =
        std::make_shared<detail::TextureObject>(implementation_->graveyard, name, image.size());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, name);
    setFilter(options);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, pixels.data());
    if (options.mipmaps && options.smooth) glGenerateMipmap(GL_TEXTURE_2D);
    return Texture(std::move(object));
}

RenderTarget Canvas::createTarget(PixelSize size) {
    requireSize(size);
    const FramebufferGuard guard;
    GLuint name = 0;
    glGenTextures(1, &name);
    auto texture = std::make_shared<detail::TextureObject>(implementation_->graveyard, name, size);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, name);
    setFilter({.mipmaps = false});
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    auto object = std::make_shared<detail::TargetObject>(std::move(texture), framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the graphics driver refused a render target");
    const GLfloat transparent[4] = {0, 0, 0, 0};
    const bool clipped = glIsEnabled(GL_SCISSOR_TEST) != 0;
    if (clipped) glDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_COLOR, 0, transparent);
    if (clipped) glEnable(GL_SCISSOR_TEST);
    return RenderTarget(std::move(object));
}

Shader Canvas::createShader(std::string_view source) {
    const std::string text(source);
    const GLuint program = detail::buildCanvasProgram(text.c_str());
    return Shader(std::make_shared<detail::ShaderObject>(implementation_->graveyard, program));
}

Image Canvas::read(const RenderTarget& target) {
    const GLuint framebuffer = implementation_->requireOwn(target).framebuffer;
    implementation_->batch.flush();
    const FramebufferGuard guard;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    Image image(target.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, image.width(), image.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                 image.bytes().data());
    implementation_->requireContext();
    unpremultiply(image);
    return image;
}

Image Canvas::readFrame() {
    auto& frame = implementation_->frame;
    implementation_->batch.flush();
    Image image(frame.size);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, image.width(), image.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                 image.bytes().data());
    implementation_->requireContext();
    if (!frame.rowZeroIsTop) flipRows(image);
    for (std::size_t i = 3; i < image.bytes().size(); i += 4) image.bytes()[i] = 255;
    return image;
}

}  // namespace atlax
