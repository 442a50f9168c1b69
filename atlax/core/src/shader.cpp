#include "shader.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <string>
#include <vector>

namespace atlax::detail {

namespace {

// Positions arrive in pixels, y down. `flip` is -1 for targets, whose row 0 is their top.
constexpr const char* version = "#version 330 core\n";

constexpr const char* vertexSource = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 shape;
uniform vec2 viewport;
uniform float flip;
out vec2 atlaxUv;
out vec4 atlaxColor;
flat out vec4 atlaxShape;
void main() {
    vec2 ndc = position / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, -ndc.y * flip, 0.0, 1.0);
    atlaxUv = uv;
    atlaxColor = color;
    atlaxShape = shape;
})";

// Every colour is premultiplied. shape.w >= 0: a rounded box (a circle and a capsule are such boxes
// too) of half extents shape.xy, rounded by shape.z; uv is the place in pixels from its middle;
// shape.w is half the width of its outline, 0 when filled. Negative numbers are the modes of
// batch.hpp. The coverage of a pixel is taken as its signed distance to the border.
constexpr const char* fragmentHead = R"(
in vec2 atlaxUv;
in vec4 atlaxColor;
flat in vec4 atlaxShape;
uniform sampler2D picture;
out vec4 atlaxResult;
vec4 paint(vec2 uv, vec4 tint);
)";

constexpr const char* fragmentMain = R"(
float atlaxDither() {  // half a step of 8 bits to either side; interleaved gradient noise
    vec2 p = gl_FragCoord.xy;
    return (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

vec3 atlaxBytes(float three) {
    return vec3(floor(three / 65536.0), floor(mod(three, 65536.0) / 256.0), mod(three, 256.0)) / 255.0;
}

vec4 atlaxGradient(float t) {  // both colours as gradientShape() packs them
    vec3 a = atlaxBytes(atlaxShape.x);
    vec3 b = atlaxBytes(atlaxShape.y);
    vec3 c = atlaxBytes(atlaxShape.z);
    return mix(vec4(a, b.x), vec4(b.yz, c.xy), clamp(t, 0.0, 1.0));
}

void main() {
#ifdef ATLAX_CUSTOM
    vec4 painted = paint(atlaxUv, atlaxColor);  // here, because branches have no derivatives
#endif
    vec2 gradientX = dFdx(atlaxUv);
    vec2 gradientY = dFdy(atlaxUv);
    float mode = atlaxShape.w;
    if (mode >= 0.0) {
        vec2 q = abs(atlaxUv) - atlaxShape.xy;
        float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - atlaxShape.z;
        if (mode > 0.0) d = abs(d) - mode;
        atlaxResult = atlaxColor * clamp(0.5 - d, 0.0, 1.0);
#ifdef ATLAX_CUSTOM
    } else if (mode > -2.5) {
        atlaxResult = painted;
#else
    } else if (mode > -1.5) {
        atlaxResult = atlaxColor * textureGrad(picture, atlaxUv, gradientX, gradientY);
    } else if (mode > -2.5) {
        atlaxResult = atlaxColor;
#endif
    } else if (mode > -3.5) {
        atlaxResult = atlaxColor + vec4(vec3(atlaxDither()), 0.0) * atlaxColor.a;
    } else if (mode > -4.5) {
        float t = max(1.0 - dot(atlaxUv, atlaxUv), 0.0);
        float light = t * t * t;
        atlaxResult = atlaxColor * light + vec4(vec3(atlaxDither()), 0.0) * sqrt(light);
    } else {
        vec4 c = atlaxGradient(mode < -5.5 ? length(atlaxUv) : atlaxUv.x);
        atlaxResult = (c + vec4(vec3(atlaxDither()), 0.0) * c.a) * atlaxColor.a;
    }
})";

GLuint compile(GLenum kind, const std::vector<const char*>& parts) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
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

GLuint buildCanvasProgram(const char* paint) {
    if (paint == nullptr) return buildProgram(vertexSource, {fragmentHead, fragmentMain});
    return buildProgram(
        vertexSource, {"#define ATLAX_CUSTOM\n", fragmentHead, fragmentMain, "\n#line 1\n", paint});
}

GLuint buildProgram(const char* vertexPart, const std::vector<const char*>& fragmentParts) {
    std::vector<const char*> parts(fragmentParts.size() + 1, version);
    std::copy(fragmentParts.begin(), fragmentParts.end(), parts.begin() + 1);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, parts);
    const GLuint vertex = compile(GL_VERTEX_SHADER, {version, vertexPart});
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
        throw Error(
            "the graphics driver could not link a shader; a shader of one's own needs the "
            "function vec4 paint(vec2 uv, vec4 tint)");
    }
    return program;
}

}  // namespace atlax::detail
