#include "picture_grid.hpp"

#include <wx/arrstr.h>
#include <wx/dcbuffer.h>
#include <wx/image.h>
#include <wx/settings.h>

#include <algorithm>

#include "wx_colour.hpp"

namespace sulfurchamber {
namespace {

constexpr int dragPixels = 6;  // from which on a press is a drag

// The lines of a text between whose words there is a break where a line would be too wide.
std::vector<wxString> brokenIntoLines(const wxDC& dc, const wxString& text, int width) {
    std::vector<wxString> lines;
    for (const wxString& word : wxSplit(text, ' ', '\0')) {
        const wxString longer = lines.empty() ? word : lines.back() + ' ' + word;
        if (lines.empty() || dc.GetTextExtent(longer).GetWidth() > width)
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    return lines;
}

bool fitsIn(const wxDC& dc, const std::vector<wxString>& lines, int width, int most) {
    return static_cast<int>(lines.size()) <= most &&
           std::all_of(lines.begin(), lines.end(), [&](const wxString& line) {
               return dc.GetTextExtent(line).GetWidth() <= width;
           });
}

}  // namespace

wxBitmap toBitmap(const atlax::Image& picture, const wxSize& size) {
    wxImage image(picture.width(), picture.height());
    const auto bytes = picture.bytes();
    unsigned char* to = image.GetData();
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) *to++ = bytes[i + c];
    return wxBitmap(image.Scale(std::max(1, size.GetWidth()), std::max(1, size.GetHeight()),
                                wxIMAGE_QUALITY_HIGH));
}

PictureGrid::PictureGrid(wxWindow* parent, Thumbnails& thumbnails)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                       wxVSCROLL | wxWANTS_CHARS | wxBORDER_NONE),
      thumbnails_(thumbnails) {
    SetBackgroundStyle(wxBG_STYLE_PAINT);
    SetScrollRate(0, FromDIP(12));
    Bind(wxEVT_PAINT, &PictureGrid::paint, this);
    Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
        event.Skip();
        if (GetClientSize().GetWidth() != laidOutWidth_) layOut();
    });
    Bind(wxEVT_LEFT_DOWN, &PictureGrid::press, this);
    Bind(wxEVT_LEFT_UP, &PictureGrid::release, this);
    Bind(wxEVT_MOTION, &PictureGrid::hover, this);
    Bind(wxEVT_LEAVE_WINDOW, [this](wxMouseEvent&) {
        hovered_.reset();
        Refresh();
    });
    Bind(wxEVT_LEFT_DCLICK, [this](wxMouseEvent&) {
        if (chosen_ && onActivated) onActivated(*chosen_);
    });
    Bind(wxEVT_MOUSE_CAPTURE_LOST, [this](wxMouseCaptureLostEvent&) { pressed_.reset(); });
    Bind(wxEVT_KEY_DOWN, &PictureGrid::key, this);
    Bind(wxEVT_SET_FOCUS, [this](wxFocusEvent& event) {
        Refresh();
        event.Skip();
    });
    Bind(wxEVT_KILL_FOCUS, [this](wxFocusEvent& event) {
        Refresh();
        event.Skip();
    });
}

void PictureGrid::show(std::vector<Item> items) {
    const std::string before = chosen_ && *chosen_ < items_.size() ? items_[*chosen_].name : "";
    items_ = std::move(items);
    chosen_.reset();
    hovered_.reset();
    for (std::size_t i = 0; i < items_.size(); ++i)
        if (!before.empty() && items_[i].name == before) chosen_ = i;
    layOut();
}

void PictureGrid::layOut() {
    std::vector<std::string> groups;
    for (const Item& item : items_) groups.push_back(item.group);
    laidOutWidth_ = GetClientSize().GetWidth();
    PictureGridLayout::Sizes sizes;
    sizes.width = std::max(laidOutWidth_, 80);
    sizes.pictureWidth = FromDIP(pictureWidth_);
    sizes.pictureRatio = thumbnails_.size().height * 100 / thumbnails_.size().width;
    sizes.label = labelHeight();
    sizes.heading = GetTextExtent("Ag").GetHeight() + FromDIP(10);
    sizes.gap = FromDIP(6);
    layout_ = PictureGridLayout::of(groups, sizes);
    SetVirtualSize(-1, layout_.height);
    Refresh();
}

