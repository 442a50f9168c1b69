#include "properties_panel.hpp"

#include <wx/sizer.h>

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

constexpr double degrees = 180 / 3.14159265358979;

wxString utf8(std::string_view text) {
    return wxString::FromUTF8(text.data(), text.size());
}

}  // namespace

PropertiesPanel::PropertiesPanel(wxWindow* parent, Workbench& bench,
                                 std::function<void(const std::string&)> refuse)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      refuse_(std::move(refuse)) {
    auto* all = new wxBoxSizer(wxVERTICAL);
    title_ = new wxStaticText(this, wxID_ANY, "");
    title_->SetFont(title_->GetFont().Bold().Larger());
    all->Add(title_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    body_ = new wxBoxSizer(wxVERTICAL);
    makeHead(body_);
    for (const NumberProperty& property : numberProperties()) {
        addNumber(body_, property);
        if (property.key == "strength") makeLayers(body_);
    }
    addPlace(
        body_, "x", "m", 1000, [](const sulfur::Pose& pose) { return pose.position.x(); },
        [](sulfur::Pose& pose, double value) { pose.position.x() = value; });
    addPlace(
        body_, "y", "m", 1000, [](const sulfur::Pose& pose) { return pose.position.y(); },
        [](sulfur::Pose& pose, double value) { pose.position.y() = value; });
    addPlace(
        body_, "Angle", utf8("\xC2\xB0"), 180,
        [](const sulfur::Pose& pose) { return pose.angle * degrees; },
        [](sulfur::Pose& pose, double value) { pose.angle = value / degrees; });
    auto* fittingSizer = new wxBoxSizer(wxVERTICAL);
    fitting_ = std::make_unique<FittingRows>(this, fittingSizer, bench_, refuse_);
    all->Add(fittingSizer, wxSizerFlags(0).Expand());
    all->Add(body_, wxSizerFlags(1).Expand());
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(all, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(8)));
    SetSizer(border);
    SetScrollRate(0, FromDIP(12));
    refresh();
}

PropertiesPanel::~PropertiesPanel() = default;

// --- making ----------------------------------------------------------------------------------

void PropertiesPanel::makeHead(wxSizer* sizer) {
    auto* table = new wxFlexGridSizer(2, FromDIP(4), FromDIP(8));
    table->AddGrowableCol(1);
    const auto add = [&](const char* label, wxWindow* window) {
        table->Add(new wxStaticText(this, wxID_ANY, label), wxSizerFlags(0).CentreVertical());
        table->Add(window, wxSizerFlags(1).Expand());
    };
    name_ = new wxTextCtrl(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(60, -1)),
                           wxTE_PROCESS_ENTER);
    add("Name", name_);
    wxArrayString names;
    names.Add("choose one");
    for (const MaterialPreset& preset : materialPresets()) names.Add(utf8(preset.name));
    preset_ = new wxChoice(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(60, -1)), names);
    preset_->SetToolTip("Sets density, friction, bounce and stiffness at once");
    add("Material", preset_);
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    colour_ = new wxColourPickerCtrl(this, wxID_ANY, *wxWHITE, wxDefaultPosition,
                                     FromDIP(wxSize(52, -1)));
    ownColour_ =
        new wxButton(this, wxID_ANY, "Usual", wxDefaultPosition, wxDefaultSize, wxBU_EXACTFIT);
    ownColour_->SetToolTip("Back to the colour that the scene gives it");
    row->Add(colour_, wxSizerFlags(1).Expand());
    row->Add(ownColour_, wxSizerFlags(0).Expand().Border(wxLEFT, FromDIP(4)));
    table->Add(new wxStaticText(this, wxID_ANY, "Colour"), wxSizerFlags(0).CentreVertical());
    table->Add(row, wxSizerFlags(1).Expand());
    sizer->Add(table, wxSizerFlags(0).Expand());
    held_ = new wxCheckBox(this, wxID_ANY, "Held in place", wxDefaultPosition, wxDefaultSize,
                           wxCHK_3STATE);
    held_->SetToolTip("Nothing moves it, as the ground");
    sizer->Add(held_, wxSizerFlags(0).Border(wxTOP | wxBOTTOM, FromDIP(4)));

    name_->Bind(wxEVT_TEXT_ENTER, [this](wxCommandEvent&) { rename(); });
    name_->Bind(wxEVT_KILL_FOCUS, [this](wxFocusEvent& event) {
        if (name_->IsModified()) rename();
        event.Skip();
    });
    preset_->Bind(wxEVT_CHOICE, [this](wxCommandEvent& event) {
        const int at = event.GetInt() - 1;
        preset_->SetSelection(0);
        if (at < 0) return;
        const MaterialPreset& preset = materialPresets()[static_cast<std::size_t>(at)];
        change("Make of " + utf8(preset.name).Lower().utf8_string(),
               [&] { applyPreset(bench_.document(), bench_.selection(), preset); });
    });
    held_->Bind(wxEVT_CHECKBOX, [this](wxCommandEvent&) {
        const bool on = held_->Get3StateValue() == wxCHK_CHECKED;
        change(on ? "Hold in place" : "Let go",
               [&] { holdInPlace(bench_.document(), bench_.selection(), on); });
    });
    colour_->Bind(wxEVT_COLOURPICKER_CHANGED, [this](wxColourPickerEvent& event) {
        const std::string text =
            event.GetColour().GetAsString(wxC2S_HTML_SYNTAX).Lower().utf8_string();
        change("Colour", [&] { setColour(bench_.document(), bench_.selection(), text); });
    });
    ownColour_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) {
        change("Usual colour", [&] { setColour(bench_.document(), bench_.selection(), ""); });
    });
}

