#include "plot_panel.hpp"

#include <wx/bitmap.h>
#include <wx/button.h>
#include <wx/dcbuffer.h>
#include <wx/dcmemory.h>
#include <wx/settings.h>
#include <wx/sizer.h>

#include <algorithm>
#include <array>
#include <atlax/backend.hpp>
#include <atlax/files.hpp>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "small_button.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr int leastHeight = 84;  // logical pixels, as what follows
constexpr int axisWidth = 50;
constexpr int timeHeight = 18;
constexpr int topMargin = 8;
constexpr std::int64_t fitEveryNs = 1'000'000'000;  // while it plays
constexpr std::size_t mostTold = 7;                 // lines of the legend

struct Ink {
    wxColour paper, grid, text, now;
    std::array<wxColour, 6> series;
};

Ink inkOf(bool dark) {
    if (dark)
        return {wxColour(11, 16, 38),
                wxColour(255, 255, 255, 26),
                wxColour(200, 215, 235),
                wxColour(232, 244, 255, 120),
                {wxColour(111, 168, 220), wxColour(255, 179, 71), wxColour(67, 217, 232),
                 wxColour(255, 94, 87), wxColour(139, 209, 124), wxColour(199, 146, 234)}};
    return {*wxWHITE,
            wxColour(0, 0, 0, 28),
            wxColour(40, 50, 60),
            wxColour(0, 0, 0, 110),
            {wxColour(31, 100, 170), wxColour(200, 110, 0), wxColour(0, 130, 150),
             wxColour(200, 40, 35), wxColour(50, 130, 40), wxColour(120, 60, 170)}};
}

bool panelsAreDark() {
    return wxSystemSettings::GetAppearance().IsUsingDarkBackground();
}

}  // namespace

// Draws, and follows the mouse.
class PlotPanel::Diagram final : public wxWindow {
public:
    Diagram(wxWindow* parent, const Workbench& bench, PlotRange& range, const FitKind& fit)
        : wxWindow(parent, wxID_ANY), bench_(bench), range_(range), fit_(fit) {
        SetMinSize(wxSize(FromDIP(200), FromDIP(leastHeight)));
        SetBackgroundStyle(wxBG_STYLE_PAINT);
        Bind(wxEVT_PAINT, [this](wxPaintEvent&) {
            wxAutoBufferedPaintDC dc(this);
            const std::unique_ptr<wxGraphicsContext> g(wxGraphicsContext::Create(dc));
            const wxSize size = GetClientSize();
            if (g && size.x > 0 && size.y > 0) paint(*g, size, inkOf(panelsAreDark()));
        });
        Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
            Refresh(false);
            event.Skip();
        });
        bindMouse();
    }
    // Keys stay those of the scene.
    bool AcceptsFocus() const override { return false; }

    // For a picture, which has another size and no pointer.
    void paintAlone(wxGraphicsContext& g, const wxSize& size, const Ink& ink) {
        const auto pointer = std::exchange(pointer_, std::nullopt);
        paint(g, size, ink);
        pointer_ = pointer;
    }

    void paint(wxGraphicsContext& g, const wxSize& size, const Ink& ink) {
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(ink.paper));
        g.DrawRectangle(0, 0, size.x, size.y);
        g.SetFont(GetFont().Smaller(), ink.text);
        const PlotScale time = timeScale(size);
        const auto units = unitsOf(series());
        paintTimes(g, size, time, ink);
        for (std::size_t i = 0; i < units.size() && i < 2; ++i)
            paintValues(g, size, units[i], i == 0, ink);
        g.Clip(time.from, 0, time.to - time.from, size.y);
        for (std::size_t i = 0; i < series().size(); ++i)
            paintSeries(g, size, time, i, ink.series[i % ink.series.size()]);
        paintNow(g, size, time, ink);
        g.ResetClip();
        paintLegend(g, size, time, ink);
    }

    PlotScale timeScale(const wxSize& size) const {
        const auto [low, high] = range_.shown(series());
        const bool two = unitsOf(series()).size() > 1;
        return {low, high, static_cast<double>(FromDIP(axisWidth)),
                static_cast<double>(size.x - FromDIP(two ? axisWidth : 10))};
    }
    std::optional<double> cursor() const {
        if (!pointer_) return std::nullopt;
        return timeScale(GetClientSize()).value(*pointer_);
    }
    // Fits cost; while time runs they follow once a second.
    const std::vector<std::optional<Fitted>>& fits() {
        const auto shown = range_.shown(series());
        std::size_t samples = 0;
        for (const Series& one : series()) samples += one.samples.size();
        const Key key{fit_, shown, samples, series().size()};
        const std::int64_t now = atlax::monotonicNs();
        const bool same = key == key_;
        if (same || (key.fit == key_.fit && key.count == key_.count &&
                     bench_.document().playing() && now < nextFitNs_))
            return fits_;
        key_ = key;
        nextFitNs_ = now + fitEveryNs;
        fits_.clear();
        for (const Series& one : series()) fits_.push_back(fitted(one, shown, fit_));
        return fits_;
    }
    void zoom(double x, int notches) {
        range_.zoom(series(), std::pow(0.8, notches), timeScale(GetClientSize()).value(x));
        Refresh(false);
    }