const wxBitmap* PictureGrid::bitmapOf(const std::filesystem::path& file, const wxSize& size) {
    const atlax::Image* picture = thumbnails_.of(file);
    if (picture == nullptr) return nullptr;
    Shown& shown = bitmaps_[file.string()];
    if (shown.picture != picture || !shown.bitmap.IsOk() || shown.bitmap.GetSize() != size)
        shown = {picture, toBitmap(*picture, size)};
    return &shown.bitmap;
}

void PictureGrid::refreshPictures() {
    if (revision_ == thumbnails_.revision()) return;
    revision_ = thumbnails_.revision();
    bitmaps_.clear();
    Refresh();
}

void PictureGrid::paint(wxPaintEvent&) {
    wxAutoBufferedPaintDC dc(this);
    DoPrepareDC(dc);
    dc.SetBackground(wxBrush(wxSystemSettings::GetColour(wxSYS_COLOUR_WINDOW)));
    dc.Clear();
    const wxColour text = wxSystemSettings::GetColour(wxSYS_COLOUR_WINDOWTEXT);
    dc.SetTextForeground(text);
    if (items_.empty()) {
        dc.SetFont(GetFont());
        dc.DrawLabel(emptyText_, wxRect(GetClientSize()), wxALIGN_CENTRE);
        return;
    }
    dc.SetFont(GetFont().Bold());
    for (const auto& heading : layout_.headings)
        dc.DrawText(wxString::FromUTF8(heading.text), heading.place.x,
                    heading.place.y + FromDIP(4));
    dc.SetFont(GetFont());
    const int top = CalcUnscrolledPosition(wxPoint(0, 0)).y;
    const int bottom = top + GetClientSize().GetHeight();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const GridRect& cell = layout_.cells[i];
        // Only what is seen is asked for: what is seen first is drawn first.
        if (cell.y + cell.height >= top && cell.y <= bottom) paintCell(dc, i);
    }
}

void PictureGrid::paintCell(wxDC& dc, std::size_t item) {
    const GridRect& cell = layout_.cells[item];
    const wxSize size(cell.width, cell.height - labelHeight());
    const bool chosen = chosen_ == item;
    if (const wxBitmap* bitmap = bitmapOf(items_[item].file, size)) {
        dc.DrawBitmap(*bitmap, cell.x, cell.y);
    } else {
        dc.SetPen(*wxTRANSPARENT_PEN);
        dc.SetBrush(wxBrush(wxOf(palette::above)));
        dc.DrawRectangle(cell.x, cell.y, size.GetWidth(), size.GetHeight());
    }
    if (chosen || hovered_ == item) {
        const wxColour mark =
            chosen ? wxSystemSettings::GetColour(wxSYS_COLOUR_HIGHLIGHT) : wxOf(palette::sky);
        dc.SetPen(wxPen(mark, chosen ? FromDIP(3) : FromDIP(1)));
        dc.SetBrush(*wxTRANSPARENT_BRUSH);
        dc.DrawRectangle(cell.x, cell.y, size.GetWidth(), size.GetHeight());
    }
    if (items_[item].marked) {
        dc.SetPen(*wxTRANSPARENT_PEN);
        dc.SetBrush(wxBrush(wxOf(palette::amber)));
        dc.DrawCircle(cell.x + size.GetWidth() - FromDIP(8), cell.y + FromDIP(8), FromDIP(4));
    }
    paintName(dc, items_[item], cell);
}

// A long name is written smaller before it is cut.
void PictureGrid::paintName(wxDC& dc, const Item& item, const GridRect& cell) {
    const wxString whole = wxString::FromUTF8(item.label.empty() ? item.name : item.label);
    std::vector<wxString> lines = brokenIntoLines(dc, whole, cell.width);
    wxFont font = GetFont();
    for (int smaller = 0; smaller < 3 && !fitsIn(dc, lines, cell.width, nameLines_); ++smaller) {
        font.MakeSmaller();
        dc.SetFont(font);
        lines = brokenIntoLines(dc, whole, cell.width);
    }
    while (static_cast<int>(lines.size()) > nameLines_) {
        const wxString last = lines.back();
        lines.pop_back();
        lines.back() += ' ' + last;
    }
    int y = cell.y + cell.height - labelHeight() + FromDIP(2);
    if (lines.size() == 1 && nameLines_ == 1)  // in the middle of its line, also where it is small
        y += (GetCharHeight() - dc.GetCharHeight()) / 2;
    for (const wxString& line : lines) {
        const wxString shown = wxControl::Ellipsize(line, dc, wxELLIPSIZE_END, cell.width);
        dc.DrawText(shown, cell.x + (cell.width - dc.GetTextExtent(shown).GetWidth()) / 2, y);
        y += dc.GetCharHeight();
    }
    dc.SetFont(GetFont());
}

