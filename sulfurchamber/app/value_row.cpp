#include "value_row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "icons.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr int sliderSteps = 1000;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Six digits, or three and a power of ten: nothing that it gives is wider than these.
constexpr const char* widest = "-88888.8";
constexpr const char* widestLarge = "-8.88e88";
wxString shortNumber(double value) {
    const double size = std::abs(value);
    if (size >= 1e5) {
        wxString text = wxString::Format("%.3g", value);
        text.Replace("e+0", "e");
        text.Replace("e+", "e");
        return text;
    }
    return wxString::Format("%g", std::round(value * 1000) / 1000 + 0.0);  // never "-0"
}

}  // namespace

ValueRow::ValueRow(wxWindow* parent, wxSizer* sizer, ValueSpec spec) : spec_(std::move(spec)) {
    for (wxString* text : {&spec_.name, &spec_.help, &spec_.endless}) *text = wxTr(*text);
    makeTop(parent);
    makeSlider(parent);
    whole_ = new wxBoxSizer(wxVERTICAL);
    whole_->Add(top_, wxSizerFlags(0).Expand());
    whole_->Add(bottom_, wxSizerFlags(0).Expand().Border(wxBOTTOM, parent->FromDIP(4)));
    sizer->Add(whole_, wxSizerFlags(0).Expand());
    for (wxWindow* window : {static_cast<wxWindow*>(name_), static_cast<wxWindow*>(number_),
                             static_cast<wxWindow*>(slider_)})
        window->SetToolTip(spec_.help);
    bind();
}

void ValueRow::makeTop(wxWindow* parent) {
    top_ = new wxBoxSizer(wxHORIZONTAL);
    name_ = new wxStaticText(parent, wxID_ANY, spec_.name, wxDefaultPosition, wxDefaultSize,
                             wxST_ELLIPSIZE_END);
    number_ = new wxTextCtrl(parent, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                             wxTE_RIGHT | wxTE_PROCESS_ENTER);
    int room = 0;
    for (const wxString& text : {wxString(widest), wxString(widestLarge), wxTr("mixed")})
        room = std::max(room, number_->GetTextExtent(text).x);
    number_->SetMinSize({room + parent->FromDIP(fieldEdges), -1});
    auto* unit = new wxStaticText(parent, wxID_ANY, spec_.unit);
    // One below the other, but for long ones such as "N m s/rad".
    unit->SetMinSize({std::max(parent->FromDIP(42), unit->GetTextExtent(spec_.unit).x + 1), -1});
    top_->Add(name_, wxSizerFlags(1).CentreVertical());
    top_->Add(number_, wxSizerFlags(0).CentreVertical());
    top_->Add(unit, wxSizerFlags(0).CentreVertical().Border(wxLEFT, parent->FromDIP(4)));
}

// The slider between the ends of its range, and the button, for which names leave no room above.
void ValueRow::makeSlider(wxWindow* parent) {
    bottom_ = new wxBoxSizer(wxHORIZONTAL);
    slider_ = new wxSlider(parent, wxID_ANY, 0, 0, sliderSteps);
    const auto end = [&](const wxString& text) {
        auto* label = new wxStaticText(parent, wxID_ANY, text);
        label->SetFont(label->GetFont().Smaller());
        label->SetMinSize(label->GetTextExtent(text));  // GTK may ask for a pixel less
        bottom_->Add(label, wxSizerFlags(0).CentreVertical());
    };
    end(shortNumber(spec_.low));
    bottom_->Add(slider_, wxSizerFlags(1).CentreVertical());
    end(spec_.endless.empty() ? shortNumber(spec_.high) : spec_.endless);
    revert_ = new wxBitmapButton(parent, wxID_ANY, icon("revert"), wxDefaultPosition, wxDefaultSize,
                                 wxBU_EXACTFIT | wxBORDER_NONE);
    revert_->SetToolTip(wxTr("Back to what the scene began with"));
    bottom_->Add(revert_, wxSizerFlags(0).CentreVertical());
}

void ValueRow::bind() {
    slider_->Bind(wxEVT_SLIDER, [this](wxCommandEvent&) {
        sliding_ = true;
        const double wanted = value(slider_->GetValue());
        if (spec_.get() != wanted) spec_.set(wanted);
        refresh();
    });
    const auto released = [this](wxEvent& event) {
        if (std::exchange(sliding_, false)) spec_.finish();
        event.Skip();
    };
    slider_->Bind(wxEVT_SCROLL_THUMBRELEASE, [released](wxScrollEvent& e) { released(e); });
    slider_->Bind(wxEVT_KEY_UP, [released](wxKeyEvent& e) { released(e); });
    slider_->Bind(wxEVT_KILL_FOCUS, [released](wxFocusEvent& e) { released(e); });
    number_->Bind(wxEVT_TEXT_ENTER, [this](wxCommandEvent&) { enter(false); });
    number_->Bind(wxEVT_KILL_FOCUS, [this](wxFocusEvent& event) {
        if (number_->IsModified()) enter(true);
        number_->SelectNone();  // else it goes on looking as if keys went there
        event.Skip();
    });
    number_->Bind(wxEVT_KEY_DOWN, [this](wxKeyEvent& event) {
        if (event.GetKeyCode() == WXK_ESCAPE)
            takeBack();
        else
            event.Skip();
    });
    revert_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) {
        const auto first = spec_.initial ? spec_.initial() : std::nullopt;
        if (!first) return;
        spec_.finish();
        spec_.set(*first);
        spec_.finish();
        refresh();
    });
}