private:
    struct Key {
        FitKind fit = FitKind::none;
        std::pair<double, double> shown;
        std::size_t samples = 0;
        std::size_t count = 0;
        bool operator==(const Key&) const = default;
    };

    const std::vector<Series>& series() const { return bench_.measurements().series(); }

    void bindMouse() {
        Bind(wxEVT_MOTION, [this](wxMouseEvent& event) {
            pointer_ = event.GetX();
            Refresh(false);
        });
        Bind(wxEVT_LEAVE_WINDOW, [this](wxMouseEvent&) {
            pointer_.reset();
            Refresh(false);
        });
        Bind(wxEVT_LEFT_DOWN, [this](wxMouseEvent& event) {
            dragFrom_ = event.GetX();
            if (!HasCapture()) CaptureMouse();
        });
        Bind(wxEVT_LEFT_UP, [this](wxMouseEvent& event) { release(event.GetX()); });
        Bind(wxEVT_LEFT_DCLICK, [this](wxMouseEvent&) {
            range_.showAll();
            Refresh(false);
        });
        Bind(wxEVT_MOUSE_CAPTURE_LOST, [this](wxMouseCaptureLostEvent&) { dragFrom_.reset(); });
        Bind(wxEVT_MOUSEWHEEL, [this](wxMouseEvent& event) {
            zoom(event.GetX(), event.GetWheelRotation() > 0 ? 1 : -1);
        });
    }

    void release(double x) {
        if (HasCapture()) ReleaseMouse();
        if (!dragFrom_) return;
        const PlotScale time = timeScale(GetClientSize());
        if (std::abs(x - *dragFrom_) > FromDIP(6)) {
            const auto [first, last] = PlotRange::whole(series());
            range_.show(std::clamp(time.value(*dragFrom_), first, last),
                        std::clamp(time.value(x), first, last));
        }
        dragFrom_.reset();
        Refresh(false);
    }

    PlotScale valueScale(const wxSize& size, std::string_view unit) const {
        const auto [low, high] = valuesOf(series(), unit, range_.shown(series()));
        return {low, high, static_cast<double>(size.y - FromDIP(timeHeight)),
                static_cast<double>(FromDIP(topMargin))};
    }

    void paintTimes(wxGraphicsContext& g, const wxSize& size, const PlotScale& time,
                    const Ink& ink) const {
        const int bottom = size.y - FromDIP(timeHeight);
        const auto numbers =
            roundNumbers(time.low, time.high, static_cast<int>(time.to - time.from) / FromDIP(70));
        const double step = numbers.size() > 1 ? numbers[1] - numbers[0] : 1;
        for (const double n : numbers) {
            line(g, ink.grid, 1, time.pixel(n), FromDIP(topMargin), time.pixel(n), bottom);
            text(g, numberText(n, step) + " s", time.pixel(n), bottom + FromDIP(2), 0.5, size.x);
        }
    }

    // The first unit has its axis at the left, the second at the right.
    void paintValues(wxGraphicsContext& g, const wxSize& size, std::string_view unit, bool left,
                     const Ink& ink) const {
        const PlotScale values = valueScale(size, unit);
        const double right = timeScale(size).to;
        const auto numbers = roundNumbers(values.low, values.high,
                                          static_cast<int>(values.from - values.to) / FromDIP(26));
        const double step = numbers.size() > 1 ? numbers[1] - numbers[0] : 1;
        for (const double n : numbers) {
            const double y = values.pixel(n);
            if (left) line(g, ink.grid, 1, FromDIP(axisWidth), y, right, y);
            const double x = left ? FromDIP(axisWidth - 5) : right + FromDIP(5);
            const bool top = n == numbers.back();
            text(g, numberText(n, step) + (top ? " " + std::string(unit) : ""), x, y - FromDIP(7),
                 left ? 1 : 0, size.x);
        }
    }

    void paintSeries(wxGraphicsContext& g, const wxSize& size, const PlotScale& time,
                     std::size_t place, const wxColour& colour) {
        const Series& one = series()[place];
        const PlotScale values = valueScale(size, one.quantity->unit);
        // One beyond each end, so that lines reach the edge.
        const double margin = (time.high - time.low) * 0.01;
        const auto points =
            curve(between(one.samples, time.low - margin, time.high + margin), time, values);
        wxGraphicsPath path = g.CreatePath();
        for (std::size_t i = 0; i < points.size(); ++i)
            i == 0 ? path.MoveToPoint(points[i].first, points[i].second)
                   : path.AddLineToPoint(points[i].first, points[i].second);
        g.SetPen(wxPen(colour, FromDIP(2)));
        g.StrokePath(path);
        if (place < fits().size() && fits()[place])
            paintFit(g, *fits()[place], time, values, colour);
        const auto at = cursor() ? nearest(one.samples, *cursor()) : std::nullopt;
        if (!at) return;
        const double r = FromDIP(4);
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(colour));
        g.DrawEllipse(time.pixel(at->time) - r, values.pixel(at->value) - r, 2 * r, 2 * r);
    }

    void paintFit(wxGraphicsContext& g, const Fitted& fit, const PlotScale& time,
                  const PlotScale& values, const wxColour& colour) const {
        wxGraphicsPath path = g.CreatePath();
        const int step = std::max(1, FromDIP(2));
        for (int x = static_cast<int>(time.from); x <= static_cast<int>(time.to); x += step) {
            const double y = values.pixel(fit.at(time.value(x)));
            x == static_cast<int>(time.from) ? path.MoveToPoint(x, y) : path.AddLineToPoint(x, y);
        }
        const wxColour lighter = colour.ChangeLightness(130);
        g.SetPen(wxPen(lighter, FromDIP(1), wxPENSTYLE_SHORT_DASH));
        g.StrokePath(path);
    }

    void paintNow(wxGraphicsContext& g, const wxSize& size, const PlotScale& time,
                  const Ink& ink) const {
        const int bottom = size.y - FromDIP(timeHeight);
        const double now = time.pixel(bench_.document().world().time());
        line(g, ink.now, 1, now, FromDIP(topMargin), now, bottom);
        if (pointer_) line(g, ink.text, 1, *pointer_, FromDIP(topMargin), *pointer_, bottom);
        if (!dragFrom_ || !pointer_) return;
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(wxColour(111, 168, 220, 60)));
        g.DrawRectangle(std::min(*dragFrom_, *pointer_), FromDIP(topMargin),
                        std::abs(*pointer_ - *dragFrom_), bottom - FromDIP(topMargin));
    }

    // What each curve is, with its value under the cursor, or now, over a third of the diagram.
    void paintLegend(wxGraphicsContext& g, const wxSize& size, const PlotScale& time,
                     const Ink& ink) {
        const double at = cursor().value_or(bench_.document().world().time());
        double y = FromDIP(topMargin + 2);
        const double x = time.from + FromDIP(8);
        bool any = false;
        std::vector<std::string> values(series().size());
        std::vector<std::string> fitted(series().size());
        for (std::size_t i = 0; i < series().size(); ++i) {
            const Series& one = series()[i];
            if (const auto sample = nearest(one.samples, at)) {
                std::array<char, 32> value{};
                std::snprintf(value.data(), value.size(), ": %.4g ", sample->value);
                values[i] = value.data() + std::string(one.quantity->unit);
                any = true;
            }
            if (i < fits().size() && fits()[i]) fitted[i] = fits()[i]->text;
        }
        g.SetFont(GetFont().Smaller(), ink.text);
        double width = 0;
        double height = 0;
        const auto widthOf = [&](const std::string& words) {
            g.GetTextExtent(wxString::FromUTF8(words), &width, &height);
            return width;
        };
        widthOf("+1");
        const double room = size.y - FromDIP(timeHeight) - y;
        const auto lines = static_cast<std::size_t>(std::max(1.0, std::floor(room / height)));
        for (const LegendLine& line : legendLines(series(), values, fitted, size.x / 3.0,
                                                  std::min(lines, mostTold), widthOf)) {
            const wxColour& colour =
                line.series ? ink.series[*line.series % ink.series.size()] : ink.text;
            g.SetFont(GetFont().Smaller(), colour);
            y += legendLine(g, line.text, x, y, ink);
        }
        g.SetFont(GetFont().Smaller(), ink.text);
        if (series().empty())
            legendLine(g, tr("Choose quantities to measure"), x, y, ink);
        else if (!any)
            legendLine(g, tr("Press Space: a sample is taken in each tick"), x, y, ink);
    }

    double legendLine(wxGraphicsContext& g, const std::string& words, double x, double y,
                      const Ink& ink) const {
        const wxString text = wxString::FromUTF8(words);
        double w = 0;
        double h = 0;
        g.GetTextExtent(text, &w, &h);
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(wxColour(ink.paper.Red(), ink.paper.Green(), ink.paper.Blue(), 190)));
        g.DrawRectangle(x - FromDIP(3), y, w + FromDIP(6), h);
        g.DrawText(text, x, y);
        return h;
    }

    static void line(wxGraphicsContext& g, const wxColour& colour, int width, double x, double y,
                     double x2, double y2) {
        g.SetPen(wxPen(colour, width));
        g.StrokeLine(x, y, x2, y2);
    }

    // `align` is the share of the text that lies left of x. It stays within `width`.
    static void text(wxGraphicsContext& g, const std::string& words, double x, double y,
                     double align, double width) {
        const wxString label = wxString::FromUTF8(words);
        double w = 0;
        double h = 0;
        g.GetTextExtent(label, &w, &h);
        g.DrawText(label, std::clamp(x - align * w, 0.0, std::max(0.0, width - w)), y);
    }

    const Workbench& bench_;
    PlotRange& range_;
    const FitKind& fit_;
    std::optional<double> pointer_;
    std::optional<double> dragFrom_;
    Key key_;
    std::int64_t nextFitNs_ = 0;
    std::vector<std::optional<Fitted>> fits_;
};

