#include "constants_panel.hpp"

#include <wx/bmpbuttn.h>
#include <wx/sizer.h>
#include <wx/slider.h>
#include <wx/textctrl.h>

#include <algorithm>
#include <cmath>

#include "../model/geometry.hpp"
#include "icons.hpp"

namespace sulfurchamber {
namespace {

constexpr int sliderSteps = 1000;

}  // namespace

// One quantity: its name, a slider, the number with its unit, and a button that resets it.
struct ConstantsPanel::Row {
    wxString name;
    wxString unit;
    wxString help;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    std::function<double()> get;
    std::function<double()> initial;
    std::function<void(double)> set;

    wxSlider* slider = nullptr;
    wxTextCtrl* number = nullptr;
    wxBitmapButton* revert = nullptr;

    int position(double value) const {
        const double share = logarithmic ? std::log(value / low) / std::log(high / low)
                                         : (value - low) / (high - low);
        return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * sliderSteps));
    }
    double value(int position) const {
        const double share = static_cast<double>(position) / sliderSteps;
        const double exact =
            logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
        const double rounded = std::round(exact * 100) / 100;
        return std::clamp(rounded, low, high);
    }
    void show() const {
        const double now = get();
        if (slider->GetValue() != position(now) && value(slider->GetValue()) != now)
            slider->SetValue(position(now));
        const wxString text = wxString::Format("%g", std::round(now * 1000) / 1000);
        if (!number->HasFocus() && number->GetValue() != text) number->ChangeValue(text);
        const bool changed = now != initial();
        if (revert->IsEnabled() != changed) revert->Enable(changed);
    }
    void enter() const {
        double wanted = 0;
        if (number->GetValue().ToDouble(&wanted) || number->GetValue().ToCDouble(&wanted)) {
            if (std::isfinite(wanted)) set(std::clamp(wanted, low, high));
        }
        number->ChangeValue(wxString::Format("%g", std::round(get() * 1000) / 1000));
    }
};

ConstantsPanel::ConstantsPanel(wxWindow* parent, Workbench& bench, SceneView& view)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      view_(view) {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    addHeading("Constants", sizer);
    makeRows(sizer);
    addStatistics(sizer);
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(sizer, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(12)));
    SetSizer(border);
    SetScrollRate(0, FromDIP(12));
    SetMinSize(FromDIP(wxSize(240, 200)));
    refresh();
}

ConstantsPanel::~ConstantsPanel() = default;

void ConstantsPanel::addHeading(const wxString& text, wxSizer* sizer) {
    auto* heading = new wxStaticText(this, wxID_ANY, text);
    heading->SetFont(heading->GetFont().Bold().Larger());
    sizer->Add(heading, wxSizerFlags(0).Border(wxBOTTOM, FromDIP(8)));
}

void ConstantsPanel::makeRows(wxSizer* sizer) {
    // One drag of a slider is one step of the history.
    const auto constant = [this](const wxString& label, double Constants::*member) {
        return [this, label, member](double value) {
            Document& document = bench_.document();
            const std::string step = label.utf8_string();
            if (!document.editing() || document.undoLabel() != step) document.begin(step);
            Constants constants = document.constants();
            constants.*member = value;
            document.setConstants(constants);
        };
    };
    const auto now = [this](double Constants::*member) {
        return [this, member] { return bench_.document().constants().*member; };
    };
    const auto initial = [this](double Constants::*member) {
        return [this, member] { return bench_.document().initialConstants().*member; };
    };
    const auto add = [&](Row row, double Constants::*member) {
        row.get = now(member);
        row.initial = initial(member);
        row.set = constant("Change " + row.name.Lower(), member);
        addRow(std::make_unique<Row>(std::move(row)), sizer);
    };
    using L = ConstantLimits;
    Row row;
    row = {"Gravity",
           wxString::FromUTF8("m/s\xC2\xB2"),
           "Acceleration downwards; negative lets things rise",
           -L::gravity,
           L::gravity,
           false,
           {},
           {},
           {},
           nullptr,
           nullptr,
           nullptr};
    add(row, &Constants::gravity);
    row = {"Elasticity",
           wxString::FromUTF8("\xC3\x97"),
           "Factor on the stiffness of all elastic joints",
           L::minElasticity,
           L::maxElasticity,
           true,
           {},
           {},
           {},
           nullptr,
           nullptr,
           nullptr};
    add(row, &Constants::elasticity);
    row = {"Sliding friction",
           wxString::FromUTF8("\xC3\x97"),
           "Factor on the friction of all surfaces",
           0,
           L::friction,
           false,
           {},
           {},
           {},
           nullptr,
           nullptr,
           nullptr};
    add(row, &Constants::friction);
    row = {"Air friction",
           "1/s",
           "Share of the velocity that the air takes away in a second",
           0,
           L::airFriction,
           false,
           {},
           {},
           {},
           nullptr,
           nullptr,
           nullptr};
    add(row, &Constants::airFriction);
    addHeading("Stress", sizer);
    row = {"Rain of boxes",
           "1/s",
           "Boxes per second of simulated time",
           0,
           50,
           false,
           [this] { return bench_.rain(); },
           [] { return 0.0; },
           [this](double rate) { bench_.setRain(rate); },
           nullptr,
           nullptr,
           nullptr};
    addRow(std::make_unique<Row>(row), sizer);
}

