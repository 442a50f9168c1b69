#include "outline_panel.hpp"

#include <wx/menu.h>
#include <wx/sizer.h>
#include <wx/textdlg.h>

#include <algorithm>
#include <array>
#include <set>

#include "icons.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

// In the order of the pictures of the list.
enum Picture : int {
    pictureGroup,
    pictureBody,
    pictureMechanism,
    pictureField,
    pictureSeen,
    pictureHidden,
    pictureFree,
    pictureLocked
};
constexpr std::array<const char*, 8> pictureNames{"group", "box",    "joint",  "field",
                                                  "eye",   "hidden", "unlock", "lock"};
constexpr int columnName = 0;
constexpr int columnEye = 1;
constexpr int columnLock = 2;
constexpr int spacesOfDepth = 4;
const wxString opened = wxString::FromUTF8("\xE2\x96\xBE ");  // a triangle down, and to the right
const wxString closed = wxString::FromUTF8("\xE2\x96\xB8 ");

}  // namespace

class OutlinePanel::List final : public wxListCtrl {
public:
    List(wxWindow* parent, const OutlinePanel& panel)
        : wxListCtrl(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                     wxLC_REPORT | wxLC_VIRTUAL | wxLC_NO_HEADER | wxBORDER_NONE),
          panel_(panel) {
        wxVector<wxBitmapBundle> pictures;
        for (const char* name : pictureNames) pictures.push_back(icon(name, 16));
        SetSmallImages(pictures);
        AppendColumn("");
        AppendColumn("", wxLIST_FORMAT_LEFT, parent->FromDIP(26));
        AppendColumn("", wxLIST_FORMAT_LEFT, parent->FromDIP(26));
        Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
            event.Skip();
            fitName();
        });
    }

    void fitName() {
        const int rest = GetClientSize().GetWidth() - 2 * FromDIP(26);
        SetColumnWidth(columnName, std::max(FromDIP(60), rest));
    }

    wxString OnGetItemText(long item, long column) const override {
        if (column != columnName) return "";
        const OutlineRow& row = at(item);
        wxString text(' ', static_cast<std::size_t>(row.depth * spacesOfDepth));
        if (row.kind == OutlineRow::Kind::group) text += row.open ? opened : closed;
        return text + wxString::FromUTF8(row.name);
    }
    int OnGetItemImage(long item) const override { return OnGetItemColumnImage(item, columnName); }
    int OnGetItemColumnImage(long item, long column) const override {
        const OutlineRow& row = at(item);
        const bool marked =
            row.kind == OutlineRow::Kind::group || row.kind == OutlineRow::Kind::body;
        if (column == columnEye && marked) return row.hidden ? pictureHidden : pictureSeen;
        if (column == columnLock && marked) return row.locked ? pictureLocked : pictureFree;
        if (column != columnName) return -1;
        switch (row.kind) {
            case OutlineRow::Kind::group:
                return pictureGroup;
            case OutlineRow::Kind::mechanism:
                return pictureMechanism;
            case OutlineRow::Kind::field:
                return pictureField;
            case OutlineRow::Kind::body:
                break;
        }
        return pictureBody;
    }

private:
    const OutlineRow& at(long item) const {
        static const OutlineRow none;
        const auto place = static_cast<std::size_t>(item);
        return panel_.rows_ != nullptr && place < panel_.rows_->size() ? (*panel_.rows_)[place]
                                                                       : none;
    }

    const OutlinePanel& panel_;
};

OutlinePanel::OutlinePanel(wxWindow* parent, Workbench& bench, SceneView& view,
                           std::function<void(const std::string&)> refuse)
    : wxPanel(parent), bench_(bench), view_(view), refuse_(std::move(refuse)) {
    search_ = new wxSearchCtrl(this, wxID_ANY);
    search_->SetDescriptiveText(wxTr("Search"));
    search_->ShowCancelButton(true);
    search_->SetToolTip(wxTr("Only what has this text in its name"));
    list_ = new List(this, *this);
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(search_, wxSizerFlags(0).Expand().Border(wxALL, FromDIP(4)));
    sizer->Add(list_, wxSizerFlags(1).Expand());
    SetSizer(sizer);
    bind();
}

