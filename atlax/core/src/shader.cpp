#include "shader.hpp"

#include <atlax/error.hpp>
#include <string>

namespace atlax::detail {

namespace {

// Positions arrive in pixels, y down. `flip` is -1 for targets, whose row 0 is their top.
constexpr const char* vertexSource = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 shape;
uniform vec2 viewport;
uniform float flip;
out vec2 vUv;
out vec4 vColor;
flat out vec4 vShape;
void main() {
    vec2 ndc = position / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, -ndc.y * flip, 0.0, 1.0);
    vUv = uv;
    vColor = color;
    vShape = shape;
})";

// Every colour is premultiplied. shape.w >= 0: a rounded box (a circle and a capsule are such boxes
// too) of half extents shape.xy, rounded by shape.z; uv is the place in pixels from its middle;
// shape.w is half the width of its outline, 0 when filled. Negative numbers are the modes of
// batch.hpp. The coverage of a pixel is taken as its signed distance to the border.
constexpr const char* fragmentSource = R"(#version 330 core
in vec2 vUv;
in vec4 vColor;
flat in vec4 vShape;
uniform sampler2D picture;
out vec4 result;

float dither() {  // half a step of 8 bits to either side; interleaved gradient noise
    vec2 p = gl_FragCoord.xy;
    return (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

void main() {
    vec2 gradientX = dFdx(vUv);
    vec2 gradientY = dFdy(vUv);
    float mode = vShape.w;
    if (mode >= 0.0) {
        vec2 q = abs(vUv) - vShape.xy;
        float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - vShape.z;
        if (mode > 0.0) d = abs(d) - mode;
        result = vColor * clamp(0.5 - d, 0.0, 1.0);
    } else if (mode > -1.5) {
        result = vColor * textureGrad(picture, vUv, gradientX, gradientY);
    } else if (mode > -2.5) {
        result = vColor;
    } else if (mode > -3.5) {
        result = vColor + vec4(vec3(dither()), 0.0) * vColor.a;
    } else {
        float t = max(1.0 - dot(vUv, vUv), 0.0);
        float light = t * t * t;
        result = vColor * light + vec4(vec3(dither()), 0.0) * sqrt(light);
    }
})";

GLuint compile(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok != 0) return shader;
    std::string message(1024, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), &length, message.data());
    message.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw Error("the graphics driver refused a shader: " + message);
}

}  // namespace

GLuint buildCanvasProgram() {
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok == 0) {
        glDeleteProgram(program);
        throw Error("the graphics driver could not link the canvas's shaders");
    }
    return program;
}

}  // namespace atlax::detail
