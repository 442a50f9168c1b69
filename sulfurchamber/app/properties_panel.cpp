#include "properties_panel.hpp"

#include <wx/colordlg.h>
#include <wx/dcmemory.h>
#include <wx/sizer.h>

#include <algorithm>
#include <cmath>

#include "../model/instances.hpp"
#include "property_spec.hpp"
#include "small_button.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

// A swatch of several colours.
wxBitmap striped(const std::vector<wxColour>& colours, const wxSize& size) {
    wxBitmap bitmap(size);
    wxMemoryDC dc(bitmap);
    dc.SetPen(*wxTRANSPARENT_PEN);
    const int count = static_cast<int>(colours.size());
    for (int i = 0; i < count; ++i) {
        dc.SetBrush(wxBrush(colours[static_cast<std::size_t>(i)]));
        const int from = size.x * i / count;
        dc.DrawRectangle(from, 0, size.x * (i + 1) / count - from, size.y);
    }
    return bitmap;
}

}  // namespace

PropertiesPanel::PropertiesPanel(wxWindow* parent, Workbench& bench,
                                 const std::function<void(const std::string&)>& run,
                                 std::function<void(const std::string&)> refuse)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      refuse_(std::move(refuse)) {
    auto* all = new wxBoxSizer(wxVERTICAL);
    title_ = new wxStaticText(this, wxID_ANY, "");
    title_->SetFont(title_->GetFont().Bold().Larger());
    all->Add(title_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    body_ = new wxBoxSizer(wxVERTICAL);
    membership_ = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                                   wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    all->Add(membership_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    makeHead(body_);
    for (const NumberProperty& property : numberProperties()) {
        // These are the frame's, which all bodies have.
        if (property.key == "width" || property.key == "height") continue;
        addNumber(body_, property);
        if (property.key == "strength") makeLayers(body_);
    }
    for (const PlaceProperty& property : placeProperties()) addPlace(body_, property);
    skinSection_ = std::make_unique<SkinSection>(this, body_, bench_, run, refuse_);
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
        table->Add(new wxStaticText(this, wxID_ANY, wxTr(label)), wxSizerFlags(0).CentreVertical());
        table->Add(window, wxSizerFlags(1).Expand());
    };
    name_ = new wxTextCtrl(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(60, -1)),
                           wxTE_PROCESS_ENTER);
    add("Name", name_);
    wxArrayString names;
    names.Add(wxTr("choose one"));
    for (const MaterialPreset& preset : materialPresets()) names.Add(wxTr(preset.name));
    preset_ = new wxChoice(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(60, -1)), names);
    preset_->SetToolTip(wxTr("Sets density, friction, bounce and stiffness at once"));
    add("Material", preset_);
    makeLook(table);
    sizer->Add(table, wxSizerFlags(0).Expand());
    held_ = new wxCheckBox(this, wxID_ANY, wxTr("Held in place"), wxDefaultPosition, wxDefaultSize,
                           wxCHK_3STATE);
    held_->SetToolTip(wxTr("Nothing moves it, as the ground"));
    sizer->Add(held_, wxSizerFlags(0).Border(wxTOP | wxBOTTOM, FromDIP(4)));

    makeSwitches(sizer);
    bindHead();
}

// Colour, and the skin that the game shows.
void PropertiesPanel::makeLook(wxSizer* table) {
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    colour_ = new wxColourPickerCtrl(this, wxID_ANY, *wxWHITE, wxDefaultPosition,
                                     FromDIP(wxSize(52, -1)));
    ownColour_ = smallButton(this, wxTr("Usual"));
    ownColour_->SetToolTip(wxTr("Back to the colour that the scene gives it"));
    colours_ = new wxBitmapButton(this, wxID_ANY, striped({*wxWHITE}, FromDIP(wxSize(44, 16))));
    colours_->SetMinSize(FromDIP(wxSize(52, -1)));
    colours_->SetToolTip(wxTr("They have several"));
    row->Add(colour_, wxSizerFlags(1).Expand());
    row->Add(colours_, wxSizerFlags(1).Expand());
    row->Add(ownColour_, wxSizerFlags(0).Expand().Border(wxLEFT, FromDIP(4)));
    colourName_ = new wxStaticText(this, wxID_ANY, wxTr("Colour"));
    table->Add(colourName_, wxSizerFlags(0).CentreVertical());
    table->Add(row, wxSizerFlags(1).Expand());
    skin_ = new wxTextCtrl(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(60, -1)),
                           wxTE_PROCESS_ENTER);
    skin_->SetToolTip(
        wxTr("The texture that the game shows on it, such as skins/crate.png; empty for none"));
    table->Add(new wxStaticText(this, wxID_ANY, wxTr("Skin")), wxSizerFlags(0).CentreVertical());
    table->Add(skin_, wxSizerFlags(1).Expand());
}

