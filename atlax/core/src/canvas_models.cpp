#include <algorithm>
#include <cmath>
#include <cstddef>

#include "canvas_impl.hpp"
#include "model_renderer.hpp"

namespace atlax {

namespace {

const void* offsetPointer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT: how OpenGL wants offsets
}

void describeVertices() {
    constexpr GLsizei stride = sizeof(ModelVertex);
    for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride,
                          offsetPointer(offsetof(ModelVertex, position)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride,
                          offsetPointer(offsetof(ModelVertex, normal)));
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride,
                          offsetPointer(offsetof(ModelVertex, uv)));
}

template <class T>
void upload(GLenum target, GLuint buffer, const std::vector<T>& data) {
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                 GL_STATIC_DRAW);
}

}  // namespace

ModelMesh Canvas::createModel(const Model& model) {
    auto object = std::make_shared<detail::ModelObject>(implementation_->graveyard);
    std::vector<ModelVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const ModelPart& part : model.parts) {
        if (part.vertices.empty() || part.indices.size() % 3 != 0) continue;
        const auto base = static_cast<std::uint32_t>(vertices.size());
        detail::ModelObject::Part made{
            .first = static_cast<GLsizei>(indices.size()), .color = part.color, .picture = {}};
        for (const std::uint32_t i : part.indices)
            indices.push_back(base +
                              std::min(i, static_cast<std::uint32_t>(part.vertices.size() - 1)));
        made.count = static_cast<GLsizei>(indices.size()) - made.first;
        for (const ModelVertex& v : part.vertices)
            object->radius =
                std::max(object->radius, std::hypot(v.position[0], v.position[1], v.position[2]));
        vertices.insert(vertices.end(), part.vertices.begin(), part.vertices.end());
        if (!part.picture.empty()) made.picture = createTexture(part.picture, {.repeat = true});
        object->parts.push_back(std::move(made));
    }
    glGenVertexArrays(1, &object->vertexArray);
    glGenBuffers(2, object->buffers.data());
    glBindVertexArray(object->vertexArray);
    upload(GL_ARRAY_BUFFER, object->buffers[0], vertices);
    upload(GL_ELEMENT_ARRAY_BUFFER, object->buffers[1], indices);
    describeVertices();
    glBindVertexArray(0);
    return ModelMesh(std::move(object));
}

void Canvas::models(std::span<const ModelInstance> instances, const ModelView& view) {
    auto& self = *implementation_;
    const Space& space = self.frame.space;
    std::vector<detail::ModelRenderer::Placed> placed;
    for (const ModelInstance& one : instances) {
        const bool ours = one.model.valid() && one.model.object_->graveyard == self.graveyard;
        const float sum = one.position.x + one.position.y + one.depth + one.size + one.turn[0] +
                          one.turn[1] + one.turn[2];
        if (!ours || !std::isfinite(sum) || !(one.size > 0)) continue;
        placed.push_back({one.model.object_.get(), space.toPixels(one.position),
                          space.length(one.depth), space.length(one.size), one.turn, one.tint});
    }
    if (placed.empty() || self.frame.size.empty()) return;
    self.batch.flush();
    if (self.modelTarget.size() != self.frame.size)
        self.modelTarget = createTarget(self.frame.size);
    if (self.models == nullptr) self.models = std::make_unique<detail::ModelRenderer>();
    const float eye = view.eye > 0 && std::isfinite(view.eye) ? space.length(view.eye) : 0.0f;
    self.models->draw(self.modelTarget.object_->framebuffer, self.frame.size, placed, view, eye,
                      self.batch.statistics.drawCalls);
    self.bindFrame();
    // As a sprite, so that clip, opacity, blend mode and shader act as on all else.
    const Space before = std::exchange(self.frame.space, Space{});
    const Vec2 size = self.frame.size.toVec();
    sprite(self.modelTarget.texture(), size * 0.5f, size);
    self.frame.space = before;
}

}  // namespace atlax
