#include "lesson_panel.hpp"

#include <wx/sizer.h>

#include <algorithm>
#include <atlax/backend.hpp>
#include <utility>

#include "small_button.hpp"
#include "wrapped_text.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

LessonPanel::LessonPanel(wxWindow* parent, Workbench& bench, SceneView& view,
                         std::function<void(const std::string&)> act,
                         std::function<double()> played)
    : wxPanel(parent),
      bench_(bench),
      view_(view),
      act_(std::move(act)),
      played_(std::move(played)) {
    title_ = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                              wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    title_->SetFont(title_->GetFont().Bold());
    text_ =
        new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize, wxST_NO_AUTORESIZE);
    show_ = smallButton(this, wxTr("Show me"));
    skip_ = smallButton(this, wxTr("Skip"));
    auto* end = smallButton(this, wxTr("End"));
    show_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { showStep(); });
    skip_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { skipStep(); });
    end->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { stop(); });
    auto* buttons = new wxBoxSizer(wxHORIZONTAL);
    for (wxButton* button : {show_, skip_, end})
        buttons->Add(button, wxSizerFlags(0).Border(wxLEFT, FromDIP(4)));
    top_ = new wxBoxSizer(wxHORIZONTAL);
    top_->Add(title_, wxSizerFlags(1).CentreVertical());
    top_->Add(buttons, wxSizerFlags(0));
    auto* all = new wxBoxSizer(wxVERTICAL);
    all->Add(top_, wxSizerFlags(0).Expand());
    all->Add(text_, wxSizerFlags(0).Expand().Border(wxTOP, FromDIP(2)));
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(all, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(6)));
    SetSizer(border);
    Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
        event.Skip();
        wrap();
    });
    Hide();
}

void LessonPanel::start(const Lesson& lesson) {
    hand_.reset();
    run_.emplace(bench_, lesson, played_);
    Show();
    tell();
}

void LessonPanel::stop() {
    hand_.reset();
    run_.reset();
    view_.guide().showHand({}, false);
    Hide();
    GetParent()->Layout();
}

void LessonPanel::showStep() {
    if (!run_ || run_->finished() || hand_) return;
    hand_.emplace(run_->show(act_));
    movedNs_ = atlax::monotonicNs();
}

void LessonPanel::skipStep() {
    if (!run_) return;
    if (run_->finished()) {
        stop();
        return;
    }
    hand_.reset();
    run_->skip();
    tell();
}

// What a hand or a check throws ends the hand, and the learner goes on.
void LessonPanel::guarded(const std::function<void()>& body) {
    try {
        body();
    } catch (const std::exception& error) {
        hand_.reset();
        bench_.cancel();
        if (view_.onProblem) view_.onProblem(error.what());
    }
}

void LessonPanel::refresh() {
    if (!run_) return;
    const std::int64_t now = atlax::monotonicNs();
    const double seconds = std::min(0.1, static_cast<double>(now - movedNs_) / 1e9);
    movedNs_ = now;
    if (hand_) {
        guarded([&] { hand_->advance(seconds); });
        if (hand_ && hand_->done()) hand_.reset();
    }
    view_.guide().showHand(hand_ ? std::optional(hand_->place()) : std::nullopt,
                           hand_ && hand_->pressed());
    bool on = false;
    guarded([&] { on = run_->look(); });
    if (on) tell();
}

void LessonPanel::tell() {
    const auto count = run_->lesson().steps.size();
    const wxString lesson = wxTr(run_->lesson().title);
    title_->SetLabel(run_->finished() ? lesson
                                      : wxTr("{}: step {} of {}", {lesson.utf8_string(),
                                                                   std::to_string(run_->step() + 1),
                                                                   std::to_string(count)}));
    words_ = wxTr(run_->text());
    show_->Enable(!run_->finished());
    skip_->Enable(!run_->finished());
    wrap();
    GetParent()->Layout();
}

// As many lines as the words need at this width; buttons below the title where it is narrow.
void LessonPanel::wrap() {
    if (words_.empty()) return;
    const int width = GetClientSize().GetWidth() - FromDIP(14);
    const int wanted =
        title_->GetTextExtent(title_->GetLabel()).x + top_->GetItem(1)->GetMinSize().x;
    const bool wide = width > wanted + FromDIP(8);
    top_->SetOrientation(wide ? wxHORIZONTAL : wxVERTICAL);
    top_->GetItem(std::size_t{0})->SetFlag(wide ? int{wxALIGN_CENTRE_VERTICAL} : int{wxEXPAND});
    title_->SetMinSize(wxSize(FromDIP(40), title_->GetCharHeight()));
    showWrapped(*text_, words_, std::max(FromDIP(160), width));
    InvalidateBestSize();
    SetMinSize(wxSize(-1, GetSizer()->CalcMin().GetHeight()));
}

}  // namespace sulfurchamber
