#include "fitting_rows.hpp"

#include "property_spec.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

FittingRows::FittingRows(wxWindow* parent, wxSizer* sizer, Workbench& bench,
                         std::function<void(const std::string&)> refuse)
    : bench_(bench), refuse_(std::move(refuse)) {
    keys_ = new wxBoxSizer(wxVERTICAL);
    addKeyChoice(parent, keys_, "Key on", true);
    addKeyChoice(parent, keys_, "Key back", false);
    sizer->Add(keys_, wxSizerFlags(0).Expand().Border(wxBOTTOM, parent->FromDIP(6)));
    for (const FittingProperty& property : fittingProperties()) addRow(parent, sizer, property);
}

void FittingRows::addKeyChoice(wxWindow* parent, wxSizer* sizer, const char* label, bool forward) {
    wxArrayString names;
    names.Add(wxTr("none"));
    for (const std::string_view key : controlKeys()) names.Add(wxTr(key));
    auto* choice = new wxChoice(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, names);
    choice->SetToolTip(wxTr("While time runs this key drives it, as long as it is held"));
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    row->Add(new wxStaticText(parent, wxID_ANY, wxTr(label)), wxSizerFlags(1).CentreVertical());
    row->Add(choice, wxSizerFlags(1));
    sizer->Add(row, wxSizerFlags(0).Expand().Border(wxBOTTOM, parent->FromDIP(3)));
    (forward ? forward_ : back_) = choice;
    choice->Bind(wxEVT_CHOICE, [this, forward](wxCommandEvent& event) {
        const int at = event.GetInt() - 1;
        chooseKey(forward, at < 0 ? "" : std::string(controlKeys()[static_cast<std::size_t>(at)]));
    });
}

void FittingRows::chooseKey(bool forward, const std::string& key) {
    const auto ref = bench_.fitting();
    if (!ref) return;
    auto keys = keysOf(bench_.document().fitting(*ref));
    if (!keys) return;
    (forward ? keys->forward : keys->back) = key;
    try {
        bench_.document().edit("Choose a key",
                               [&] { setFittingKeys(bench_.document(), *ref, *keys); });
    } catch (const std::exception& problem) {
        refuse_(problem.what());
    }
}

std::optional<double> FittingRows::valueOf(const FittingProperty& property) const {
    const auto ref = bench_.fitting();
    return ref ? property.get(bench_.document().fitting(*ref)) : std::nullopt;
}

void FittingRows::addRow(wxWindow* parent, wxSizer* sizer, const FittingProperty& property) {
    rows_.push_back({});
    const std::size_t at = rows_.size() - 1;
    Row& row = rows_.back();
    row.property = &property;
    const std::string label = tr("Change {}", {trInside(std::string(property.name))});
    ValueSpec spec = specOf(property);
    spec.get = [this, &property] { return valueOf(property); };
    spec.initial = [this, at] { return rows_[at].first; };
    spec.set = [this, &property, label](double value) {
        const auto ref = bench_.fitting();
        if (!ref) return;
        Document& document = bench_.document();
        setInStep(
            document, label, [&] { setFittingProperty(document, *ref, property, value); }, refuse_);
    };
    spec.finish = [this] {
        try {
            bench_.document().commit();
        } catch (const std::exception& problem) {
            refuse_(problem.what());
        }
    };
    spec.refuse = refuse_;
    row.row = std::make_unique<ValueRow>(parent, sizer, std::move(spec));
}

void FittingRows::showKeys(const std::optional<DriveKeys>& keys) {
    keys_->ShowItems(keys.has_value());
    if (!keys) return;
    const auto select = [](wxChoice* choice, const std::string& key) {
        choice->SetSelection(std::max(0, choice->FindString(wxTr(key), true)));
    };
    select(forward_, keys->forward);
    select(back_, keys->back);
}

bool FittingRows::refresh() {
    const auto ref = bench_.fitting();
    const std::uint64_t revision = bench_.document().revision();
    bool changed = false;
    if (fresh_ || ref != shown_ || revision != revision_) {
        std::optional<Fitting> fitting;
        if (ref) fitting = bench_.document().fitting(*ref);
        showKeys(fitting ? keysOf(*fitting) : std::nullopt);
        for (Row& row : rows_) {
            const auto value = fitting ? row.property->get(*fitting) : std::nullopt;
            if (fresh_ || ref != shown_) row.first = value;
            if (fresh_ || row.shown != value.has_value()) changed = true;
            row.shown = value.has_value();
            row.row->show(row.shown);
        }
        changed = changed || ref != shown_;
        shown_ = ref;
        revision_ = revision;
        fresh_ = false;
    }
    for (Row& row : rows_)
        if (row.shown) row.row->refresh();
    return changed;
}

}  // namespace sulfurchamber
