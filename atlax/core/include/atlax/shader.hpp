#pragma once

#include <array>
#include <memory>
#include <string>

namespace atlax {

class Canvas;

namespace detail {
struct ShaderObject;
}

/// What a shader's uniform of that name is set to; of a float only the first number counts, of a
/// vec2 two, and so on. Names that the shader does not use are ignored, because drivers drop them.
struct ShaderValue {
    std::string name{};
    std::array<float, 4> value{};
};

/// A caller's own way to colour sprites and meshes, made by Canvas::createShader. A cheap handle:
/// copies share the shader, which lives as long as a handle or an unfinished frame needs it. It may
/// outlive the canvas; to another canvas it is no shader. Thread of its canvas only; nothing here
/// throws, only Canvas::createShader.
class Shader {
public:
    /// No shader: the canvas's own drawing.
    Shader() = default;

    bool valid() const { return object_ != nullptr; }

private:
    friend class Canvas;
    explicit Shader(std::shared_ptr<detail::ShaderObject> object) : object_(std::move(object)) {}
    std::shared_ptr<detail::ShaderObject> object_;
};

}  // namespace atlax