void ConstantsPanel::addRow(std::unique_ptr<Row> made, wxSizer* sizer) {
    Row* row = made.get();
    rows_.push_back(std::move(made));
    auto* top = new wxBoxSizer(wxHORIZONTAL);
    auto* name = new wxStaticText(this, wxID_ANY, row->name);
    row->number = new wxTextCtrl(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(62, -1)),
                                 wxTE_RIGHT | wxTE_PROCESS_ENTER);
    auto* unit =
        new wxStaticText(this, wxID_ANY, row->unit, wxDefaultPosition, FromDIP(wxSize(34, -1)));
    row->revert = new wxBitmapButton(this, wxID_ANY, icon("revert"), wxDefaultPosition,
                                     wxDefaultSize, wxBU_EXACTFIT | wxBORDER_NONE);
    row->revert->SetToolTip("Back to what the scene began with");
    top->Add(name, wxSizerFlags(1).CentreVertical());
    top->Add(row->number, wxSizerFlags(0).CentreVertical());
    top->Add(unit, wxSizerFlags(0).CentreVertical().Border(wxLEFT, FromDIP(6)));
    top->Add(row->revert, wxSizerFlags(0).CentreVertical());
    row->slider = new wxSlider(this, wxID_ANY, 0, 0, sliderSteps);
    for (wxWindow* window : {static_cast<wxWindow*>(name), static_cast<wxWindow*>(row->number),
                             static_cast<wxWindow*>(row->slider)})
        window->SetToolTip(row->help);
    sizer->Add(top, wxSizerFlags(0).Expand());
    sizer->Add(row->slider, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(8)));

    row->slider->Bind(wxEVT_SLIDER, [row](wxCommandEvent&) {
        row->set(row->value(row->slider->GetValue()));
        row->show();
    });
    row->slider->Bind(wxEVT_SCROLL_THUMBRELEASE, [this](wxScrollEvent& event) {
        bench_.document().commit();
        event.Skip();
    });
    row->number->Bind(wxEVT_TEXT_ENTER, [row](wxCommandEvent&) { row->enter(); });
    row->number->Bind(wxEVT_KILL_FOCUS, [row](wxFocusEvent& event) {
        if (row->number->IsModified()) row->enter();
        event.Skip();
    });
    row->revert->Bind(wxEVT_BUTTON, [this, row](wxCommandEvent&) {
        row->set(row->initial());
        bench_.document().commit();
    });
}

void ConstantsPanel::addStatistics(wxSizer* sizer) {
    addHeading("Numbers", sizer);
    auto* table = new wxFlexGridSizer(2, FromDIP(3), FromDIP(12));
    table->AddGrowableCol(1);
    for (const char* name : {"Bodies", "Awake particles", "Rigid joints", "Elastic joints",
                             "Energy", "Physics", "Frames"}) {
        table->Add(new wxStaticText(this, wxID_ANY, name), wxSizerFlags(0));
        auto* value =
            new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(110, -1)),
                             wxALIGN_RIGHT | wxST_NO_AUTORESIZE);
        table->Add(value, wxSizerFlags(0).Right());
        statistics_.push_back(value);
    }
    sizer->Add(table, wxSizerFlags(0).Expand());
}

void ConstantsPanel::refresh() {
    for (const auto& row : rows_) row->show();
    const sulfur::World& world = bench_.document().world();
    const Totals sums = totals(world);
    const std::vector<wxString> values{
        wxString::Format("%zu", sums.bodies),
        wxString::Format("%zu of %zu", sums.awakeParticles, sums.particles),
        wxString::Format("%zu", sums.rigidJoints),
        wxString::Format("%zu", sums.elasticJoints),
        wxString::Format("%.3g J", world.energy()),
        wxString::Format("%.1f %% of a core", view_.physicsLoad() * 100),
        wxString::Format("%.0f 1/s", view_.framesPerSecond()),
    };
    for (std::size_t i = 0; i < values.size(); ++i)
        if (statistics_[i]->GetLabel() != values[i]) statistics_[i]->SetLabel(values[i]);
}

}  // namespace sulfurchamber
