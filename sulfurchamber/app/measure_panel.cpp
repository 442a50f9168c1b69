#include "measure_panel.hpp"

#include <wx/sizer.h>

#include <algorithm>
#include <cmath>

#include "../model/geometry.hpp"
#include "../model/refusals.hpp"
#include "../model/stage_times.hpp"
#include "../view/meter_painter.hpp"
#include "small_button.hpp"
#include "wrapped_text.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr double searchMilliseconds = 8;  // of a refresh

wxString numberWith(double value, const std::string& unit) {
    wxString text = wxString::Format("%.4g ", value) + wxString::FromUTF8(unit);
    text.Replace("-", wxString::FromUTF8("\xE2\x88\x92"));
    return text;
}

// As many digits as tell a ten-thousandth of what is expected.
wxString differenceWith(double value, double expected, const std::string& unit) {
    const double size = std::max(std::abs(expected), 1e-6);
    const int digits = std::clamp(4 - static_cast<int>(std::ceil(std::log10(size))), 0, 9);
    wxString text = wxString::Format("%+.*f ", digits, value) + wxString::FromUTF8(unit);
    text.Replace("-", wxString::FromUTF8("\xE2\x88\x92"));
    return text;
}

wxString shareOf(std::size_t part, std::size_t all) {
    return wxTr("{} of {}", {std::to_string(part), std::to_string(all)});
}

wxString stageWords(sulfur::Stage stage) {
    return "   " + wxTr(stageTitle(stage));
}

// On a page that was never shown GTK tells the size of the usual font.
void giveRoom(wxStaticText* heading) {
    heading->SetMinSize(heading->GetTextExtent(heading->GetLabel()) +
                        heading->FromDIP(wxSize(2, 0)));
}

}  // namespace

MeasurePanel::MeasurePanel(wxWindow* parent, Workbench& bench, SceneView& view)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      view_(view) {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    makeTextbook(sizer);
    makeMeters(sizer);
    makeStages(sizer);
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(sizer, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(8)));
    SetSizer(border);
    SetScrollRate(0, FromDIP(12));
    refresh();
}

// --- making ----------------------------------------------------------------------------------

wxStaticText* MeasurePanel::heading(const wxString& text, wxSizer* sizer) {
    auto* heading = new wxStaticText(this, wxID_ANY, wxTr(text));
    heading->SetFont(heading->GetFont().Bold().Larger());
    giveRoom(heading);
    sizer->Add(heading, wxSizerFlags(0).Border(wxBOTTOM, FromDIP(4)));
    return heading;
}

wxStaticText* MeasurePanel::line(wxSizer* table, const wxString& name) {
    table->Add(new wxStaticText(this, wxID_ANY, wxTr(name)), wxSizerFlags(0));
    auto* value = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                                   wxALIGN_RIGHT | wxST_NO_AUTORESIZE);
    table->Add(value, wxSizerFlags(0).Expand());
    return value;
}

void MeasurePanel::makeTextbook(wxSizer* sizer) {
    title_ = heading("Expected and measured", sizer);
    advice_ = new wxStaticText(this, wxID_ANY, "");
    sizer->Add(advice_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    static constexpr std::array<const char*, 3> names{"Expected", "Measured", "Difference"};
    for (Block& block : blocks_) {
        block.name = new wxStaticText(this, wxID_ANY, "");
        block.name->SetFont(block.name->GetFont().Bold());
        block.formula = new wxStaticText(this, wxID_ANY, "");
        sizer->Add(block.name);
        sizer->Add(block.formula, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(3)));
        auto* table = new wxFlexGridSizer(2, FromDIP(3), FromDIP(8));
        table->AddGrowableCol(1);
        for (std::size_t i = 0; i < names.size(); ++i) block.values[i] = line(table, names[i]);
        sizer->Add(table, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(8)));
        block.all = {block.name, block.formula};
        for (wxSizerItem* item : table->GetChildren()) block.all.push_back(item->GetWindow());
    }
}