void OutlinePanel::bind() {
    search_->Bind(wxEVT_TEXT,
                  [this](wxCommandEvent&) { search(search_->GetValue().utf8_string()); });
    search_->Bind(wxEVT_SEARCH_CANCEL, [this](wxCommandEvent&) { search_->Clear(); });
    list_->Bind(wxEVT_LEFT_DOWN, &OutlinePanel::clicked, this);
    // A click on a row of many sends several of these: what is selected is asked once.
    const auto selected = [this](wxListEvent& event) {
        event.Skip();
        if (showing_ || std::exchange(selecting_, true)) return;
        CallAfter([this] { select(); });
    };
    // What a click takes out of the selection is taken out when the button comes up.
    list_->Bind(wxEVT_LEFT_UP, [this](wxMouseEvent& event) {
        event.Skip();
        if (clickedRow_ && !std::exchange(selecting_, true)) CallAfter([this] { select(); });
        clickedRow_ = false;
    });
    list_->Bind(wxEVT_LIST_ITEM_SELECTED, selected);
    list_->Bind(wxEVT_LIST_ITEM_DESELECTED, selected);
    list_->Bind(wxEVT_LIST_ITEM_FOCUSED, selected);
    list_->Bind(wxEVT_LIST_ITEM_ACTIVATED,
                [this](wxListEvent& event) { zoom(static_cast<std::size_t>(event.GetIndex())); });
    list_->Bind(wxEVT_LIST_ITEM_RIGHT_CLICK,
                [this](wxListEvent& event) { popUp(static_cast<std::size_t>(event.GetIndex())); });
    list_->Bind(wxEVT_LIST_KEY_DOWN, [this](wxListEvent& event) {
        const long focused = list_->GetNextItem(-1, wxLIST_NEXT_ALL, wxLIST_STATE_FOCUSED);
        if (event.GetKeyCode() == WXK_F2 && focused >= 0)
            rename(static_cast<std::size_t>(focused));
        else
            event.Skip();
    });
}

void OutlinePanel::guarded(const std::function<void()>& change) {
    try {
        change();
    } catch (const std::exception& problem) {
        refuse_(problem.what());
    }
    refresh();
}

void OutlinePanel::search(const std::string& text) {
    if (search_->GetValue().utf8_string() != text) search_->ChangeValue(wxString::FromUTF8(text));
    outliner_.setSearch(text);
    refresh();
}

// Eye, lock and the triangle of a group act; all else is the list's.
void OutlinePanel::clicked(wxMouseEvent& event) {
    int flags = 0;
    const long item = list_->HitTest(event.GetPosition(), flags);
    clickedRow_ = false;
    const auto place = static_cast<std::size_t>(item);
    if (item < 0 || rows_ == nullptr || place >= rows_->size()) {
        event.Skip();
        return;
    }
    const OutlineRow row = (*rows_)[place];
    const int x = event.GetX();
    const int name = list_->GetColumnWidth(columnName);
    const int eye = name + list_->GetColumnWidth(columnEye);
    const bool marked = row.kind == OutlineRow::Kind::group || row.kind == OutlineRow::Kind::body;
    if (x >= name && marked) {
        guarded([&] {
            if (x < eye)
                setHidden(bench_, row.bodies, !row.hidden);
            else
                setLocked(bench_, row.bodies, !row.locked);
        });
    } else if (row.kind == OutlineRow::Kind::group &&
               x < list_->ScreenToClient(placeOnScreen(place, "arrow")).x + FromDIP(10)) {
        outliner_.toggle(row.group);
        refresh();
    } else {
        clickedRow_ = true;
        // The list of wxWidgets keeps what was selected by others.
        showing_ = true;
        for (long other = -1;
             !event.CmdDown() && !event.ShiftDown() &&
             (other = list_->GetNextItem(other, wxLIST_NEXT_ALL, wxLIST_STATE_SELECTED)) >= 0;)
            list_->SetItemState(other, 0, wxLIST_STATE_SELECTED);
        showing_ = false;
        event.Skip();
    }
}

wxPoint OutlinePanel::placeOnScreen(std::size_t row, const std::string& part) const {
    wxRect rect;
    if (!list_->GetItemRect(static_cast<long>(row), rect)) return list_->GetScreenPosition();
    const int name = list_->GetColumnWidth(columnName);
    int x = name - FromDIP(8);
    if (part == "eye") x = name + list_->GetColumnWidth(columnEye) / 2;
    if (part == "lock") x = name + list_->GetColumnWidth(columnEye) * 3 / 2;
    if (part == "arrow") {
        const int depth = rows_ == nullptr || row >= rows_->size() ? 0 : (*rows_)[row].depth;
        const wxString before(' ', static_cast<std::size_t>(depth * spacesOfDepth));
        x = rect.GetLeft() + FromDIP(16 + 8) + list_->GetTextExtent(before).GetWidth() +
            list_->GetTextExtent(opened).GetWidth() / 2;
    }
    return list_->ClientToScreen(wxPoint(x, rect.GetTop() + rect.GetHeight() / 2));
}