PlotPanel::PlotPanel(wxWindow* parent, Workbench& bench,
                     std::function<void(const wxString&, wxWindow&)> choose)
    : wxPanel(parent), bench_(bench) {
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    for (const char* name : {"Quantities", "Fit", "Export"}) {
        auto* button = smallButton(this, wxTr(name) + wxString::FromUTF8(" \xE2\x96\xBE"));
        button->Bind(wxEVT_BUTTON,
                     [choose, name, button](wxCommandEvent&) { choose(wxString(name), *button); });
        row->Add(button, wxSizerFlags(0).Border(wxRIGHT, FromDIP(4)));
    }
    diagram_ = new Diagram(this, bench, range_, fit_);
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(row, wxSizerFlags(0).Border(wxALL, FromDIP(3)));
    sizer->Add(diagram_, wxSizerFlags(1).Expand());
    SetSizer(sizer);
}

void PlotPanel::refresh() {
    if (IsShown()) diagram_->Refresh(false);
}

void PlotPanel::setFit(FitKind fit) {
    fit_ = fit;
    diagram_->Refresh(false);
}

void PlotPanel::showAll() {
    range_.showAll();
    diagram_->Refresh(false);
}

void PlotPanel::savePicture(const std::filesystem::path& file) {
    const wxSize size(1200, 500);
    wxBitmap bitmap(size);
    {
        wxMemoryDC dc(bitmap);
        const std::unique_ptr<wxGraphicsContext> g(wxGraphicsContext::Create(dc));
        if (!g) throw std::runtime_error("the diagram cannot be drawn as a picture");
        diagram_->paintAlone(*g, size, inkOf(false));  // for paper
    }
    if (!bitmap.SaveFile(wxString::FromUTF8(file.string()), wxBITMAP_TYPE_PNG))
        throw std::runtime_error(tr("cannot write {}", {file.string()}));
}

