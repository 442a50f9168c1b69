#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include <hb-ft.h>
#include <hb.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/font.hpp>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

namespace atlax {

namespace {

constexpr std::size_t mostFontBytes = 64u << 20;
constexpr std::size_t mostCachedLines = 1024;
// Light hinting only moves outlines vertically, so letters stay crisp and evenly spaced.
constexpr FT_Int32 loadFlags = FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP;

struct Library {
    FT_Library handle = nullptr;
    Library() {
        if (FT_Init_FreeType(&handle) != 0) throw Error("FreeType could not be started");
    }
    ~Library() { FT_Done_FreeType(handle); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

/// Fonts share one library, which lives as long as the last of them.
std::shared_ptr<Library> sharedLibrary() {
    static std::weak_ptr<Library> known;
    auto library = known.lock();
    if (library == nullptr) known = library = std::make_shared<Library>();
    return library;
}

int toSize64(float size) {
    const float safe = std::isfinite(size) ? size : Font::minSize;
    return static_cast<int>(std::lround(std::clamp(safe, Font::minSize, Font::maxSize) * 64.0f));
}

float from26Dot6(long value) {
    return static_cast<float>(value) / 64.0f;
}

std::vector<std::filesystem::path> fontFolders() {
    std::vector<std::filesystem::path> folders;
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
        folders.emplace_back(std::filesystem::path(home) / ".local/share/fonts");
    folders.emplace_back("/usr/local/share/fonts");
    folders.emplace_back("/usr/share/fonts");
    return folders;
}

bool isFontFile(const std::filesystem::path& file) {
    const auto extension = file.extension();
    return extension == ".otf" || extension == ".ttf";
}

}  // namespace

class Font::Face {
public:
    explicit Face(const std::filesystem::path& file)
        : library_(sharedLibrary()), bytes_(readBytes(file, mostFontBytes)) {
        const auto* data = reinterpret_cast<const FT_Byte*>(bytes_.data());  // NOLINT
        if (FT_New_Memory_Face(library_->handle, data, static_cast<FT_Long>(bytes_.size()), 0,
                               &face_) != 0)
            throw Error(file.string() + ": not a font that FreeType can read");
        if (!FT_IS_SCALABLE(face_)) {
            FT_Done_Face(face_);
            throw Error(file.string() + ": not a scalable font");
        }
        setSize(toSize64(16));
        shaper_ = hb_ft_font_create_referenced(face_);
        hb_ft_font_set_load_flags(shaper_, loadFlags);
        buffer_ = hb_buffer_create();
    }
    ~Face() {
        hb_buffer_destroy(buffer_);
        hb_font_destroy(shaper_);
        FT_Done_Face(face_);
    }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    FontMetrics metrics(int size64) {
        setSize(size64);
        const FT_Size_Metrics& m = face_->size->metrics;
        FontMetrics out{from26Dot6(m.ascender), -from26Dot6(m.descender), from26Dot6(m.height), 0};
        const auto* os2 = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(face_, FT_SFNT_OS2));
        constexpr FT_UShort withCapHeight = 2;
        const bool known = os2 != nullptr && os2->version != 0xFFFF &&
                           os2->version >= withCapHeight && os2->sCapHeight > 0;
        out.capHeight =
            known ? from26Dot6(FT_MulFix(os2->sCapHeight, m.y_scale)) : out.ascent * 0.75f;
        return out;
    }

    const ShapedLine& shape(std::string_view text, int size64) {
        std::string key = std::to_string(size64) + ' ';
        key += text;
        if (const auto known = lines_.find(key); known != lines_.end()) return known->second;
        if (lines_.size() >= mostCachedLines) lines_.clear();
        return lines_.emplace(std::move(key), shapeNow(text, size64)).first->second;
    }

    GlyphBitmap rasterise(std::uint32_t glyph, int size64, int phase) {
        setSize(size64);
        GlyphBitmap out;
        if (FT_Load_Glyph(face_, glyph, loadFlags) != 0) return out;
        if (face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE)
            FT_Outline_Translate(&face_->glyph->outline, FT_Pos{std::clamp(phase, 0, 3)} * 16, 0);
        if (FT_Render_Glyph(face_->glyph, FT_RENDER_MODE_NORMAL) != 0) return out;
        const FT_Bitmap& bitmap = face_->glyph->bitmap;
        if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return out;
        out.width = static_cast<int>(bitmap.width);
        out.height = static_cast<int>(bitmap.rows);
        out.left = face_->glyph->bitmap_left;
        out.top = face_->glyph->bitmap_top;
        out.coverage.reserve(std::size_t{bitmap.width} * bitmap.rows);
        for (unsigned row = 0; row < bitmap.rows; ++row) {
            const auto* start = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
            out.coverage.insert(out.coverage.end(), start, start + bitmap.width);
        }
        return out;
    }

