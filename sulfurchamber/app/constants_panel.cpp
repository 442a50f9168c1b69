#include "constants_panel.hpp"

#include <wx/sizer.h>

#include <string_view>

#include "../model/geometry.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

ConstantsPanel::ConstantsPanel(wxWindow* parent, Workbench& bench, SceneView& view,
                               std::function<void(const std::string&)> refuse)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      view_(view),
      refuse_(std::move(refuse)) {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    addConstants(sizer);
    addRain(sizer);
    addStatistics(sizer);
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(sizer, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(8)));
    SetSizer(border);
    SetScrollRate(0, FromDIP(12));
    refresh();
}

ConstantsPanel::~ConstantsPanel() = default;

void ConstantsPanel::addHeading(const wxString& text, wxSizer* sizer) {
    auto* heading = new wxStaticText(this, wxID_ANY, wxTr(text));
    heading->SetFont(heading->GetFont().Bold().Larger());
    sizer->Add(heading, wxSizerFlags(0).Border(wxBOTTOM, FromDIP(6)));
}

void ConstantsPanel::addConstants(wxSizer* sizer) {
    addHeading("Constants", sizer);
    const auto add = [&](ValueSpec spec, double Constants::*member) {
        const std::string label = tr("Change {}", {trInside(spec.name.utf8_string())});
        spec.get = [this, member] { return bench_.document().constants().*member; };
        spec.initial = [this, member] { return bench_.document().initialConstants().*member; };
        spec.set = [this, member, label](double value) {
            Document& document = bench_.document();
            if (!document.editing() || document.undoLabel() != label) document.begin(label);
            Constants constants = document.constants();
            constants.*member = value;
            document.setConstants(constants);
        };
        spec.finish = [this] { bench_.document().commit(); };
        spec.refuse = refuse_;
        rows_.push_back(std::make_unique<ValueRow>(this, sizer, std::move(spec)));
    };
    using L = ConstantLimits;
    ValueSpec spec;
    spec.name = "Gravity";
    spec.unit = wxString::FromUTF8("m/s\xC2\xB2");
    spec.help = "Acceleration downwards; negative lets things rise";
    spec.low = -L::gravity;
    spec.high = L::gravity;
    add(spec, &Constants::gravity);
    spec.name = "Elasticity";
    spec.unit = wxString::FromUTF8("\xC3\x97");
    spec.help = "Factor on the stiffness of all elastic joints";
    spec.low = L::minElasticity;
    spec.high = L::maxElasticity;
    spec.scale = Scale::logarithmic;
    add(spec, &Constants::elasticity);
    spec.name = "Friction";
    spec.help = "Factor on the sliding and static friction of all surfaces";
    spec.low = 0;
    spec.high = L::friction;
    spec.scale = Scale::linear;
    add(spec, &Constants::friction);
    spec.name = "Air friction";
    spec.unit = "1/s";
    spec.help = "Share of the velocity that the air takes away in a second";
    spec.high = L::airFriction;
    add(spec, &Constants::airFriction);
}

void ConstantsPanel::addRain(wxSizer* sizer) {
    addHeading("Stress", sizer);
    ValueSpec spec;
    spec.name = "Rain";
    spec.unit = "1/s";
    spec.help = "Boxes per second of simulated time; they are of this moment, and not saved";
    spec.high = 50;
    spec.get = [this] { return bench_.rain(); };
    spec.initial = [] { return 0.0; };
    spec.set = [this](double rate) { bench_.setRain(rate); };
    spec.finish = [] {};
    spec.refuse = refuse_;
    rows_.push_back(std::make_unique<ValueRow>(this, sizer, std::move(spec)));
}

void ConstantsPanel::addStatistics(wxSizer* sizer) {
    addHeading("Numbers", sizer);
    auto* table = new wxFlexGridSizer(2, FromDIP(3), FromDIP(8));
    table->AddGrowableCol(1);
    for (const char* name : {"Bodies", "Awake particles", "Rigid joints", "Elastic joints",
                             "Energy", "Physics load", "Frames"}) {
        table->Add(new wxStaticText(this, wxID_ANY, wxTr(name)), wxSizerFlags(0));
        auto* value = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                                       wxALIGN_RIGHT | wxST_NO_AUTORESIZE);
        table->Add(value, wxSizerFlags(0).Expand());
        if (std::string_view(name) == "Physics load")
            value->SetToolTip(wxTr("Share of one processor core that the physics takes"));
        statistics_.push_back(value);
    }
    sizer->Add(table, wxSizerFlags(0).Expand());
}

void ConstantsPanel::refresh() {
    for (const auto& row : rows_) row->refresh();
    const sulfur::World& world = bench_.document().world();
    const Totals sums = totals(world);
    const std::vector<wxString> values{
        wxString::Format("%zu", sums.bodies),
        wxString::Format("%zu / %zu", sums.awakeParticles, sums.particles),
        wxString::Format("%zu", sums.rigidJoints),
        wxString::Format("%zu", sums.elasticJoints),
        wxString::Format("%.3g J", world.energy()),
        wxString::Format("%.1f %%", view_.physicsLoad() * 100),
        wxString::Format("%.0f 1/s", view_.framesPerSecond()),
    };
    for (std::size_t i = 0; i < values.size(); ++i)
        if (statistics_[i]->GetLabel() != values[i]) statistics_[i]->SetLabel(values[i]);
}

}  // namespace sulfurchamber