void PlotPanel::saveTable(const std::filesystem::path& file) const {
    atlax::writeFileAtomic(file, csv(bench_.measurements().series()));
}

std::pair<double, double> PlotPanel::shown() const {
    return range_.shown(bench_.measurements().series());
}

std::optional<double> PlotPanel::fitValue() const {
    const auto& fits = diagram_->fits();
    if (fits.empty() || !fits[0]) return std::nullopt;
    if (fits[0]->line) return fits[0]->line->slope;
    return fits[0]->sine ? fits[0]->sine->frequency : fits[0]->mean;
}

std::optional<double> PlotPanel::cursorValue() const {
    const auto& series = bench_.measurements().series();
    if (series.empty() || !diagram_->cursor()) return std::nullopt;
    const auto sample = nearest(series[0].samples, *diagram_->cursor());
    return sample ? std::optional(sample->value) : std::nullopt;
}

wxRect PlotPanel::plotOnScreen() const {
    const PlotScale time = diagram_->timeScale(diagram_->GetClientSize());
    wxRect rect = diagram_->GetScreenRect();
    rect.x += static_cast<int>(time.from);
    rect.width = static_cast<int>(time.to - time.from);
    return rect;
}

void PlotPanel::turnWheel(double share, int notches) {
    const PlotScale time = diagram_->timeScale(diagram_->GetClientSize());
    diagram_->zoom(time.from + share * (time.to - time.from), notches);
}

}  // namespace sulfurchamber