int PictureGrid::labelHeight() const {
    return nameLines_ * GetCharHeight() + FromDIP(4);
}

void PictureGrid::setTiles(int pictureWidth, int nameLines) {
    pictureWidth_ = pictureWidth;
    nameLines_ = nameLines;
    layOut();
}

void PictureGrid::choose(std::optional<std::size_t> item) {
    if (chosen_ == item) return;
    chosen_ = item;
    if (item) showItem(*item);
    Refresh();
}

void PictureGrid::showItem(std::size_t item) {
    const GridRect& cell = layout_.cells[item];
    int unit = 1;
    GetScrollPixelsPerUnit(nullptr, &unit);
    if (unit < 1) return;
    const int top = CalcUnscrolledPosition(wxPoint(0, 0)).y;
    const int height = GetClientSize().GetHeight();
    if (cell.y < top) Scroll(-1, cell.y / unit);
    if (cell.y + cell.height > top + height)
        Scroll(-1, (cell.y + cell.height - height + unit - 1) / unit);
}

wxRect PictureGrid::onScreen(std::size_t item) const {
    const GridRect& cell = layout_.cells.at(item);
    const wxPoint at = ClientToScreen(CalcScrolledPosition(wxPoint(cell.x, cell.y)));
    return {at, wxSize(cell.width, cell.height)};
}

void PictureGrid::press(wxMouseEvent& event) {
    SetFocus();
    const wxPoint at = CalcUnscrolledPosition(event.GetPosition());
    const auto item = layout_.at(at.x, at.y);
    choose(item);
    if (!item) return;
    pressed_ = event.GetPosition();
    if (!HasCapture()) CaptureMouse();
    if (onChosen) onChosen(*item);
}

void PictureGrid::release(wxMouseEvent& event) {
    if (HasCapture()) ReleaseMouse();
    if (!pressed_ || !chosen_) return;
    const wxPoint by = event.GetPosition() - *pressed_;
    pressed_.reset();
    SetCursor(wxNullCursor);
    const bool outside = !wxRect(GetClientSize()).Contains(event.GetPosition());
    if (outside && std::max(std::abs(by.x), std::abs(by.y)) > dragPixels && onDragged)
        onDragged(*chosen_, ClientToScreen(event.GetPosition()));
}

void PictureGrid::hover(wxMouseEvent& event) {
    if (pressed_) {
        const bool outside = !wxRect(GetClientSize()).Contains(event.GetPosition());
        SetCursor(outside ? wxCursor(wxCURSOR_HAND) : wxNullCursor);
        return;
    }
    const wxPoint at = CalcUnscrolledPosition(event.GetPosition());
    const auto item = layout_.at(at.x, at.y);
    if (item == hovered_) return;
    hovered_ = item;
    if (item)
        SetToolTip(wxString::FromUTF8(items_[*item].help));
    else
        UnsetToolTip();
    Refresh();
}

void PictureGrid::key(wxKeyEvent& event) {
    int columns = 0, rows = 0;
    switch (event.GetKeyCode()) {
        case WXK_LEFT:
            columns = -1;
            break;
        case WXK_RIGHT:
            columns = 1;
            break;
        case WXK_UP:
            rows = -1;
            break;
        case WXK_DOWN:
            rows = 1;
            break;
        case WXK_RETURN:
        case WXK_NUMPAD_ENTER:
            if (chosen_ && onActivated) onActivated(*chosen_);
            return;
        default:
            event.Skip();
            return;
    }
    if (items_.empty()) return;
    choose(chosen_ ? layout_.moved(*chosen_, columns, rows) : 0);
    if (onChosen) onChosen(*chosen_);
}

}  // namespace sulfurchamber