void PropertiesPanel::makeSwitches(wxSizer* sizer) {
    for (const SwitchProperty& property : switchProperties()) {
        auto* box = new wxCheckBox(this, wxID_ANY, wxTr(property.name), wxDefaultPosition,
                                   wxDefaultSize, wxCHK_3STATE);
        box->SetToolTip(wxTr(property.help));
        box->Bind(wxEVT_CHECKBOX, [this, box, &property](wxCommandEvent&) {
            const bool on = box->Get3StateValue() == wxCHK_CHECKED;
            change(tr("Change {}", {trInside(std::string(property.name))}),
                   [&] { setSwitch(bench_.document(), bench_.selection(), property, on); });
        });
        switches_.push_back(box);
        sizer->Add(box, wxSizerFlags(0).Border(wxBOTTOM, FromDIP(4)));
    }
}

void PropertiesPanel::bindHead() {
    const auto dress = [this] {
        const std::string wanted = skin_->GetValue().Strip(wxString::both).utf8_string();
        skin_->DiscardEdits();
        if (skinOf(bench_.document(), bench_.selection()) != wanted)
            change(wanted.empty() ? "Take the skin off" : "Change skin",
                   [&] { setSkin(bench_.document(), bench_.selection(), wanted); });
    };
    skin_->Bind(wxEVT_TEXT_ENTER, [dress](wxCommandEvent&) { dress(); });
    skin_->Bind(wxEVT_KILL_FOCUS, [this, dress](wxFocusEvent& event) {
        if (skin_->IsModified()) dress();
        event.Skip();
    });
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
        change(tr("Make of {}", {trInside(std::string(preset.name))}),
               [&] { applyPreset(bench_.document(), bench_.selection(), preset); });
    });
    held_->Bind(wxEVT_CHECKBOX, [this](wxCommandEvent&) {
        const bool on = held_->Get3StateValue() == wxCHK_CHECKED;
        change(on ? "Hold in place" : "Let go",
               [&] { holdInPlace(bench_.document(), bench_.selection(), on); });
    });
    const auto dye = [this](const wxColour& wanted) {
        const std::string text = wanted.GetAsString(wxC2S_HTML_SYNTAX).Lower().utf8_string();
        change("Colour", [&] { setColour(bench_.document(), bench_.selection(), text); });
    };
    colour_->Bind(wxEVT_COLOURPICKER_CHANGED,
                  [dye](wxColourPickerEvent& event) { dye(event.GetColour()); });
    colours_->Bind(wxEVT_BUTTON, [this, dye](wxCommandEvent&) {
        const wxColour wanted = wxGetColourFromUser(this, colour_->GetColour());
        if (wanted.IsOk()) dye(wanted);
    });
    ownColour_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) {
        change("Usual colour", [&] { setColour(bench_.document(), bench_.selection(), ""); });
    });
}

