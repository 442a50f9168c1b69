#include "table4_window.hpp"

#include <wx/bitmap.h>
#include <wx/dcbuffer.h>
#include <wx/dcmemory.h>
#include <wx/graphics.h>
#include <wx/settings.h>
#include <wx/sizer.h>

#include <algorithm>
#include <array>
#include <atlax/files.hpp>
#include <memory>
#include <stdexcept>

#include "../view/plot_layout.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr int columnEdges = 16;  // of a column beside its texts, in pixels of a usual screen

struct Curve {
    wxString name;
    wxColour colour;
    bool ours = false;
    std::vector<std::pair<double, double>> points;  // boxes a second, per cent
};

std::vector<Curve> curvesOf(const std::vector<Table4Cell>& cells, bool dark) {
    const std::array<wxColour, 3> greys =
        dark ? std::array{wxColour(150, 160, 180), wxColour(110, 125, 150), wxColour(200, 208, 220)}
             : std::array{wxColour(150, 150, 150), wxColour(95, 95, 95), wxColour(30, 30, 30)};
    std::vector<Curve> curves;
    const auto rates = table4Rates();
    for (const Table4Machine& machine : table4Machines()) {
        Curve curve{
            wxString::FromUTF8(machine.name), greys[curves.size() % greys.size()], false, {}};
        for (std::size_t i = 0; i < rates.size(); ++i)
            curve.points.emplace_back(rates[i], machine.percent[i]);
        curves.push_back(std::move(curve));
    }
    Curve ours{
        wxTr("This machine"), dark ? wxColour(255, 179, 71) : wxColour(200, 110, 0), true, {}};
    for (const Table4Cell& cell : cells) ours.points.emplace_back(cell.rate, cell.percent);
    curves.push_back(std::move(ours));
    return curves;
}

wxString percentOf(double value) {
    return wxString::Format(value < 10 ? "%.2f %%" : "%.0f %%", value);
}

}  // namespace

// Boxes a second to the right, the share of a core upwards.
class Table4Window::Diagram final : public wxWindow {
public:
    Diagram(wxWindow* parent, const Table4& table) : wxWindow(parent, wxID_ANY), table_(table) {
        SetMinSize(FromDIP(wxSize(420, 240)));
        SetBackgroundStyle(wxBG_STYLE_PAINT);
        Bind(wxEVT_PAINT, [this](wxPaintEvent&) {
            wxAutoBufferedPaintDC dc(this);
            const std::unique_ptr<wxGraphicsContext> g(wxGraphicsContext::Create(dc));
            const bool dark = wxSystemSettings::GetAppearance().IsUsingDarkBackground();
            if (g) paint(*g, GetClientSize(), dark);
        });
        Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
            Refresh(false);
            event.Skip();
        });
    }

    void paint(wxGraphicsContext& g, const wxSize& size, bool dark) {
        const wxColour paper = dark ? wxColour(11, 16, 38) : *wxWHITE;
        const wxColour ink = dark ? wxColour(210, 222, 240) : wxColour(40, 50, 60);
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(paper));
        g.DrawRectangle(0, 0, size.x, size.y);
        const PlotScale x{0, 210, static_cast<double>(FromDIP(48)),
                          static_cast<double>(size.x - FromDIP(14))};
        const PlotScale y{0, 105, static_cast<double>(size.y - FromDIP(38)),
                          static_cast<double>(FromDIP(12))};
        g.SetFont(GetFont().Smaller(), ink);
        paintAxes(g, x, y, wxColour(ink.Red(), ink.Green(), ink.Blue(), 40));
        double legend = FromDIP(14);
        for (const Curve& curve : curvesOf(table_.cells(), dark)) {
            paintCurve(g, x, y, curve);
            g.SetFont(GetFont().Smaller(), curve.colour);
            g.DrawText(curve.ours ? curve.name : wxTr("Paper: {}", {curve.name.utf8_string()}),
                       x.from + FromDIP(12), legend);
            legend += FromDIP(16);
        }
    }