void ValueRow::mark(bool on) {
    if (std::exchange(marked_, on) == on) return;
    name_->SetFont(on ? name_->GetFont().Bold() : name_->GetParent()->GetFont());
    const wxString dot = wxString::FromUTF8("\xE2\x97\x86 ");
    name_->SetLabel(on ? dot + spec_.name : spec_.name);
    name_->SetToolTip(on ? spec_.help + "\n" + wxTr("It differs from the template.") : spec_.help);
}

// Where in its range a value is, 0 to 1, and back.
double ValueRow::share(double value) const {
    const double low = spec_.low;
    const double high = spec_.high;
    switch (spec_.scale) {
        case Scale::logarithmic:
            return std::log(std::max(value, low) / low) / std::log(high / low);
        case Scale::cubic:
            return std::cbrt((value - low) / (high - low));
        case Scale::linear:
            break;
    }
    return (value - low) / (high - low);
}

double ValueRow::ofShare(double share) const {
    const double low = spec_.low;
    const double high = spec_.high;
    switch (spec_.scale) {
        case Scale::logarithmic:
            return low * std::pow(high / low, share);
        case Scale::cubic:
            return low + share * share * share * (high - low);
        case Scale::linear:
            break;
    }
    return low + share * (high - low);
}

int ValueRow::position(double value) const {
    if (!spec_.endless.empty() && std::isinf(value)) return sliderSteps;
    const int last = spec_.endless.empty() ? sliderSteps : sliderSteps - 1;
    return static_cast<int>(std::lround(std::clamp(share(value), 0.0, 1.0) * last));
}

double ValueRow::value(int position) const {
    if (!spec_.endless.empty() && position == sliderSteps) return infinite;
    const int last = spec_.endless.empty() ? sliderSteps : sliderSteps - 1;
    const double exact = ofShare(static_cast<double>(position) / last);
    if (spec_.whole) return std::round(exact);
    if (spec_.scale == Scale::linear)
        return std::clamp(std::round(exact * 100) / 100, spec_.low, spec_.high);
    // Three digits, which is what one can read.
    if (exact == 0) return 0;
    const double digit = std::pow(10, std::floor(std::log10(std::abs(exact))) - 2);
    return std::clamp(std::round(exact / digit) * digit, spec_.low, spec_.high);
}

wxString ValueRow::text(std::optional<double> value) const {
    if (!value) return "";
    if (std::isinf(*value)) return spec_.endless;
    return shortNumber(*value);
}

void ValueRow::refresh() {
    const auto now = spec_.get();
    const bool typing = spec_.moves && number_->IsModified();
    if (fresh_ || (now != shown_ && !typing)) {
        if (!sliding_) slider_->SetValue(now ? position(*now) : 0);
        number_->SetHint(now ? wxString() : wxTr("mixed"));
        takeBack();
    }
    shown_ = now;
    fresh_ = false;
    const auto first = spec_.initial ? spec_.initial() : std::nullopt;
    const bool changed = first && now != first;
    if (revert_->IsEnabled() != changed) revert_->Enable(changed);
}

void ValueRow::takeBack() {
    number_->ChangeValue(text(spec_.get()));
    number_->DiscardEdits();
    number_->SetForegroundColour(wxNullColour);
}

void ValueRow::enter(bool leaving) {
    const wxString typed = number_->GetValue().Strip(wxString::both);
    double wanted = 0;
    const bool endless = !spec_.endless.empty() && typed.CmpNoCase(spec_.endless) == 0;
    const bool isNumber = typed.ToDouble(&wanted) || typed.ToCDouble(&wanted);
    if (endless) wanted = infinite;
    const bool inRange = std::isfinite(wanted) && wanted >= spec_.low && wanted <= spec_.high;
    if (endless || (isNumber && inRange)) {
        spec_.finish();
        if (spec_.get() != wanted) spec_.set(wanted);
        spec_.finish();
        takeBack();
        refresh();
        return;
    }
    if (leaving && typed.empty()) {
        takeBack();
        return;
    }
    const std::string word = typed.utf8_string();
    const std::string problem =
        isNumber ? tr("{} is out of range", {word}) : tr("{} is no number", {word});
    std::string range =
        tr("{} to {} {}", {shortNumber(spec_.low).utf8_string(),
                           shortNumber(spec_.high).utf8_string(), spec_.unit.utf8_string()});
    if (!spec_.endless.empty()) range = tr("{}, or {}", {range, spec_.endless.utf8_string()});
    spec_.refuse(tr("{}: {}; allowed is {}", {spec_.name.utf8_string(), problem, range}));
    if (leaving)
        takeBack();
    else
        number_->SetForegroundColour(wxColour(0xFF, 0x5E, 0x57));
}

void ValueRow::show(bool on) {
    whole_->ShowItems(on);
}

}  // namespace sulfurchamber