void MeasurePanel::makeMeters(wxSizer* sizer) {
    heading("Meters", sizer);
    meters_ = new wxListView(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(-1, 92)),
                             wxLC_REPORT | wxLC_NO_HEADER | wxLC_SINGLE_SEL);
    meters_->SetToolTip(wxTr("The meters of the scene with what they show; a click selects one"));
    meters_->AppendColumn(wxTr("Meter"), wxLIST_FORMAT_LEFT, FromDIP(110));
    meters_->AppendColumn(wxTr("Shows"), wxLIST_FORMAT_RIGHT, FromDIP(90));
    sizer->Add(meters_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(8)));
    meters_->Bind(wxEVT_LIST_ITEM_SELECTED, [this](wxListEvent& event) {
        const auto& all = bench_.meters().all();
        const auto row = static_cast<std::size_t>(std::max(0L, event.GetIndex()));
        if (row < all.size() && !bench_.meterSelected(all[row].id))
            bench_.selectMeters({all[row].id});
    });
}

void MeasurePanel::makeStages(wxSizer* sizer) {
    heading("A tick", sizer);
    auto* table = new wxFlexGridSizer(2, FromDIP(2), FromDIP(8));
    table->AddGrowableCol(1);
    for (const char* name : {"Share of real time", "Load of a core", "Bodies awake",
                             "Particles awake", "Joints", "Contacts", "Time of a tick"})
        totals_.push_back(line(table, name));
    for (std::size_t i = 0; i < stages_.size(); ++i)
        stages_[i] = line(table, stageWords(static_cast<sulfur::Stage>(i)));
    sizer->Add(table, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    search_ = smallButton(this, wxTr("What costs most?"));
    search_->SetToolTip(
        wxTr("Lets copies of the scene go on without one object after the other, and compares"));
    search_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { findDearest(); });
    sizer->Add(search_, wxSizerFlags(0));
    found_ = new wxStaticText(this, wxID_ANY, "");
    sizer->Add(found_, wxSizerFlags(0).Expand().Border(wxTOP, FromDIP(4)));
}

// --- showing ---------------------------------------------------------------------------------

void MeasurePanel::watch(bool on) {
    bench_.setStageTimes(on);
}

void MeasurePanel::set(wxStaticText* field, const wxString& text) {
    if (field->GetLabel() != text) field->SetLabel(text);
}

void MeasurePanel::refresh() {
    refreshTextbook();
    refreshMeters();
    refreshStages();
    refreshSearch();
}

void MeasurePanel::refreshTextbook() {
    const Textbook& textbook = bench_.textbook();
    const auto findings = textbook.findings();
    const std::string problem = textbook.problem();
    const std::string name(textbook.title());
    const wxString title = wxTr(name.empty() ? "Expected and measured" : name);
    if (title_->GetLabel() != title) {
        title_->SetLabel(title);
        giveRoom(title_);
        Layout();
    }
    wxString advice;
    if (!problem.empty())
        advice = wxString::FromUTF8(trRefusal(problem));
    else if (findings.empty())
        advice = wxTr(
            "The textbook scenes among the examples (F1) compare a formula with what happens.");
    const std::size_t count = std::min(findings.size(), mostFindings);
    if (advice_->GetLabel() != advice || count != shownBlocks_) {
        showWrapped(*advice_, advice,
                    std::max(FromDIP(120), GetClientSize().GetWidth() - FromDIP(20)));
        advice_->Show(!advice.empty());
        for (std::size_t i = 0; i < mostFindings; ++i)
            for (wxWindow* window : blocks_[i].all) window->Show(i < count);
        shownBlocks_ = count;
        for (std::size_t i = 0; i < count; ++i) show(blocks_[i], findings[i]);
        FitInside();
        Layout();
    }
    for (std::size_t i = 0; i < count; ++i) show(blocks_[i], findings[i]);
}