private:
    void paintAxes(wxGraphicsContext& g, const PlotScale& x, const PlotScale& y,
                   const wxColour& grid) const {
        const auto put = [&](const wxString& words, double at, double top, double align) {
            double w = 0, h = 0;
            g.GetTextExtent(words, &w, &h);
            g.DrawText(words, at - align * w, top - h / 2);
        };
        for (const double n : roundNumbers(0, 100, 5)) {
            g.SetPen(wxPen(grid, 1));
            g.StrokeLine(x.from, y.pixel(n), x.to, y.pixel(n));
            put(wxString::Format("%.0f %%", n), x.from - FromDIP(5), y.pixel(n), 1);
        }
        for (const int rate : table4Rates()) {
            g.SetPen(wxPen(grid, 1));
            g.StrokeLine(x.pixel(rate), y.from, x.pixel(rate), y.to);
            put(wxString::Format("%d", rate), x.pixel(rate), y.from + FromDIP(10), 0.5);
        }
        put(wxTr("boxes a second"), (x.from + x.to) / 2, y.from + FromDIP(26), 0.5);
    }

    void paintCurve(wxGraphicsContext& g, const PlotScale& x, const PlotScale& y,
                    const Curve& curve) const {
        g.SetPen(wxPen(curve.colour, FromDIP(curve.ours ? 3 : 2),
                       curve.ours ? wxPENSTYLE_SOLID : wxPENSTYLE_SHORT_DASH));
        wxGraphicsPath path = g.CreatePath();
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const double px = x.pixel(curve.points[i].first);
            const double py = y.pixel(std::min(curve.points[i].second, y.high));
            i == 0 ? path.MoveToPoint(px, py) : path.AddLineToPoint(px, py);
        }
        g.StrokePath(path);
        g.SetPen(*wxTRANSPARENT_PEN);
        g.SetBrush(wxBrush(curve.colour));
        const double r = FromDIP(curve.ours ? 4 : 3);
        for (const auto& [rate, percent] : curve.points)
            g.DrawEllipse(x.pixel(rate) - r, y.pixel(std::min(percent, y.high)) - r, 2 * r, 2 * r);
    }

    const Table4& table_;
};

Table4Window::Table4Window(wxWindow* parent, Choose choose,
                           std::function<void(const std::string&)> tell)
    : wxFrame(parent, wxID_ANY, wxTr("Table 4 of the paper"), wxDefaultPosition, wxDefaultSize,
              wxDEFAULT_FRAME_STYLE | wxFRAME_FLOAT_ON_PARENT),
      choose_(std::move(choose)),
      tell_(std::move(tell)) {
    auto* panel = new wxPanel(this);
    auto* words = new wxStaticText(
        panel, wxID_ANY,
        wxTr(
            "Share of a processor core that physics takes while boxes of 1\xC2\xA0m drop, the mean "
            "of 10\xC2\xA0s. The paper's machines are those of 2014 and before."));
    words->Wrap(FromDIP(560));
    diagram_ = new Diagram(panel, table_);
    list_ = new wxListView(panel, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                           wxLC_REPORT | wxLC_SINGLE_SEL);
    makeTable();
    progress_ = new wxGauge(panel, wxID_ANY, 1000);
    run_ = new wxButton(panel, wxID_ANY, wxTr("Run again"));
    csv_ = new wxButton(panel, wxID_ANY, wxTr("&Table as CSV\xE2\x80\xA6"));
    png_ = new wxButton(panel, wxID_ANY, wxTr("&Picture as PNG\xE2\x80\xA6"));
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    row->Add(progress_, wxSizerFlags(1).CentreVertical().Border(wxRIGHT, FromDIP(8)));
    for (wxButton* button : {run_, csv_, png_})
        row->Add(button, wxSizerFlags(0).Border(wxLEFT, FromDIP(4)));
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    const auto inside = wxSizerFlags(0).Expand().Border(wxALL, FromDIP(8));
    sizer->Add(words, inside);
    sizer->Add(diagram_, wxSizerFlags(1).Expand());
    sizer->Add(list_, inside);
    sizer->Add(row, inside);
    panel->SetSizer(sizer);
    auto* whole = new wxBoxSizer(wxVERTICAL);
    whole->Add(panel, wxSizerFlags(1).Expand());
    SetSizerAndFit(whole);
    SetSize(FromDIP(wxSize(640, 600)));
    CentreOnParent();
    run_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) {
        if (table_.running())
            table_.stop();
        else
            begin();
        refresh();
    });
    Bind(wxEVT_CHAR_HOOK, [this](wxKeyEvent& event) {
        if (event.GetKeyCode() == WXK_ESCAPE)
            Close();
        else
            event.Skip();
    });
    csv_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { saveAs("table4.csv", "csv"); });
    png_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { saveAs("table4.png", "png"); });
    begin();
}

