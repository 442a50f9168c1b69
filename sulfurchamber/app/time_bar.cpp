#include "time_bar.hpp"

#include <wx/dcbuffer.h>
#include <wx/graphics.h>
#include <wx/settings.h>
#include <wx/sizer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "picture_grid.hpp"
#include "wx_colour.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr int lineHeight = 34;  // logical pixels, as what follows
constexpr int margin = 9;
constexpr int besidePictures = 3;
constexpr int lineBelow = 11;  // from the lower edge to the line
constexpr int laneStep = 6;
constexpr double reach = 4;

bool isDark() {
    return wxSystemSettings::GetAppearance().IsUsingDarkBackground();
}

wxColour colourOf(Mark::Kind kind) {
    switch (kind) {
        case Mark::Kind::breakage:
            return wxOf(palette::hot);
        case Mark::Kind::contact:
            return wxOf(palette::cold);
        case Mark::Kind::edit:
            break;
    }
    return wxOf(palette::amber);
}

wxString speedText(int permille) {
    if (permille >= 1000)
        return wxString::FromUTF8("\xC3\x97") + wxString::Format("%d", permille / 1000);
    return wxString::Format("1/%d", 1000 / std::max(1, permille));
}

}  // namespace

// Draws, and follows the mouse.
class TimeBar::Track final : public wxWindow {
public:
    Track(wxWindow* parent, Workbench& bench, SceneView& view)
        : wxWindow(parent, wxID_ANY), bench_(bench), view_(view) {
        setPictureHeight(FromDIP(36));
        SetBackgroundStyle(wxBG_STYLE_PAINT);
        Bind(wxEVT_PAINT, [this](wxPaintEvent&) { paint(); });
        Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
            Refresh();
            event.Skip();
        });
        Bind(wxEVT_LEFT_DOWN, &Track::press, this);
        Bind(wxEVT_MOTION, &Track::move, this);
        Bind(wxEVT_LEAVE_WINDOW, [this](wxMouseEvent&) {
            if (!dragging_) point({});
        });
        Bind(wxEVT_LEFT_UP, [this](wxMouseEvent&) { release(); });
        Bind(wxEVT_MOUSE_CAPTURE_LOST, [this](wxMouseCaptureLostEvent&) { dragging_ = false; });
    }
    // Keys stay those of the scene.
    bool AcceptsFocus() const override { return false; }

    /// Whether that is new.
    bool setPictureHeight(int height) {
        if (height == pictureHeight_) return false;
        pictureHeight_ = height;
        bitmaps_.clear();
        SetMinSize(wxSize(FromDIP(120), height + FromDIP(besidePictures + lineHeight)));
        return true;
    }
    int pictures() const { return pictures_; }