// --- selection -------------------------------------------------------------------------------

void OutlinePanel::select() {
    selecting_ = false;
    if (rows_ == nullptr) return;
    std::vector<sulfur::BodyId> bodies;
    std::optional<FittingRef> fitting;
    int chosen = 0;
    for (long item = -1;
         (item = list_->GetNextItem(item, wxLIST_NEXT_ALL, wxLIST_STATE_SELECTED)) >= 0;) {
        const OutlineRow& row = rows_->at(static_cast<std::size_t>(item));
        if (!row.fitting) bodies.insert(bodies.end(), row.bodies.begin(), row.bodies.end());
        fitting = row.fitting;
        ++chosen;
    }
    bench_.cancel();
    if (chosen == 1 && fitting)
        bench_.chooseFitting(fitting);
    else
        bench_.select(std::move(bodies));
    shownSelection_ = bench_.selection();
}

// What is selected in the scene is marked here, and brought into view.
void OutlinePanel::showSelection() {
    shownSelection_ = bench_.selection();
    showing_ = true;
    long first = -1;
    for (std::size_t i = 0; i < rows_->size(); ++i) {
        const OutlineRow& row = (*rows_)[i];
        const bool on = row.kind == OutlineRow::Kind::body && !row.bodies.empty() &&
                        bench_.selected(row.bodies.front());
        const auto item = static_cast<long>(i);
        const bool was = list_->GetItemState(item, wxLIST_STATE_SELECTED) != 0;
        if (on != was)
            list_->SetItemState(item, on ? wxLIST_STATE_SELECTED : 0, wxLIST_STATE_SELECTED);
        if (on && first < 0) first = item;
    }
    if (first >= 0) list_->EnsureVisible(first);
    showing_ = false;
}

void OutlinePanel::refresh() {
    rows_ = &outliner_.rows(bench_);
    const bool others = outliner_.version() != shownVersion_;
    if (others) {
        shownVersion_ = outliner_.version();
        showing_ = true;
        list_->SetItemCount(static_cast<long>(rows_->size()));
        list_->Refresh();
        showing_ = false;
    }
    if ((others || shownSelection_ != bench_.selection()) && !selecting_) showSelection();
}

// --- doing -----------------------------------------------------------------------------------

void OutlinePanel::zoom(std::size_t row) {
    if (rows_ == nullptr || row >= rows_->size()) return;
    if (const auto bounds = boundsOf(bench_, (*rows_)[row])) view_.zoomTo(*bounds);
}

void OutlinePanel::rename(std::size_t row) {
    if (rows_ == nullptr || row >= rows_->size() || !(*rows_)[row].renamable) return;
    const OutlineRow old = (*rows_)[row];
    wxTextEntryDialog dialog(this, wxTr("Name"), wxTr("Rename"), wxString::FromUTF8(old.name));
    if (dialog.ShowModal() != wxID_OK) return;
    const std::string wanted = dialog.GetValue().Strip(wxString::both).utf8_string();
    if (wanted != old.name) guarded([&] { sulfurchamber::rename(bench_, old, wanted); });
}

void OutlinePanel::popUp(std::size_t place) {
    if (rows_ == nullptr || place >= rows_->size()) return;
    const OutlineRow row = (*rows_)[place];
    wxMenu menu;
    const auto add = [&](const wxString& label, bool enabled, const std::function<void()>& run) {
        wxMenuItem* item = menu.Append(wxID_ANY, label);
        item->Enable(enabled);
        menu.Bind(
            wxEVT_MENU, [run](wxCommandEvent&) { run(); }, item->GetId());
    };
    const bool any = !row.bodies.empty();
    const bool marked = row.kind == OutlineRow::Kind::group || row.kind == OutlineRow::Kind::body;
    add(wxTr("&Zoom to it"), any, [&] { zoom(place); });
    add(wxTr("&Rename"), row.renamable, [&] { rename(place); });
    add(wxTr(row.hidden ? "S&how" : "&Hide"), any && marked,
        [&] { guarded([&] { setHidden(bench_, row.bodies, !row.hidden); }); });
    add(wxTr(row.locked ? "Un&lock" : "&Lock"), any && marked,
        [&] { guarded([&] { setLocked(bench_, row.bodies, !row.locked); }); });
    PopupMenu(&menu);
}

}  // namespace sulfurchamber