void PropertiesPanel::makeLayers(wxSizer* sizer) {
    auto* label = new wxStaticText(this, wxID_ANY, "Layers");
    label->SetToolTip("Bodies collide when they have a layer in common");
    sizer->Add(label);
    auto* grid = new wxGridSizer(4, 0, 0);
    for (int i = 0; i < layerCount; ++i) {
        auto* box = new wxCheckBox(this, wxID_ANY, wxString::Format("%d", i + 1));
        box->Bind(wxEVT_CHECKBOX, [this](wxCommandEvent&) {
            std::uint32_t bits = 0;
            for (int k = 0; k < layerCount; ++k)
                if (layers_[static_cast<std::size_t>(k)]->GetValue()) bits |= 1u << k;
            change("Change layers",
                   [&] { setLayers(bench_.document(), bench_.selection(), bits); });
        });
        layers_[static_cast<std::size_t>(i)] = box;
        grid->Add(box);
    }
    sizer->Add(grid, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
}

void PropertiesPanel::addNumber(wxSizer* sizer, const NumberProperty& property) {
    numbers_.push_back({});
    const std::size_t at = numbers_.size() - 1;
    Number& number = numbers_.back();
    number.property = &property;
    const std::string label = "Change " + utf8(property.name).Lower().utf8_string();
    ValueSpec spec;
    spec.name = utf8(property.name);
    spec.unit = utf8(property.unit);
    spec.help = utf8(property.help);
    spec.low = property.low;
    spec.high = property.high;
    spec.scale = property.scale;
    spec.endless = utf8(property.endless);
    spec.whole = property.whole;
    spec.get = [this, at] { return numbers_[at].now.value; };
    spec.initial = [this, at] { return numbers_[at].first.value; };
    spec.set = [this, &property, label](double value) {
        Document& document = bench_.document();
        if (!document.editing() || document.undoLabel() != label) document.begin(label);
        try {
            setProperty(document, bench_.selection(), property, value);
        } catch (const std::exception& problem) {
            document.rollback();
            refuse_(problem.what());
        }
        readSelection();
    };
    spec.finish = [this] { bench_.document().commit(); };
    spec.refuse = refuse_;
    number.row = std::make_unique<ValueRow>(this, sizer, std::move(spec));
}

void PropertiesPanel::addPlace(wxSizer* sizer, const wxString& name, const wxString& unit,
                               double limit, double (*get)(const sulfur::Pose&),
                               void (*set)(sulfur::Pose&, double)) {
    ValueSpec spec;
    spec.name = name;
    spec.unit = unit;
    spec.help = "Of its blueprint's frame, in the world";
    spec.low = -limit;
    spec.high = limit;
    spec.moves = true;
    spec.get = [this, get]() -> std::optional<double> {
        std::optional<double> same;
        for (const sulfur::BodyId body : bench_.selection()) {
            const double own = get(bench_.document().world().pose(body));
            if (same && std::abs(*same - own) > 1e-6) return std::nullopt;
            same = own;
        }
        return same;
    };
    const std::string label = "Place by number";
    spec.set = [this, set, label](double value) {
        Document& document = bench_.document();
        if (!document.editing() || document.undoLabel() != label) document.begin(label);
        const auto bodies = bench_.selection();
        for (const sulfur::BodyId body : bodies) {
            sulfur::Pose pose = document.world().pose(body);
            set(pose, value);
            document.placeWithPegs(body, pose);
        }
    };
    spec.finish = [this] { bench_.document().commit(); };
    spec.refuse = refuse_;
    places_.push_back(std::make_unique<ValueRow>(this, sizer, std::move(spec)));
}

// --- changing --------------------------------------------------------------------------------

void PropertiesPanel::change(const std::string& label, const std::function<void()>& what) {
    try {
        bench_.document().edit(label, what);
    } catch (const std::exception& problem) {
        refuse_(problem.what());
    }
    fresh_ = true;
    refresh();
}

void PropertiesPanel::rename() {
    const auto bodies = bench_.selection();
    const std::string wanted = name_->GetValue().Strip(wxString::both).utf8_string();
    name_->DiscardEdits();
    if (bodies.size() == 1 && wanted != bench_.document().idOf(bodies[0]))
        change("Rename", [&] { bench_.document().rename(bodies[0], wanted); });
}

// --- showing ---------------------------------------------------------------------------------

void PropertiesPanel::readSelection() {
    for (Number& number : numbers_)
        number.now = common(bench_.document(), bench_.selection(), *number.property);
}

void PropertiesPanel::showHead() {
    const Document& document = bench_.document();
    const auto& bodies = bench_.selection();
    const std::string id = bodies.size() == 1 ? document.idOf(bodies[0]) : "";
    wxString title = wxString::Format("%zu bodies", bodies.size());
    if (bodies.empty()) title = "Nothing is selected";
    if (const auto ref = bench_.fitting()) {
        const Fitting is = document.fitting(*ref);
        const auto* mechanism = std::get_if<sulfur::scene::SceneMechanism>(&is);
        title = utf8(kindName(is));
        if (mechanism != nullptr && !mechanism->id.empty())
            title += "  \"" + wxString::FromUTF8(mechanism->id) + "\"";
    }
    if (bodies.size() == 1) title = id.empty() ? wxString("A piece") : wxString::FromUTF8(id);
    title_->SetLabel(title);
    name_->Enable(!id.empty());
    name_->ChangeValue(wxString::FromUTF8(id));
    name_->DiscardEdits();
    preset_->SetSelection(0);
    const auto held = heldInPlace(document, bodies);
    held_->Set3StateValue(!held ? wxCHK_UNDETERMINED : *held ? wxCHK_CHECKED : wxCHK_UNCHECKED);
    const auto own = colour(document, bodies);
    // Without one of its own it has the scene's colour for what is soft or rigid.
    const auto stiffness = common(document, bodies, *numberProperty("stiffness"));
    const bool soft = stiffness.value && std::isfinite(*stiffness.value);
    const wxColour usual = soft ? wxColour(0xFF, 0xB3, 0x47) : wxColour(0x6F, 0xA8, 0xDC);
    colour_->SetColour(own && !own->empty() ? wxColour(wxString::FromUTF8(*own)) : usual);
    ownColour_->Enable(!own || !own->empty());
    const auto bits = layers(document, bodies).value_or(0);
    for (int i = 0; i < layerCount; ++i)
        layers_[static_cast<std::size_t>(i)]->SetValue((bits >> i & 1u) != 0);
}

void PropertiesPanel::refresh() {
    const Document& document = bench_.document();
    const auto& bodies = bench_.selection();
    std::vector<std::string> ids;
    for (const sulfur::BodyId body : bodies) ids.push_back(document.idOf(body));
    const bool others = ids != shownIds_;
    if (fresh_ || others || shownRevision_ != document.revision()) {
        readSelection();
        if (fresh_ || others)
            for (Number& number : numbers_) number.first = number.now;
        showHead();
        body_->ShowItems(!bodies.empty());
        for (Number& number : numbers_) number.row->show(!bodies.empty() && number.now.applies);
        shownIds_ = std::move(ids);
        shownRevision_ = document.revision();
        fresh_ = false;
        fitting_->refresh();
        FitInside();
        Layout();
    } else if (fitting_->refresh()) {
        showHead();
        FitInside();
        Layout();
    }
    if (bodies.empty()) return;
    for (Number& number : numbers_)
        if (number.now.applies) number.row->refresh();
    for (const auto& row : places_) row->refresh();
}

}  // namespace sulfurchamber