void Table4Window::begin(double seconds) {
    const auto rates = table4Rates();
    try {
        table_.start({rates.begin(), rates.end()}, seconds);
    } catch (const std::exception& error) {
        tell_(error.what());
    }
    refresh();
}

// A line for each machine; ours is the last.
void Table4Window::makeTable() {
    const wxString heading = wxTr("Boxes a second");
    const wxString own = wxTr("This machine");
    int names = std::max(GetTextExtent(heading).x, GetTextExtent(own).x);
    for (const Table4Machine& machine : table4Machines())
        names = std::max(names, GetTextExtent(wxString::FromUTF8(machine.name)).x);
    int width = names + FromDIP(columnEdges);
    list_->AppendColumn(heading, wxLIST_FORMAT_LEFT, width);
    for (const int rate : table4Rates()) {
        list_->AppendColumn(wxString::Format("%d", rate), wxLIST_FORMAT_RIGHT, FromDIP(54));
        width += FromDIP(54);
    }
    list_->SetMinSize(wxSize(width + FromDIP(columnEdges), FromDIP(128)));
    long row = 0;
    for (const Table4Machine& machine : table4Machines()) {
        list_->InsertItem(row, wxString::FromUTF8(machine.name));
        for (std::size_t i = 0; i < machine.percent.size(); ++i)
            list_->SetItem(row, static_cast<int>(i) + 1,
                           wxString::Format("%.0f %%", machine.percent[i]));
        ++row;
    }
    list_->InsertItem(row, own);
}

void Table4Window::refresh() {
    const auto cells = table_.cells();
    const auto rates = table4Rates();
    const long ours = list_->GetItemCount() - 1;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        wxString text;
        for (const Table4Cell& cell : cells)
            if (cell.rate == rates[i]) text = percentOf(cell.percent);
        const int column = static_cast<int>(i) + 1;
        if (list_->GetItemText(ours, column) != text) {
            list_->SetItem(ours, column, text);
            diagram_->Refresh(false);
        }
    }
    progress_->SetValue(static_cast<int>(table_.progress() * 1000));
    const wxString label = wxTr(table_.running() ? "Stop" : "Run again");
    if (run_->GetLabel() != label) run_->SetLabel(label);
}

void Table4Window::saveAs(const char* name, const char* kind) {
    try {
        if (const auto file = choose_(name, kind)) save(*file);
    } catch (const std::exception& error) {
        tell_(error.what());
    }
}

void Table4Window::save(const std::filesystem::path& file) {
    if (file.extension() != ".png") {
        atlax::writeFileAtomic(file, table4Csv(table_.cells()));
        return;
    }
    const wxSize size(1000, 560);
    wxBitmap bitmap(size);
    {
        wxMemoryDC dc(bitmap);
        const std::unique_ptr<wxGraphicsContext> g(wxGraphicsContext::Create(dc));
        if (!g) throw std::runtime_error("the diagram cannot be drawn as a picture");
        diagram_->paint(*g, size, false);  // for paper
    }
    if (!bitmap.SaveFile(wxString::FromUTF8(file.string()), wxBITMAP_TYPE_PNG))
        throw std::runtime_error(tr("cannot write {}", {file.string()}));
}

}  // namespace sulfurchamber
