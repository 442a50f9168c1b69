#include <algorithm>
#include <cmath>
#include <cstddef>

#include "batch.hpp"
#include "shader.hpp"

namespace atlax::detail {

namespace {

// One upload stays below this, so that memory is bounded whatever a frame draws.
constexpr std::size_t maxVertices = 1u << 18;

const void* offsetPointer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT: how OpenGL wants offsets
}

void describeVertices() {
    constexpr GLsizei stride = sizeof(Vertex);
    for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride,
                          offsetPointer(offsetof(Vertex, position)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offsetPointer(offsetof(Vertex, uv)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_SHORT, GL_TRUE, stride,
                          offsetPointer(offsetof(Vertex, color)));
    glVertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, stride, offsetPointer(offsetof(Vertex, shape)));
}

}  // namespace

void Graveyard::bury() {
    if (!framebuffers.empty()) {
        glDeleteFramebuffers(static_cast<GLsizei>(framebuffers.size()), framebuffers.data());
        framebuffers.clear();
    }
    for (const GLuint program : programs) glDeleteProgram(program);
    programs.clear();
    glDeleteVertexArrays(static_cast<GLsizei>(vertexArrays.size()), vertexArrays.data());
    vertexArrays.clear();
    glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    buffers.clear();
    if (!textures.empty()) {
        glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
        textures.clear();
    }
}

ShaderObject::ShaderObject(std::shared_ptr<Graveyard> g, GLuint p)
    : graveyard(std::move(g)), program(p) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()),
                           nullptr, &size, &type, name.data());
        const GLint location = glGetUniformLocation(program, name.data());
        const std::string_view view(name.data());
        if (view == "viewport")
            viewport = location;
        else if (view == "flip")
            flip = location;
        else if (type == GL_FLOAT || type == GL_FLOAT_VEC2 || type == GL_FLOAT_VEC3 ||
                 type == GL_FLOAT_VEC4)
            uniforms.push_back({name.data(), location, type});
    }
}

std::array<float, 4> gradientShape(const PackedColor& start, const PackedColor& end, Mode mode) {
    const auto eight = [](std::uint16_t v) { return (v * 255u + 32767u) / 65535u; };
    const auto three = [](unsigned a, unsigned b, unsigned c) {
        return static_cast<float>(a << 16 | b << 8 | c);
    };
    return {three(eight(start[0]), eight(start[1]), eight(start[2])),
            three(eight(start[3]), eight(end[0]), eight(end[1])),
            three(eight(end[2]), eight(end[3]), 0), static_cast<float>(static_cast<int>(mode))};
}

Batch::Batch(std::shared_ptr<Graveyard> graveyard)
    : plain_(std::make_shared<ShaderObject>(std::move(graveyard), buildCanvasProgram())) {
    glGenVertexArrays(1, &vertexArray_);
    glGenBuffers(1, &vertexBuffer_);
    glGenBuffers(1, &indexBuffer_);
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer_);
    describeVertices();
    glBindVertexArray(0);
}

Batch::~Batch() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &vertexBuffer_);
    glDeleteBuffers(1, &indexBuffer_);
}

void Batch::bindTarget(GLuint framebuffer, PixelSize size, bool rowZeroIsTop) {
    flush();
    size_ = size;
    rowZeroIsTop_ = rowZeroIsTop;
    clipped_ = false;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
}

void Batch::setClip(const Rect* pixels) {
    if (pixels == nullptr && !clipped_) return;
    if (pixels != nullptr && clipped_ && *pixels == clip_) return;
    flush();
    clipped_ = pixels != nullptr;
    if (!clipped_) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    clip_ = *pixels;
    const Vec2 limit = size_.toVec();
    const auto edge = [](float v, float high) {
        return static_cast<int>(std::lround(std::clamp(v, 0.0f, high)));
    };
    const int left = edge(clip_.min.x, limit.x);
    const int right = edge(clip_.max().x, limit.x);
    const int top = edge(clip_.min.y, limit.y);
    const int bottom = edge(clip_.max().y, limit.y);
    glEnable(GL_SCISSOR_TEST);
    glScissor(left, rowZeroIsTop_ ? top : size_.height - bottom, std::max(right - left, 0),
              std::max(bottom - top, 0));
}

void Batch::useTexture(const std::shared_ptr<TextureObject>& texture) {
    if (texture_ == texture) return;
    if (texture_ != nullptr) flush();
    texture_ = texture;
}

void Batch::setBlend(Blend blend) {
    // Premultiplied: additive drawing is alpha 0 in the vertex, not another state.
    if (blend == Blend::Additive) blend = Blend::Alpha;
    if (blend == blend_) return;
    flush();
    blend_ = blend;
}

void Batch::setShader(std::shared_ptr<ShaderObject> shader, std::span<const ShaderValue> values) {
    if (shader == nullptr && shader_ == nullptr) return;
    flush();
    shader_ = std::move(shader);
    values_.assign(values.begin(), values.end());
}

void Batch::useProgram() const {
    const ShaderObject& object = shader_ ? *shader_ : *plain_;
    glUseProgram(object.program);
    glUniform2f(object.viewport, static_cast<float>(size_.width), static_cast<float>(size_.height));
    glUniform1f(object.flip, rowZeroIsTop_ ? -1.0f : 1.0f);
    for (const auto& uniform : object.uniforms) {
        std::array<float, 4> v{};
        for (const ShaderValue& value : values_)
            if (value.name == uniform.name) v = value.value;
        if (uniform.type == GL_FLOAT) glUniform1f(uniform.location, v[0]);
        if (uniform.type == GL_FLOAT_VEC2) glUniform2f(uniform.location, v[0], v[1]);
        if (uniform.type == GL_FLOAT_VEC3) glUniform3f(uniform.location, v[0], v[1], v[2]);
        if (uniform.type == GL_FLOAT_VEC4) glUniform4f(uniform.location, v[0], v[1], v[2], v[3]);
    }
    if (blend_ == Blend::Multiply)
        glBlendFunc(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA);
    else
        glBlendFunc(GL_ONE,
                    blend_ == Blend::Screen ? GL_ONE_MINUS_SRC_COLOR : GL_ONE_MINUS_SRC_ALPHA);
}

void Batch::reserve(std::size_t count) {
    if (vertices_.empty() || vertices_.size() + count <= maxVertices) return;
    const auto texture = texture_;  // flush lets it go, but the caller has just chosen it
    flush();
    texture_ = texture;
}

void Batch::quad(const std::array<Vertex, 4>& corners) {
    reserve(4);
    const std::uint32_t first = add(corners[0]);
    for (std::size_t i = 1; i < 4; ++i) add(corners[i]);
    triangle(first, first + 1, first + 2);
    triangle(first, first + 2, first + 3);
}

void Batch::flush() {
    if (!indices_.empty()) {
        useProgram();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture_ ? texture_->name : 0);
        glBindVertexArray(vertexArray_);
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)),
                     vertices_.data(), GL_STREAM_DRAW);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)),
                     indices_.data(), GL_STREAM_DRAW);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_INT,
                       nullptr);
        glBindVertexArray(0);
        ++statistics.drawCalls;
        statistics.triangles += static_cast<int>(indices_.size() / 3);
    }
    vertices_.clear();
    indices_.clear();
    texture_.reset();
}

}  // namespace atlax::detail