private:
    TimeBarLayout layout() const {
        const Document& document = bench_.document();
        return {document.timeline(), static_cast<double>(document.world().tickDuration()),
                static_cast<double>(GetClientSize().GetWidth() - 2 * FromDIP(margin))};
    }
    double inTrack(const wxMouseEvent& event) const { return event.GetX() - FromDIP(margin); }
    int lineY() const { return GetClientSize().GetHeight() - FromDIP(lineBelow); }

    void press(wxMouseEvent& event) {
        const TimeBarLayout now = layout();
        if (now.empty()) return;
        const double above = (lineY() - event.GetY()) / static_cast<double>(FromDIP(laneStep));
        const auto other =
            above < 0.5 ? std::nullopt
                        : now.otherAt(inTrack(event), static_cast<int>(std::lround(above)) - 1,
                                      FromDIP(static_cast<int>(reach)));
        view_.seek(other ? *other : now.momentAt(inTrack(event)));
        dragging_ = true;
        point(inTrack(event));
        if (!HasCapture()) CaptureMouse();
    }

    // Without a place the pointer is elsewhere.
    void point(std::optional<double> place) {
        pointer_ = place;
        const TimeBarLayout now = layout();
        if (place && !now.empty())
            view_.showPast(now.momentAt(*place), *place + FromDIP(margin));
        else
            view_.showPast({});
        Refresh(false);
    }

    void move(wxMouseEvent& event) {
        const TimeBarLayout now = layout();
        if (now.empty()) return;
        point(inTrack(event));
        if (dragging_) view_.seek(now.momentAt(*pointer_));
    }

    void release() {
        dragging_ = false;
        if (HasCapture()) ReleaseMouse();
        if (!GetScreenRect().Contains(wxGetMousePosition())) point({});
    }

    void paint() {
        wxAutoBufferedPaintDC dc(this);
        dc.SetBackground(wxBrush(GetParent()->GetBackgroundColour()));
        dc.Clear();
        const std::unique_ptr<wxGraphicsContext> g(wxGraphicsContext::Create(dc));
        if (!g) return;
        g->Translate(FromDIP(margin), 0);
        const TimeBarLayout now = layout();
        const int y = lineY();
        const wxColour faint = isDark() ? wxColour(255, 255, 255, 40) : wxColour(0, 0, 0, 40);
        const double width = GetClientSize().GetWidth() - 2 * FromDIP(margin);
        paintPictures(*g, now, width);
        stroke(*g, faint, 4, 0, y, width, y);
        if (now.empty()) {
            paintHint(*g, width);
            return;
        }
        const wxColour sky = wxOf(palette::sky);
        for (const auto& lane : now.lanes()) paintLane(*g, lane, y, sky);
        stroke(*g, wxColour(sky.Red(), sky.Green(), sky.Blue(), 110), 4, now.from(), y, now.to(),
               y);
        if (now.now()) stroke(*g, sky, 4, now.from(), y, *now.now(), y);
        paintMarks(*g, now, y);
        if (now.now()) {
            stroke(*g, sky, 1, *now.now(), 0, *now.now(), y);
            g->SetPen(*wxTRANSPARENT_PEN);
            g->SetBrush(wxBrush(wxOf(palette::ice)));
            const double r = FromDIP(6);
            g->DrawEllipse(*now.now() - r, y - r, 2 * r, 2 * r);
        }
        if (pointer_) paintPointed(*g, now.textAt(*pointer_, reach), width);
    }

    // What was seen, each where it was on the line; what comes after the present moment is pale.
    void paintPictures(wxGraphicsContext& g, const TimeBarLayout& now, double width) {
        const int gap = FromDIP(2);
        const int wide =
            pictureHeight_ * PastPictures::size.width / std::max(1, PastPictures::size.height);
        const int places = std::max(1, (static_cast<int>(width) + gap) / (wide + gap));
        const double step = (width + gap) / places;
        const auto strip = view_.past().strip(bench_.document(), now, width, places);
        const wxSize pixels = wxSize(wide, pictureHeight_) * GetContentScaleFactor();
        std::map<std::uint64_t, wxBitmap> used;
        pictures_ = 0;
        for (std::size_t i = 0; i < strip.size(); ++i) {
            if (strip[i] == nullptr) continue;
            const auto known = bitmaps_.find(strip[i]->serial);
            const wxBitmap bitmap =
                known != bitmaps_.end() ? known->second : toBitmap(strip[i]->image, pixels);
            used[strip[i]->serial] = bitmap;
            const double x = static_cast<double>(i) * step + (step - gap - wide) / 2;
            g.DrawBitmap(bitmap, x, 0, wide, pictureHeight_);
            ++pictures_;
        }
        bitmaps_ = std::move(used);
        if (!now.now() || pictures_ == 0) return;
        wxColour pale = GetParent()->GetBackgroundColour();
        pale.Set(pale.Red(), pale.Green(), pale.Blue(), 150);
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(pale));
        g.DrawRectangle(*now.now(), 0, width - *now.now(), pictureHeight_);
    }

    // What is under the pointer, above the line.
    void paintPointed(wxGraphicsContext& g, const std::string& words, double width) const {
        const wxString text = wxString::FromUTF8(words);
        g.SetFont(GetFont().Smaller(), wxSystemSettings::GetColour(wxSYS_COLOUR_WINDOWTEXT));
        double w = 0;
        double h = 0;
        g.GetTextExtent(text, &w, &h);
        const double x = std::clamp(*pointer_ - w / 2, 0.0, std::max(0.0, width - w));
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(GetParent()->GetBackgroundColour()));
        const double y = pictureHeight_ + FromDIP(besidePictures);
        g.DrawRectangle(x - FromDIP(3), y, w + FromDIP(6), h);
        g.DrawText(text, x, y);
    }

    void stroke(wxGraphicsContext& g, const wxColour& colour, int width, double x, double y,
                double x2, double y2) const {
        wxPen pen(colour, FromDIP(width));
        pen.SetCap(wxCAP_ROUND);
        g.SetPen(pen);
        g.StrokeLine(x, y, x2, y2);
    }

    // Another future leaves the line where it parted.
    void paintLane(wxGraphicsContext& g, const TimeBarLayout::Lane& lane, int y,
                   const wxColour& sky) const {
        const int at = y - (lane.row + 1) * FromDIP(laneStep);
        const wxColour colour(sky.Red(), sky.Green(), sky.Blue(), 150);
        const double bend = std::min<double>(lane.to - lane.from, FromDIP(5));
        stroke(g, colour, 2, lane.from, y, lane.from + bend, at);
        stroke(g, colour, 2, lane.from + bend, at, lane.to, at);
    }

    void paintMarks(wxGraphicsContext& g, const TimeBarLayout& now, int y) const {
        const double below = FromDIP(8);
        for (const auto kind : {Mark::Kind::contact, Mark::Kind::breakage, Mark::Kind::edit})
            for (const auto& spot : now.spots())
                if (spot.mark.kind == kind)
                    stroke(g, colourOf(kind), kind == Mark::Kind::contact ? 1 : 2, spot.x,
                           y + FromDIP(4), spot.x, y + below);
    }

    void paintHint(wxGraphicsContext& g, double width) const {
        const wxString hint = wxTr("Time: what runs is recorded here");
        g.SetFont(GetFont(), wxSystemSettings::GetColour(wxSYS_COLOUR_GRAYTEXT));
        double w = 0;
        double h = 0;
        g.GetTextExtent(hint, &w, &h);
        if (w < width) g.DrawText(hint, 0, (lineY() - h) / 2);
    }

    Workbench& bench_;
    SceneView& view_;
    bool dragging_ = false;
    std::optional<double> pointer_;  // pixels of the track
    int pictureHeight_ = 0;
    int pictures_ = 0;                           // that the last painting has shown
    std::map<std::uint64_t, wxBitmap> bitmaps_;  // of these, by their serials
};

