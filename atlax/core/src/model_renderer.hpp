#pragma once

#include <epoxy/gl.h>

#include <atlax/model.hpp>
#include <atlax/texture.hpp>
#include <memory>
#include <vector>

#include "gl_objects.hpp"

namespace atlax::detail {

/// A model in buffers of the graphics card.
struct ModelObject {
    struct Part {
        GLsizei first = 0;  ///< index in the index buffer
        GLsizei count = 0;
        Color color;
        Texture picture;
    };
    std::shared_ptr<Graveyard> graveyard;
    GLuint vertexArray = 0;
    std::array<GLuint, 2> buffers{};
    std::vector<Part> parts;
    float radius = 0;  ///< of the sphere round the origin that holds all

    explicit ModelObject(std::shared_ptr<Graveyard> g) : graveyard(std::move(g)) {}
    ~ModelObject() {
        graveyard->vertexArrays.push_back(vertexArray);
        graveyard->buffers.insert(graveyard->buffers.end(), buffers.begin(), buffers.end());
    }
    ModelObject(const ModelObject&) = delete;
    ModelObject& operator=(const ModelObject&) = delete;
};

/// Draws models into a multisampled picture with depth, and resolves it into a target.
class ModelRenderer {
public:
    /// Places in pixels, y down; depth in pixels towards the viewer.
    struct Placed {
        const ModelObject* object = nullptr;
        Vec2 position;
        float depth = 0;
        float scale = 1;
        std::array<float, 3> turn{};
        Color tint;
    };

    ModelRenderer();
    ~ModelRenderer();
    ModelRenderer(const ModelRenderer&) = delete;
    ModelRenderer& operator=(const ModelRenderer&) = delete;

    /// `eye` in pixels. Throws Error when the card refuses the picture.
    void draw(GLuint target, PixelSize size, const std::vector<Placed>& models,
              const ModelView& view, float eye, int& drawCalls);

private:
    void resize(PixelSize size);
    void setView(const std::vector<Placed>& models, const ModelView& view, float eye);
    void drawOne(const Placed& placed, int& drawCalls);

    GLuint program_ = 0;
    GLuint framebuffer_ = 0;
    std::array<GLuint, 2> storage_{};  ///< colour and depth
    PixelSize size_;
};

}  // namespace atlax::detail
