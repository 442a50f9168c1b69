#include <algorithm>
#include <atlax/error.hpp>
#include <cmath>

#include "canvas_impl.hpp"

namespace atlax {

namespace {

void requireOpenGl() {
    constexpr int needed = 33;
    const auto* version = glGetString(GL_VERSION);
    if (version == nullptr) throw Error("no OpenGL context is current");
    if (!epoxy_is_desktop_gl() || epoxy_gl_version() < needed)
        throw Error(std::string("OpenGL 3.3 is needed, but this machine's driver offers only ") +
                    reinterpret_cast<const char*>(version));  // NOLINT: OpenGL's own type
}

Rect intersection(Rect a, Rect b) {
    const Vec2 low{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)};
    const Vec2 high{std::min(a.max().x, b.max().x), std::min(a.max().y, b.max().y)};
    return {low, {std::max(high.x - low.x, 0.0f), std::max(high.y - low.y, 0.0f)}};
}

}  // namespace

Canvas::Canvas() {
    requireOpenGl();
    implementation_ = std::make_unique<Implementation>();
    constexpr int knows = 45;
    implementation_->tellsOfLoss = epoxy_gl_version() >= knows ||
                                   epoxy_has_gl_extension("GL_KHR_robustness") ||
                                   epoxy_has_gl_extension("GL_ARB_robustness");
}

Canvas::~Canvas() {
    implementation_->glyphs.clear();
    implementation_->frame = {};
    implementation_->saved.clear();
    implementation_->modelTarget = {};
    implementation_->graveyard->bury();
}

void Canvas::beginFrame(PixelSize size, float scaleFactor, unsigned framebuffer) {
    auto& self = *implementation_;
    self.graveyard->bury();
    self.batch.statistics = {};
    self.texts.clear();
    self.frame = {};
    self.frame.framebuffer = framebuffer;
    self.frame.size = size;
    self.saved.clear();
    self.scaleFactor = scaleFactor > 0 ? scaleFactor : 1;
    setShader({});
    setBlend(Blend::Alpha);
    self.opacity = 1;
    self.bindFrame();
}

void Canvas::beginFrame(const RenderTarget& target, float scaleFactor) {
    if (!target.valid()) throw Error("a frame cannot begin in an empty render target");
    beginFrame(target.size(), scaleFactor, target.object_->framebuffer);
    auto& self = *implementation_;
    self.frame.rowZeroIsTop = true;
    self.frame.target = target.object_;
    self.bindFrame();
}

void Canvas::endFrame() {
    auto& self = *implementation_;
    self.batch.flush();
    self.frame.target.reset();
    self.saved.clear();
}

bool Canvas::contextLost() const {
    return implementation_->lost();
}

void Canvas::Implementation::requireContext() const {
    if (lost()) throw Error("the graphics context was lost, and with it the picture to be read");
}

const detail::TargetObject& Canvas::Implementation::requireOwn(const RenderTarget& target) const {
    if (!target.valid()) throw Error("an empty render target cannot be drawn into or read");
    if (target.object_->texture->graveyard != graveyard)
        throw Error("this render target belongs to another canvas or to a lost graphics context");
    return *target.object_;
}

void Canvas::pushTarget(const RenderTarget& target) {
    auto& self = *implementation_;
    const GLuint framebuffer = self.requireOwn(target).framebuffer;
    self.saved.push_back(self.frame);
    self.frame = {};
    self.frame.framebuffer = framebuffer;
    self.frame.size = target.size();
    self.frame.rowZeroIsTop = true;
    self.frame.target = target.object_;
    self.bindFrame();
}

void Canvas::popTarget() {
    auto& self = *implementation_;
    if (self.saved.empty()) return;
    self.batch.flush();
    self.frame = std::move(self.saved.back());
    self.saved.pop_back();
    self.bindFrame();
}

void Canvas::Implementation::bindFrame() {
    batch.bindTarget(frame.framebuffer, frame.size, frame.rowZeroIsTop);
    applyClip();
}

void Canvas::Implementation::applyClip() {
    batch.setClip(frame.clips.empty() ? nullptr : &frame.clips.back());
}

PixelSize Canvas::size() const {
    return implementation_->frame.size;
}

float Canvas::scaleFactor() const {
    return implementation_->scaleFactor;
}

void Canvas::setCamera(const Camera& camera) {
    auto& frame = implementation_->frame;
    frame.space.centre = camera.centre;
    frame.space.origin = frame.size.toVec() * 0.5f;
    frame.space.scale = {camera.pixelsPerMetre, -camera.pixelsPerMetre};
}

void Canvas::setScreenSpace(float pixelsPerUnit) {
    implementation_->frame.space = {{}, {pixelsPerUnit, pixelsPerUnit}, {}};
}

float Canvas::pixel() const {
    return 1 / implementation_->frame.space.scale.x;
}

Vec2 Canvas::toPixels(Vec2 point) const {
    return implementation_->frame.space.toPixels(point);
}

Vec2 Canvas::fromPixels(Vec2 pixels) const {
    return implementation_->frame.space.fromPixels(pixels);
}

void Canvas::pushClip(Rect rect) {
    auto& frame = implementation_->frame;
    Rect pixels = frame.space.toPixels(rect);
    if (!frame.clips.empty()) pixels = intersection(pixels, frame.clips.back());
    frame.clips.push_back(pixels);
    implementation_->applyClip();
}

void Canvas::popClip() {
    auto& clips = implementation_->frame.clips;
    if (!clips.empty()) clips.pop_back();
    implementation_->applyClip();
}

void Canvas::setBlend(Blend blend) {
    implementation_->blend = blend;
    implementation_->batch.setBlend(blend);
}

void Canvas::setShader(const Shader& shader, std::span<const ShaderValue> values) {
    // A shader of another canvas would be some other program's name here.
    const bool ours =
        shader.object_ != nullptr && shader.object_->graveyard == implementation_->graveyard;
    implementation_->batch.setShader(ours ? shader.object_ : nullptr, values);
}

void Canvas::setOpacity(float opacity) {
    implementation_->opacity = std::clamp(opacity, 0.0f, 1.0f);
}

void Canvas::clear(Color color) {
    implementation_->batch.flush();
    glDisable(GL_SCISSOR_TEST);
    glClearColor(color.r * color.a, color.g * color.a, color.b * color.a, color.a);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!implementation_->frame.clips.empty()) glEnable(GL_SCISSOR_TEST);
}

CanvasStatistics Canvas::statistics() const {
    return implementation_->batch.statistics;
}

detail::PackedColor Canvas::Implementation::pack(Color color) const {
    const auto part = [](float v) {
        const float clamped = v > 0 ? std::min(v, 1.0f) : 0.0f;  // NaN becomes 0
        return static_cast<std::uint16_t>(std::lround(clamped * 65535.0f));
    };
    const float alpha = std::clamp(color.a, 0.0f, 1.0f) * opacity;
    return {part(color.r * alpha), part(color.g * alpha), part(color.b * alpha),
            blend == Blend::Additive ? std::uint16_t{0} : part(alpha)};
}

}  // namespace atlax