void PropertiesPanel::makeLayers(wxSizer* sizer) {
    auto* label = new wxStaticText(this, wxID_ANY, wxTr("Layers"));
    label->SetToolTip(wxTr("Bodies collide when they have a layer in common"));
    sizer->Add(label);
    auto* grid = new wxGridSizer(4, 0, 0);
    for (int i = 0; i < layerCount; ++i) {
        auto* box = new wxCheckBox(this, wxID_ANY, wxString::Format("%d", i + 1), wxDefaultPosition,
                                   wxDefaultSize, wxCHK_3STATE);
        box->Bind(wxEVT_CHECKBOX, [this, i, box](wxCommandEvent&) {
            const bool on = box->Get3StateValue() == wxCHK_CHECKED;
            change("Change layers",
                   [&] { setInLayer(bench_.document(), bench_.selection(), i, on); });
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
    const std::string label = tr("Change {}", {trInside(std::string(property.name))});
    ValueSpec spec = specOf(property);
    spec.get = [this, at] { return numbers_[at].now.value; };
    spec.initial = [this, at] { return numbers_[at].first.value; };
    spec.set = [this, &property, label](double value) {
        Document& document = bench_.document();
        setInStep(
            document, label, [&] { setProperty(document, bench_.selection(), property, value); },
            refuse_);
        readSelection();
    };
    spec.finish = [this] { bench_.document().commit(); };
    spec.refuse = refuse_;
    number.row = std::make_unique<ValueRow>(this, sizer, std::move(spec));
}

void PropertiesPanel::addPlace(wxSizer* sizer, const PlaceProperty& property) {
    ValueSpec spec = specOf(property);
    spec.scale = property.low > 0 ? Scale::logarithmic : Scale::linear;
    spec.moves = true;
    const std::string label = tr("Change {}", {trInside(std::string(property.name))});
    const bool turns = property.key == "angle";
    const auto isOpen = [this, label] {
        return bench_.document().editing() && bench_.document().undoLabel() == label;
    };
    spec.get = [this, &property, turns, isOpen]() -> std::optional<double> {
        const auto frame = selectionFrame(bench_);
        if (!frame) return std::nullopt;
        // The frame of many stands upright again once they are turned.
        return turns && bench_.selection().size() > 1 ? (isOpen() ? turned_ : 0)
                                                      : property.get(*frame);
    };
    spec.set = [this, &property, turns, label, isOpen](double value) {
        Document& document = bench_.document();
        if (!isOpen()) {
            document.begin(label);
            turned_ = 0;
        }
        try {
            const bool many = turns && bench_.selection().size() > 1;
            setPlace(bench_, property, many ? std::remainder(value - turned_, 360) : value);
            turned_ = value;
        } catch (const std::exception& problem) {
            document.rollback();
            refuse_(problem.what());
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
    wxString title = wxTrCount("{} body", "{} bodies", bodies.size());
    if (bodies.empty()) title = wxTr("Nothing is selected");
    if (const auto ref = bench_.fitting()) {
        const Fitting is = document.fitting(*ref);
        const auto* mechanism = std::get_if<sulfur::scene::SceneMechanism>(&is);
        title = wxTr(kindName(is));
        if (mechanism != nullptr && !mechanism->id.empty())
            title += "  \"" + wxString::FromUTF8(mechanism->id) + "\"";
    }
    if (bodies.size() == 1) title = id.empty() ? wxTr("A piece") : wxString::FromUTF8(id);
    title_->SetLabel(title);
    name_->Enable(!id.empty());
    name_->ChangeValue(wxString::FromUTF8(id));
    name_->DiscardEdits();
    preset_->SetSelection(0);
    const auto held = heldInPlace(document, bodies);
    held_->Set3StateValue(!held ? wxCHK_UNDETERMINED : *held ? wxCHK_CHECKED : wxCHK_UNCHECKED);
    const auto skin = skinOf(document, bodies);
    skin_->ChangeValue(wxString::FromUTF8(skin.value_or("")));
    skin_->SetHint(skin || bodies.empty() ? wxString() : wxTr("mixed"));
    skin_->DiscardEdits();
    showSwitches();
}

void PropertiesPanel::showSwitches() {
    const Document& document = bench_.document();
    const auto& bodies = bench_.selection();
    const auto show = [](wxCheckBox& box, std::optional<bool> on) {
        box.Set3StateValue(!on ? wxCHK_UNDETERMINED : *on ? wxCHK_CHECKED : wxCHK_UNCHECKED);
    };
    for (int i = 0; i < layerCount; ++i)
        show(*layers_[static_cast<std::size_t>(i)], inLayer(document, bodies, i));
    const auto properties = switchProperties();
    for (std::size_t i = 0; i < properties.size(); ++i)
        show(*switches_[i], common(document, bodies, properties[i]).on);
}

void PropertiesPanel::showColours() {
    const Document& document = bench_.document();
    const auto& bodies = bench_.selection();
    const auto own = colour(document, bodies);
    std::vector<wxColour> shown;
    for (const std::string& text : shownColours(document, bodies))
        shown.emplace_back(wxString::FromUTF8(text));
    const bool several = shown.size() > 1;
    if (!shown.empty()) colour_->SetColour(shown.front());
    if (several && shown != stripes_) {
        stripes_ = shown;
        colours_->SetBitmap(striped(shown, FromDIP(wxSize(44, 16))));
    }
    ownColour_->Enable(!own || !own->empty());
    colourName_->SetLabel(wxTr(several ? "Colours" : "Colour"));
    colourName_->SetToolTip(several ? wxTr("They have several") : wxString());
    // What hides all of a page shows all of it again.
    colour_->Show(!several && !bodies.empty());
    colours_->Show(several);
}

// What differs from the template is marked, here and in the rows.
void PropertiesPanel::showMembership() {
    const Document& document = bench_.document();
    const auto& bodies = bench_.selection();
    const std::string id = bodies.size() == 1 ? document.idOf(bodies[0]) : "";
    std::optional<Membership> membership;
    if (!id.empty()) membership = membershipOf(document.plan().body(id));
    std::vector<Override> overrides;
    if (membership) overrides = overridesOf(document, id);
    wxString text;
    if (membership)
        text = wxTr("Part \xE2\x80\x9C{}\xE2\x80\x9D of \xE2\x80\x9C{}\xE2\x80\x9D",
                    {membership->part, membership->instance});
    std::string differs;
    for (const Override& one : overrides)
        differs += (differs.empty() ? "" : ", ") + trInside(one.name);
    if (!differs.empty()) text = wxTr("{}; differs: {}", {text.utf8_string(), differs});
    membership_->SetLabel(text);
    membership_->SetToolTip(text);
    membership_->Show(membership.has_value());
    for (Number& number : numbers_)
        number.row->mark(std::any_of(overrides.begin(), overrides.end(), [&](const auto& one) {
            return one.key == number.property->key;
        }));
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
        showColours();
        skinSection_->read();
        showMembership();
        for (Number& number : numbers_) number.row->show(!bodies.empty() && number.now.applies);
        for (std::size_t i = 0; i < switches_.size(); ++i)
            switches_[i]->Show(common(document, bodies, switchProperties()[i]).applies);
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
    skinSection_->refresh();
}

}  // namespace sulfurchamber