TimeBar::TimeBar(wxWindow* parent, Workbench& bench, SceneView& view,
                 std::function<void(wxWindow&)> chooseSpeed)
    : wxPanel(parent), bench_(bench), view_(view) {
    track_ = new Track(this, bench, view);
    speed_ = new wxButton(this, wxID_ANY, "1/1000", wxDefaultPosition, wxDefaultSize,
                          wxBU_EXACTFIT | wxBORDER_NONE);
    speed_->SetMinSize(speed_->GetBestSize());
    speed_->SetToolTip(
        wxTr("How fast time runs: a thousandth to four times  (Ctrl+Up, Ctrl+Down)"));
    speed_->Bind(wxEVT_BUTTON, [this, chooseSpeed](wxCommandEvent&) { chooseSpeed(*speed_); });
    auto* sizer = new wxBoxSizer(wxHORIZONTAL);
    sizer->Add(track_, wxSizerFlags(1).Expand());
    sizer->Add(speed_, wxSizerFlags(0).CentreVertical().Border(wxRIGHT, FromDIP(4)));
    SetSizer(sizer);
    refresh();
}

void TimeBar::refresh() {
    const wxString text = speedText(view_.speedPermille());
    if (speed_->GetLabel() != text) speed_->SetLabel(text);
    track_->Refresh(false);
}

bool TimeBar::setPictureHeight(int height) {
    return track_->setPictureHeight(height);
}

int TimeBar::pictures() const {
    return track_->pictures();
}

wxRect TimeBar::trackOnScreen() const {
    wxRect rect = track_->GetScreenRect();
    return rect.Deflate(FromDIP(margin), 0);
}

}  // namespace sulfurchamber
