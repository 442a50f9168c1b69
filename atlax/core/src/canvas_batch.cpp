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
    if (!textures.empty()) {
        glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
        textures.clear();
    }
}

Batch::Batch() : program_(buildCanvasProgram()) {
    viewportUniform_ = glGetUniformLocation(program_, "viewport");
    flipUniform_ = glGetUniformLocation(program_, "flip");
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
    glDeleteProgram(program_);
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
    // Premultiplied: additive drawing is alpha 0 in the vertex, not another state.
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
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
        glUseProgram(program_);
        glUniform2f(viewportUniform_, static_cast<float>(size_.width),
                    static_cast<float>(size_.height));
        glUniform1f(flipUniform_, rowZeroIsTop_ ? -1.0f : 1.0f);
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