    std::uint64_t id() const { return id_; }

private:
    void setSize(int size64) {
        if (size64 == size64_) return;
        if (FT_Set_Char_Size(face_, 0, size64, 72, 72) != 0)
            throw Error("a font cannot be scaled to the size asked for");
        size64_ = size64;
        if (shaper_ != nullptr) hb_ft_font_changed(shaper_);
    }

    ShapedLine shapeNow(std::string_view text, int size64) {
        setSize(size64);
        hb_buffer_clear_contents(buffer_);
        hb_buffer_add_utf8(buffer_, text.data(), static_cast<int>(text.size()), 0,
                           static_cast<int>(text.size()));
        hb_buffer_guess_segment_properties(buffer_);
        hb_shape(shaper_, buffer_, nullptr, 0);
        unsigned count = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer_, &count);
        const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer_, &count);
        ShapedLine line;
        line.glyphs.reserve(count);
        long pen = 0;
        for (unsigned i = 0; i < count; ++i) {
            line.glyphs.push_back(
                {infos[i].codepoint,
                 {from26Dot6(pen + places[i].x_offset), from26Dot6(places[i].y_offset)}});
            pen += places[i].x_advance;
        }
        line.width = from26Dot6(pen);
        return line;
    }

    static std::uint64_t nextId() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }

    std::shared_ptr<Library> library_;
    std::vector<std::byte> bytes_;
    FT_Face face_ = nullptr;
    hb_font_t* shaper_ = nullptr;
    hb_buffer_t* buffer_ = nullptr;
    int size64_ = 0;
    std::uint64_t id_ = nextId();
    std::unordered_map<std::string, ShapedLine> lines_;
};

Font::Font(std::shared_ptr<Face> face) : face_(std::move(face)) {}

Font Font::load(const std::filesystem::path& file) {
    return Font(std::make_shared<Face>(file));
}

Font Font::find(std::initializer_list<std::string_view> faces) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (const fs::path& folder : fontFolders()) {
        std::error_code ignored;
        const auto options = fs::directory_options::skip_permission_denied;
        for (fs::recursive_directory_iterator it(folder, options, ignored), end; it != end;
             it.increment(ignored)) {
            if (ignored) break;
            if (isFontFile(it->path())) files.push_back(it->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const std::string_view face : faces)
        for (const fs::path& file : files)
            if (file.stem() == face) return load(file);
    std::string names;
    for (const std::string_view face : faces) {
        if (!names.empty()) names += ", ";
        names += face;
    }
    throw Error("none of these fonts is installed: " + names +
                " (Debian has them in fonts-jura and fonts-dejavu-core)");
}

Font Font::standard() {
    return find({"Jura-Medium", "Jura-Regular", "DejaVuSans"});
}

FontMetrics Font::metrics(float size) const {
    return face_->metrics(toSize64(size));
}

const ShapedLine& Font::shape(std::string_view utf8, float size) const {
    return face_->shape(utf8, toSize64(size));
}

TextExtent Font::measure(std::string_view utf8, float size) const {
    const float lineHeight = metrics(size).lineHeight;
    TextExtent extent;
    while (true) {
        const auto end = utf8.find('\n');
        extent.width = std::max(extent.width, shape(utf8.substr(0, end), size).width);
        extent.height += lineHeight;
        if (end == std::string_view::npos) return extent;
        utf8.remove_prefix(end + 1);
    }
}

std::string Font::wrap(std::string_view utf8, float size, float width) const {
    std::string out;
    std::string line;
    std::size_t at = 0;
    while (at <= utf8.size()) {
        const std::size_t end = std::min(utf8.find_first_of(" \n", at), utf8.size());
        const std::string word(utf8.substr(at, end - at));
        std::string longer = line;
        if (!longer.empty()) longer += ' ';
        longer += word;
        if (!line.empty() && shape(longer, size).width > width) {
            out += line + '\n';
            line = word;
        } else {
            line = longer;
        }
        if (end < utf8.size() && utf8[end] == '\n') {
            out += line + '\n';
            line.clear();
        }
        at = end + 1;
    }
    return out + line;
}

GlyphBitmap Font::rasterise(std::uint32_t glyph, float size, int phase) const {
    return face_->rasterise(glyph, toSize64(size), phase);
}

std::uint64_t Font::id() const {
    return face_->id();
}

}  // namespace atlax
