#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <atlax/camera.hpp>
#include <atlax/color.hpp>
#include <atlax/font.hpp>
#include <atlax/image.hpp>
#include <atlax/model.hpp>
#include <atlax/shader.hpp>
#include <atlax/texture.hpp>
#include <atlax/vec.hpp>

namespace atlax {

enum class Blend {
    Alpha,     ///< covers what is below by its alpha
    Additive,  ///< adds light; for glows, sparks, snow
    Multiply,  ///< darkens by its colour; for shadows and tinted glass
    Screen,    ///< lightens towards white, never beyond; for mist
};

enum class AlignX { Left, Centre, Right };
enum class AlignY { Top, Middle, Baseline, Bottom };

/// `size` is the font's em in units of the current space: pixels on the screen, metres in the
/// world.
struct TextStyle {
    float size = 16;
    Color color = colors::white;
    AlignX alignX = AlignX::Left;
    AlignY alignY = AlignY::Baseline;
};

/// One corner of a mesh; uv (0,0) is the top left of the texture.
struct MeshVertex {
    Vec2 position;
    Vec2 uv;
    Color tint = colors::white;
};

/// `uv` picks a part of the texture; a negative size mirrors it. `angle` turns by radians,
/// counter-clockwise in world space and clockwise on the screen.
struct SpriteStyle {
    float angle = 0;
    Color tint = colors::white;
    Rect uv{{0, 0}, {1, 1}};
};

/// Colours that go over from `start` to `end`; beyond both they stay. Linear: along the way between
/// two points, in bands across. Radial: from a middle to a rim, in circles.
struct Gradient {
    enum class Kind { Linear, Radial };
    Kind kind = Kind::Linear;
    Vec2 from{};  ///< of the current space; radial: the middle
    Vec2 to{};    ///< radial: a point of the rim
    Color start{};
    Color end{};
};

/// Widths of the border of a nine-patch, pixels of the picture.
struct Insets {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
};

/// A text that was drawn, for tests of layouts: the rectangle of its letters (from the height of
/// its capitals to below the line), pixels, and how visible it is.
struct DrawnText {
    std::string text;
    Rect box;
    float alpha = 1;
};

/// What one frame cost.
struct CanvasStatistics {
    int drawCalls = 0;
    int triangles = 0;
    int glyphUploads = 0;
};

/// Draws with OpenGL 3.3 core, in the order of the calls (later covers earlier), batched: a draw
/// call is spent only when the texture, the clip, the target or the shader changes, and between
/// Multiply, Screen and the other blend modes. Alpha and Additive, shapes, cameras, gradients and
/// plain colours cost none.
///
/// Lines, capsules, circles and rounded rectangles are antialiased by their distance in the
/// fragment shader, polygons by a fringe of one pixel; no multisampling is needed.
///
/// Lengths are in units of the current space: metres after setCamera, pixels after
/// setScreenSpace. What is not finite is not drawn. All calls belong to the thread that has the
/// context, and to the time between beginFrame and endFrame unless said otherwise.
class Canvas {
public:
    /// An OpenGL context must be current and stay alive as long as the canvas. Throws Error when
    /// it is older than 3.3 core.
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Called by backends. Starts a frame in a framebuffer of OpenGL (0 is the window) in screen
    /// space, with no clip, full opacity and alpha blending.
    void beginFrame(PixelSize size, float scaleFactor = 1, unsigned framebuffer = 0);
    /// The same, drawing into a target.
    void beginFrame(const RenderTarget& target, float scaleFactor = 1);
    /// Called by backends. Draws what is still batched.
    void endFrame();
    /// Whether the driver was reset and the context is lost with all that is in it: drawing does
    /// nothing any more, and reading throws. Backends ask before each frame and make all anew (see
    /// Application::restoreGraphics). Always false where the driver cannot tell.
    bool contextLost() const;

    // -- resources (any time while the context is current) --

    /// Copies the picture to the graphics card, premultiplied. Throws Error for an empty one.
    Texture createTexture(const Image& image, TextureOptions options = {});
    /// A transparent picture to draw into. Throws Error when the card refuses the size.
    RenderTarget createTarget(PixelSize size);
    /// Until popTarget, everything goes to this target, in screen space; the frame's space and clip
    /// come back afterwards. Pushes nest. No frame is needed for drawing into a target. Throws
    /// Error for an empty target and for one of another canvas, as read() does.
    void pushTarget(const RenderTarget& target);
    void popTarget();
    /// Draws a target pixel by pixel over all of what is drawn into, which should have its size;
    /// with the present blend mode, opacity and shader, whatever the space and without the clip.
    /// An empty one draws nothing; throws Error for one of another canvas.
    void drawTarget(const RenderTarget& target);
    /// Makes a shader from the GLSL 3.30 of a function
    ///
    ///     vec4 paint(vec2 uv, vec4 tint)
    ///
    /// that returns a premultiplied colour and may sample `picture`, which is premultiplied too;
    /// `tint` is premultiplied with the opacity in it. Uniforms of type float to vec4 are its
    /// parameters. Throws Error with the driver's message, whose lines are those of `source`.
    Shader createShader(std::string_view source);
    /// Copies a model to the graphics card. Throws Error as createTexture does.
    ModelMesh createModel(const Model& model);
    /// Reads a target back with straight alpha. Throws Error when the context is lost.
    Image read(const RenderTarget& target);
    /// Reads what the current frame has drawn so far (for screenshots), opaque. Throws Error when
    /// the context is lost.
    Image readFrame();

