#include "model_renderer.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <cmath>

#include "shader.hpp"

namespace atlax::detail {

namespace {

constexpr GLsizei samples = 4;

// `w` is 1 for a viewer far away, else the distance to the viewer in parts of the eye's. Depth is
// affine in 1 / w, as interpolation over the screen needs it (`depthRange`: a and b of a + b / w),
// or in z where w is 1.
constexpr const char* vertexSource = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform vec2 viewport;
uniform mat3 turn;
uniform vec3 place;
uniform float scale;
uniform float eye;
uniform vec2 depthRange;
out vec3 vNormal;
out vec2 vUv;
void main() {
    vec3 p = turn * position * scale;
    float z = place.z + p.z;
    vec2 ndc = (place.xy + vec2(p.x, -p.y)) / viewport * 2.0 - 1.0;
    float w = eye > 0.0 ? 1.0 - z / eye : 1.0;
    float depth = eye > 0.0 ? depthRange.x * w + depthRange.y : depthRange.x + depthRange.y * z;
    gl_Position = vec4(ndc, depth, w);
    vNormal = turn * normal;
    vUv = uv;
})";

constexpr const char* fragmentSource = R"(
in vec3 vNormal;
in vec2 vUv;
uniform vec3 towardsLight;
uniform vec3 light;
uniform vec3 ambient;
uniform vec3 color;
uniform float hasPicture;
uniform sampler2D picture;
out vec4 result;
void main() {
    vec4 surface = vec4(color, 1.0);
    if (hasPicture > 0.5) {
        vec4 texel = texture(picture, vUv);
        if (texel.a < 0.5) discard;
        surface.rgb *= texel.rgb / texel.a;
    }
    vec3 n = normalize(vNormal + vec3(0.0, 0.0, 1e-9));
    if (n.z < 0.0 && !gl_FrontFacing) n = -n;
    result = vec4(surface.rgb * min(ambient + light * max(dot(n, towardsLight), 0.0), 1.0), 1.0);
})";

std::array<float, 9> columns(const std::array<float, 3>& turn) {
    const float cx = std::cos(turn[0]), sx = std::sin(turn[0]);
    const float cy = std::cos(turn[1]), sy = std::sin(turn[1]);
    const float cz = std::cos(turn[2]), sz = std::sin(turn[2]);
    return {cz * cy,
            sz * cy,
            -sy,
            cz * sy * sx - sz * cx,
            sz * sy * sx + cz * cx,
            cy * sx,
            cz * sy * cx + sz * sx,
            sz * sy * cx - cz * sx,
            cy * cx};
}

}  // namespace

ModelRenderer::ModelRenderer() : program_(buildProgram(vertexSource, {fragmentSource})) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(2, storage_.data());
}

ModelRenderer::~ModelRenderer() {
    glDeleteProgram(program_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, storage_.data());
}

void ModelRenderer::resize(PixelSize size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (size == size_) return;
    const std::array<GLenum, 2> formats{GL_RGBA8, GL_DEPTH_COMPONENT24};
    const std::array<GLenum, 2> attachments{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (std::size_t i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, storage_[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], size.width,
                                         size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, storage_[i]);
    }
    size_ = {};
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the graphics driver refused a picture with depth for models");
    size_ = size;
}

void ModelRenderer::setView(const std::vector<Placed>& models, const ModelView& view, float eye) {
    float low = 0;
    float high = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const float reach = models[i].object->radius * std::abs(models[i].scale) + 1;
        low = i == 0 ? models[i].depth - reach : std::min(low, models[i].depth - reach);
        high = i == 0 ? models[i].depth + reach : std::max(high, models[i].depth + reach);
    }
    const auto uniform = [&](const char* name) { return glGetUniformLocation(program_, name); };
    float a = (high + low) / (high - low);
    float b = -2 / (high - low);
    if (eye > 0) {
        constexpr float nearest = 0.01f;  // of the eye's distance; nearer is cut off
        const float wNear = std::max(1 - high / eye, nearest);
        const float wFar = std::max(1 - low / eye, wNear * 1.001f);
        b = -2 / (1 / wNear - 1 / wFar);
        a = 1 - b / wFar;
    }
    glUniform2f(uniform("depthRange"), a, b);
    glUniform1f(uniform("eye"), eye);
    glUniform2f(uniform("viewport"), static_cast<float>(size_.width),
                static_cast<float>(size_.height));
    const auto& d = view.towardsLight;
    const float length = std::hypot(d[0], d[1], d[2]);
    const float scale = length > 0 ? 1 / length : 0;
    glUniform3f(uniform("towardsLight"), d[0] * scale, d[1] * scale, d[2] * scale);
    glUniform3f(uniform("light"), view.light.r, view.light.g, view.light.b);
    glUniform3f(uniform("ambient"), view.ambient.r, view.ambient.g, view.ambient.b);
}

void ModelRenderer::drawOne(const Placed& placed, int& drawCalls) {
    const auto uniform = [&](const char* name) { return glGetUniformLocation(program_, name); };
    const auto turn = columns(placed.turn);
    glUniformMatrix3fv(uniform("turn"), 1, GL_FALSE, turn.data());
    glUniform3f(uniform("place"), placed.position.x, placed.position.y, placed.depth);
    glUniform1f(uniform("scale"), placed.scale);
    glBindVertexArray(placed.object->vertexArray);
    for (const ModelObject::Part& part : placed.object->parts) {
        glUniform3f(uniform("color"), part.color.r * placed.tint.r, part.color.g * placed.tint.g,
                    part.color.b * placed.tint.b);
        glUniform1f(uniform("hasPicture"), part.picture.valid() ? 1.0f : 0.0f);
        glBindTexture(GL_TEXTURE_2D, nameOf(part.picture));
        const auto offset = static_cast<std::size_t>(part.first) * sizeof(std::uint32_t);
        glDrawElements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(offset));  // NOLINT: how OpenGL wants offsets
        ++drawCalls;
    }
    glBindVertexArray(0);
}

void ModelRenderer::draw(GLuint target, PixelSize size, const std::vector<Placed>& models,
                         const ModelView& view, float eye, int& drawCalls) {
    resize(size);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glViewport(0, 0, size.width, size.height);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program_);
    glActiveTexture(GL_TEXTURE0);
    setView(models, view, eye);
    for (const Placed& placed : models) drawOne(placed, drawCalls);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace atlax::detail
