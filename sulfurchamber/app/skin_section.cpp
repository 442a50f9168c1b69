#include "skin_section.hpp"
#include "property_spec.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr double skinDegrees = 180 / 3.14159265358979;

}  // namespace

SkinSection::SkinSection(wxWindow* parent, wxSizer* sizer, Workbench& bench,
                         std::function<void(const std::string&)> run,
                         std::function<void(const std::string&)> refuse)
    : bench_(bench), refuse_(std::move(refuse)) {
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    row->Add(new wxStaticText(parent, wxID_ANY, wxTr("Picture")), wxSizerFlags(1).CentreVertical());
    const auto button = [&](const wxString& label, const char* help, const char* action) {
        auto* made = new wxButton(parent, wxID_ANY, wxTr(label), wxDefaultPosition, wxDefaultSize,
                                  wxBU_EXACTFIT);
        made->SetToolTip(wxTr(help));
        made->Bind(wxEVT_BUTTON, [run, action](wxCommandEvent&) { run(action); });
        row->Add(made, wxSizerFlags(0).Border(wxLEFT, parent->FromDIP(4)));
        return made;
    };
    choose_ = button(wxString::FromUTF8("Choose\xE2\x80\xA6"), "A picture that the body wears",
                     "skin-choose");
    handles_ = button("Place", "Move, scale and turn the picture by handles", "skin-place");
    remove_ = button("Remove", "The usual colours again", "skin-remove");
    sizer->Add(row, wxSizerFlags(0).Expand().Border(wxTOP | wxBOTTOM, parent->FromDIP(4)));
    addNumber(
        parent, sizer, "Skin x", "m", -100, 100, [](const SkinMapping& m) { return m.centre.x(); },
        [](SkinMapping& m, double value) { m.centre.x() = value; });
    addNumber(
        parent, sizer, "Skin y", "m", -100, 100, [](const SkinMapping& m) { return m.centre.y(); },
        [](SkinMapping& m, double value) { m.centre.y() = value; });
    addNumber(
        parent, sizer, "Skin width", "m", -100, 100,
        [](const SkinMapping& m) { return m.size.x(); },
        [](SkinMapping& m, double value) { m.size.x() = value; });
    addNumber(
        parent, sizer, "Skin height", "m", -100, 100,
        [](const SkinMapping& m) { return m.size.y(); },
        [](SkinMapping& m, double value) { m.size.y() = value; });
    addNumber(
        parent, sizer, "Skin turn", wxString::FromUTF8("\xC2\xB0"), -360, 360,
        [](const SkinMapping& m) { return m.angle * skinDegrees; },
        [](SkinMapping& m, double value) { m.angle = value / skinDegrees; });
}

void SkinSection::addNumber(wxWindow* parent, wxSizer* sizer, const wxString& name,
                            const wxString& unit, double low, double high,
                            double (*get)(const SkinMapping&), void (*set)(SkinMapping&, double)) {
    ValueSpec spec;
    spec.name = name;
    spec.unit = unit;
    spec.help = "Where the picture lies on the body, in the frame of its blueprint";
    spec.low = low;
    spec.high = high;
    spec.get = [this, get]() -> std::optional<double> {
        return mapping_ ? std::optional(get(*mapping_)) : std::nullopt;
    };
    spec.set = [this, set](double value) {
        if (!mapping_) return;
        Document& document = bench_.document();
        SkinMapping next = *mapping_;
        set(next, value);
        const auto place = [&] {
            document.change(bench_.selection(), [&](sulfur::scene::Prefab& prefab) {
                if (prefab.blueprint.skin) setMapping(prefab, next);
            });
        };
        setInStep(document, "Place the skin", place, refuse_);
        read();
    };
    spec.finish = [this] { bench_.document().commit(); };
    spec.refuse = refuse_;
    rows_.push_back(std::make_unique<ValueRow>(parent, sizer, std::move(spec)));
}

void SkinSection::read() {
    const Document& document = bench_.document();
    mapping_.reset();
    std::optional<std::string> same;
    bool able = false, mixed = false;
    for (const sulfur::BodyId body : bench_.selection()) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        const auto prefab = document.plan().dressed(id);
        const std::string texture = skinOf(prefab);
        if (same && *same != texture) mixed = true;
        same = texture;
        if (!able) able = canWear(document, body);
        if (bench_.selection().size() == 1) mapping_ = mappingOf(prefab);
    }
    const bool any = same && (mixed || !same->empty());
    choose_->Enable(able);
    remove_->Enable(any);
    handles_->Enable(mapping_.has_value());
    for (const auto& row : rows_) row->show(mapping_.has_value());
}

void SkinSection::refresh() {
    if (!mapping_) return;
    for (const auto& row : rows_) row->refresh();
}

}  // namespace sulfurchamber