    // -- space --

    /// Size in pixels of what is drawn into, and pixels per logical unit (HiDPI).
    PixelSize size() const;
    float scaleFactor() const;
    /// World space: metres, y up.
    void setCamera(const Camera& camera);
    /// Screen space: one unit is `pixelsPerUnit` pixels, y down, origin at the top left.
    /// setScreenSpace(scaleFactor()) gives sizes that look alike on every display.
    void setScreenSpace(float pixelsPerUnit = 1);
    /// One pixel in units of the current space: the width of a hairline.
    float pixel() const;
    /// Pixels of a point of the current space, and back.
    Vec2 toPixels(Vec2 point) const;
    Vec2 fromPixels(Vec2 pixels) const;

    /// Confines drawing to a rectangle of the current space (within the clips already pushed).
    void pushClip(Rect rect);
    void popClip();

    void setBlend(Blend blend);
    /// Sprites, meshes and flat polygons that follow are painted by this shader, with these values
    /// of its uniforms, the others being 0; by the canvas again after setShader({}). Shapes, text
    /// and gradients are not affected. No shader at the start of a frame.
    void setShader(const Shader& shader, std::span<const ShaderValue> values = {});
    /// Multiplies the alpha of everything that follows, 0..1; for fades.
    void setOpacity(float opacity);

    // -- drawing --

    /// Fills all of the target, ignoring clip and blend.
    void clear(Color color);

    /// Line with round ends; thinner than a pixel it fades instead of breaking up.
    void line(Vec2 from, Vec2 to, float width, Color color);
    /// Connected lines with round joins; a transparent colour shows no overlap at the joins
    /// unless they are sharper than about 30 degrees.
    void polyline(std::span<const Vec2> points, float width, Color color, bool closed = false);
    void dashedLine(Vec2 from, Vec2 to, float width, float dash, float gap, Color color);
    void capsule(Vec2 from, Vec2 to, float radius, Color color);
    /// The line of this width lies inside the capsule's border.
    void capsuleOutline(Vec2 from, Vec2 to, float radius, float width, Color color);
    void circle(Vec2 centre, float radius, Color color);
    void circleOutline(Vec2 centre, float radius, float width, Color color);
    /// A soft spot of light: full colour in the middle, nothing at the radius.
    void glow(Vec2 centre, float radius, Color color);

    void rect(Rect rect, Color color);
    void roundedRect(Rect rect, float radius, Color color);
    void roundedRectOutline(Rect rect, float radius, float width, Color color);
    /// From the visually upper to the lower edge, dithered so that dark skies show no bands.
    void gradientRect(Rect rect, Color top, Color bottom);

    void triangle(Vec2 a, Vec2 b, Vec2 c, Color color);
    /// Any simple polygon, convex or concave, in either direction. Fewer than three points
    /// draw nothing; a polygon that crosses itself is filled somehow.
    void polygon(std::span<const Vec2> points, Color color);
    /// The same with a gradient.
    void polygon(std::span<const Vec2> points, const Gradient& gradient);
    void polygonOutline(std::span<const Vec2> points, float width, Color color);

    /// Triangles from triples of indices into `vertices`; indices out of range are skipped.
    void mesh(const Texture& texture, std::span<const MeshVertex> vertices,
              std::span<const std::uint32_t> indices);
    void sprite(const Texture& texture, Vec2 centre, Vec2 size, const SpriteStyle& style = {});

    /// A picture whose corners keep their size while its edges and its middle stretch: panels,
    /// buttons. A pixel of the border is `pixel` units wide; where the rectangle is too small for
    /// both borders they shrink alike. `uv` picks a part of the texture, as sprite() does.
    void ninePatch(const Texture& texture, Rect rect, const Insets& insets, float pixel = 1,
                   const SpriteStyle& style = {});

    /// Draws models with depth and light among each other; on what is drawn already they lie flat,
    /// as one sprite, so that clip, opacity, blend mode and shader act on them. Each part of a
    /// model is a draw call. Throws Error when the card has no room for a picture of the frame's
    /// size.
    void models(std::span<const ModelInstance> instances, const ModelView& view = {});

    /// Draws UTF-8 text at a point (see TextStyle for what the point means); '\n' starts a
    /// new line. Returns its extent in units of the current space.
    TextExtent text(const Font& font, std::string_view utf8, Vec2 position,
                    const TextStyle& style = {});
    /// The extent that text() would return.
    TextExtent measure(const Font& font, std::string_view utf8, float size) const;

    /// Whether the texts that are drawn are written down, as at first they are not.
    void recordTexts(bool on);
    /// Those of the current frame so far, or of the last one between frames, in their order; not
    /// those drawn between pushTarget and popTarget.
    const std::vector<DrawnText>& recordedTexts() const;

    /// Cost of the current frame so far, or of the last one between frames.
    CanvasStatistics statistics() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
