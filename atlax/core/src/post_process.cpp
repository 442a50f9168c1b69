#include <algorithm>
#include <array>
#include <atlax/post_process.hpp>
#include <cmath>

namespace atlax {

namespace {

constexpr std::size_t mostHalves = 7;

// Keeps what is above the threshold, with a soft knee so that nothing flickers at it.
constexpr const char* brightSource = R"(
uniform float threshold;
vec4 paint(vec2 uv, vec4 tint) {
    vec4 c = texture(picture, uv);
    float light = max(c.r, max(c.g, c.b));
    float kept = smoothstep(threshold, min(threshold + 0.2, 1.0), light);
    return vec4(c.rgb * kept, 0.0);
})";

// Four taps between pixels, each a mean of four: a tent that is free of blocks in both directions.
constexpr const char* spreadSource = R"(
uniform float strength;
vec4 paint(vec2 uv, vec4 tint) {
    vec2 d = 1.0 / vec2(textureSize(picture, 0));
    vec4 sum = texture(picture, uv + d) + texture(picture, uv - d) +
               texture(picture, uv + vec2(d.x, -d.y)) + texture(picture, uv + vec2(-d.x, d.y));
    return vec4(sum.rgb * 0.25 * strength, 0.0);
})";

constexpr const char* vignetteSource = R"(
uniform float strength;
uniform float begin;
vec4 paint(vec2 uv, vec4 tint) {
    float r = length(uv - 0.5) / length(vec2(0.5));
    return vec4(vec3(1.0 - strength * smoothstep(begin, 1.0, r)), 1.0);
})";

ShaderValue number(const char* name, float value) {
    return {name, {value, 0, 0, 0}};
}

}  // namespace

PostProcess::PostProcess(Canvas& canvas)
    : canvas_(canvas),
      bright_(canvas.createShader(brightSource)),
      spread_(canvas.createShader(spreadSource)),
      vignette_(canvas.createShader(vignetteSource)) {}

void PostProcess::resize(PixelSize size) {
    if (picture_.size() == size) return;
    RenderTarget picture = canvas_.createTarget(size);
    RenderTarget other = canvas_.createTarget(size);
    std::vector<RenderTarget> halves;
    for (PixelSize half = size; halves.size() < mostHalves;) {
        half = {std::max(half.width / 2, 1), std::max(half.height / 2, 1)};
        halves.push_back(canvas_.createTarget(half));
    }
    picture_ = std::move(picture);
    other_ = std::move(other);
    halves_ = std::move(halves);
}

void PostProcess::begin() {
    resize(canvas_.size());
    canvas_.pushTarget(picture_);
    canvas_.clear(colors::transparent);
}

void PostProcess::end(std::span<const PostEffect> effects) {
    canvas_.popTarget();
    canvas_.setOpacity(1);
    for (const PostEffect& effect : effects)
        std::visit([this](const auto& e) { apply(e); }, effect);
    canvas_.setShader({});
    canvas_.setBlend(Blend::Alpha);
    canvas_.drawTarget(picture_);
}

void PostProcess::draw(const RenderTarget& into, const Texture& picture, const Shader& shader,
                       std::span<const ShaderValue> values, Blend blend) {
    canvas_.pushTarget(into);
    canvas_.setBlend(blend);
    canvas_.setShader(shader, values);
    const Vec2 size = into.size().toVec();
    canvas_.sprite(picture, size * 0.5f, size);
    canvas_.setShader({});
    canvas_.popTarget();
}

// Light goes down a pyramid of halved pictures, and comes up again, each level adding its spread.
void PostProcess::apply(const Bloom& bloom) {
    if (!(bloom.strength > 0) || !std::isfinite(bloom.radius)) return;
    const float steps = std::round(std::log2(std::max(bloom.radius, 2.0f)));
    const std::size_t levels = std::min(static_cast<std::size_t>(steps), mostHalves);
    const std::array threshold{number("threshold", std::clamp(bloom.threshold, 0.0f, 1.0f))};
    const std::array whole{number("strength", 1)};
    const std::array weaker{number("strength", 0.5f)};
    const std::array last{number("strength", bloom.strength)};
    for (std::size_t i = 0; i < levels; ++i) {
        canvas_.pushTarget(halves_[i]);
        canvas_.clear(colors::transparent);
        canvas_.popTarget();
        if (i == 0)
            draw(halves_[0], picture_.texture(), bright_, threshold, Blend::Additive);
        else
            draw(halves_[i], halves_[i - 1].texture(), spread_, whole, Blend::Additive);
    }
    for (std::size_t i = levels - 1; i > 0; --i)
        draw(halves_[i - 1], halves_[i].texture(), spread_, weaker, Blend::Additive);
    draw(picture_, halves_[0].texture(), spread_, last, Blend::Additive);
}

void PostProcess::apply(const Vignette& vignette) {
    if (!(vignette.strength > 0)) return;
    const std::array values{number("strength", std::min(vignette.strength, 1.0f)),
                            number("begin", std::clamp(vignette.begin, 0.0f, 0.99f))};
    draw(picture_, {}, vignette_, values, Blend::Multiply);
}

void PostProcess::apply(const ShaderPass& pass) {
    canvas_.pushTarget(other_);
    canvas_.clear(colors::transparent);
    canvas_.popTarget();
    draw(other_, picture_.texture(), pass.shader, pass.values, Blend::Alpha);
    std::swap(picture_, other_);
}

}  // namespace atlax
