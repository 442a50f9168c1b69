#pragma once

#include <epoxy/gl.h>

#include <atlax/texture.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace atlax::detail {

/// Names of OpenGL objects whose last handle is gone. They are deleted by their canvas when its
/// context is surely current; after the canvas they died with the context.
struct Graveyard {
    std::vector<GLuint> textures;
    std::vector<GLuint> framebuffers;
    std::vector<GLuint> programs;
    std::vector<GLuint> vertexArrays;
    std::vector<GLuint> buffers;

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

/// OpenGL's name of a texture, 0 for none.
GLuint nameOf(const Texture& texture);

/// A program of the canvas: its own, or a caller's shader.
struct ShaderObject {
    struct Uniform {
        std::string name;
        GLint location = -1;
        GLenum type = GL_FLOAT;
    };
    std::shared_ptr<Graveyard> graveyard;
    GLuint program = 0;
    GLint viewport = -1;
    GLint flip = -1;
    std::vector<Uniform> uniforms;  ///< the caller's

    ShaderObject(std::shared_ptr<Graveyard> g, GLuint p);
    ~ShaderObject() { graveyard->programs.push_back(program); }
    ShaderObject(const ShaderObject&) = delete;
    ShaderObject& operator=(const ShaderObject&) = delete;
};

}  // namespace atlax::detail