void MeasurePanel::show(Block& block, const Finding& finding) {
    set(block.name, wxTr(finding.name));
    const wxString formula = wxTr(finding.formula);
    if (block.formula->GetToolTipText() != formula) {
        block.formula->SetToolTip(formula);
        showWrapped(*block.formula, formula,
                    std::max(FromDIP(120), GetClientSize().GetWidth() - FromDIP(20)));
        FitInside();
        Layout();
    }
    set(block.values[0], numberWith(finding.expected, finding.unit));
    const wxString none = wxString::FromUTF8("\xE2\x80\xA6");
    set(block.values[1], finding.measured ? numberWith(*finding.measured, finding.unit) : none);
    const auto difference = finding.difference();
    set(block.values[2],
        difference ? differenceWith(*difference, finding.expected, finding.unit) : none);
    block.values[2]->SetForegroundColour(
        difference && std::abs(*difference) > finding.bound ? wxColour(220, 60, 50) : wxNullColour);
    const wxString within =
        wxTr("Within {} is expected", {numberWith(finding.bound, finding.unit).utf8_string()});
    if (block.values[2]->GetToolTipText() != within) block.values[2]->SetToolTip(within);
}

void MeasurePanel::refreshMeters() {
    const auto& all = bench_.meters().all();
    while (meters_->GetItemCount() > static_cast<int>(all.size()))
        meters_->DeleteItem(meters_->GetItemCount() - 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const long row = static_cast<long>(i);
        if (row >= meters_->GetItemCount()) meters_->InsertItem(row, "");
        const wxString id = wxString::FromUTF8(all[i].id);
        const wxString reading = wxString::FromUTF8(meterText(bench_.meters(), all[i]));
        if (meters_->GetItemText(row, 0) != id) meters_->SetItem(row, 0, id);
        if (meters_->GetItemText(row, 1) != reading) meters_->SetItem(row, 1, reading);
        const bool selected = bench_.meterSelected(all[i].id);
        if (meters_->IsSelected(row) != selected) meters_->Select(row, selected);
    }
}

void MeasurePanel::refreshStages() {
    const sulfur::World& world = bench_.document().world();
    const auto& statistics = world.statistics();
    const Totals sums = totals(world);
    std::size_t awake = 0, moving = 0;
    for (const sulfur::BodyId body : world.bodies()) {
        if (world.kind(body) == sulfur::BodyKind::fixed) continue;
        ++moving;
        if (!world.asleep(body)) ++awake;
    }
    const StageTimes& times = bench_.stageTimes();
    const double tick = times.seconds();
    const std::array<wxString, 7> values{
        wxString::Format("%.0f %%", view_.realTimeShare() * view_.speedPermille() / 10.0),
        wxString::Format("%.1f %%", times.load(world.settings().tickRate) * 100),
        shareOf(awake, moving),
        shareOf(sums.awakeParticles, sums.particles),
        wxString::Format("%zu", sums.rigidJoints + sums.elasticJoints),
        wxString::Format("%u", statistics.contacts),
        wxString::Format(wxString::FromUTF8("%.1f \xC2\xB5s"), tick * 1e6)};
    for (std::size_t i = 0; i < values.size(); ++i) set(totals_[i], values[i]);
    for (std::size_t i = 0; i < stages_.size(); ++i) {
        const double one = times.seconds(static_cast<sulfur::Stage>(i));
        set(stages_[i], tick > 0 ? wxString::Format(wxString::FromUTF8("%.1f \xC2\xB5s  %3.0f %%"),
                                                    one * 1e6, one / tick * 100)
                                 : wxString::FromUTF8("\xE2\x80\x93"));
    }
}

// --- what costs most -------------------------------------------------------------------------

void MeasurePanel::findDearest() {
    dearest_.clear();
    costs_.emplace(bench_.document());
}

void MeasurePanel::refreshSearch() {
    if (!costs_) return;
    wxString text;
    if (costs_->goOn(searchMilliseconds)) {
        const auto costs = costs_->costs();
        costs_.reset();
        for (std::size_t i = 0; i < std::min<std::size_t>(3, costs.size()); ++i)
            text += (i == 0 ? "" : "\n") +
                    wxTr("{}: {} % of a tick", {costs[i].name, fixed(costs[i].share * 100, 0)});
        if (text.empty()) text = wxTr("Nothing stands out: no object costs much by itself.");
        dearest_ = text.utf8_string();
    } else {
        text = wxTr("Trying\xE2\x80\xA6 {} %", {fixed(costs_->progress() * 100, 0)});
    }
    if (found_->GetLabel() == text) return;
    showWrapped(*found_, text, std::max(FromDIP(120), GetClientSize().GetWidth() - FromDIP(20)));
    FitInside();
    Layout();
}

}  // namespace sulfurchamber
