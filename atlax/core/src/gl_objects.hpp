#pragma once

#include <epoxy/gl.h>

#include <atlax/texture.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace atlax::detail {

/// Names of OpenGL objects whose last handle is gone. They are deleted by their canvas when its
/// context is surely current; after the canvas they died with the context.
struct Graveyard {
    std::vector<GLuint> textures;
    std::vector<GLuint> framebuffers;

    void bury();
};

struct TextureObject {
    std::shared_ptr<Graveyard> graveyard;
    GLuint name = 0;
    PixelSize size;

    TextureObject(std::shared_ptr<Graveyard> g, GLuint n, PixelSize s)
        : graveyard(std::move(g)), name(n), size(s) {}
    ~TextureObject() { graveyard->textures.push_back(name); }
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;
};

struct TargetObject {
    std::shared_ptr<TextureObject> texture;
    GLuint framebuffer = 0;

    TargetObject(std::shared_ptr<TextureObject> t, GLuint f)
        : texture(std::move(t)), framebuffer(f) {}
    ~TargetObject() { texture->graveyard->framebuffers.push_back(framebuffer); }
    TargetObject(const TargetObject&) = delete;
    TargetObject& operator=(const TargetObject&) = delete;
};

}  // namespace atlax::detail
