// A page of the side panel: what formulas expect and what is measured, meters, and where the time
// of the ticks goes.
#pragma once

#include <wx/button.h>
#include <wx/listctrl.h>
#include <wx/scrolwin.h>
#include <wx/stattext.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "../view/scene_view.hpp"

namespace sulfurchamber {

class MeasurePanel final : public wxScrolledWindow {
public:
    MeasurePanel(wxWindow* parent, Workbench& bench, SceneView& view);

    /// Shows what is measured now. Cheap; may be called often.
    void refresh();
    /// Whether stages are measured: only while somebody looks.
    void watch(bool on);
    bool searching() const { return costs_.has_value(); }
    /// For scripts: begins the search for the dearest object; what it has found, "" until then.
    void findDearest();
    const std::string& dearest() const { return dearest_; }

private:
    static constexpr std::size_t mostFindings = 2;
    // One comparison.
    struct Block {
        wxStaticText* name = nullptr;
        wxStaticText* formula = nullptr;
        std::array<wxStaticText*, 3> values{};  ///< expected, measured, difference
        std::vector<wxWindow*> all;
    };

    wxStaticText* heading(const wxString& text, wxSizer* sizer);
    wxStaticText* line(wxSizer* table, const wxString& name);
    void makeTextbook(wxSizer* sizer);
    void makeMeters(wxSizer* sizer);
    void makeStages(wxSizer* sizer);
    void refreshTextbook();
    void refreshMeters();
    void refreshStages();
    void refreshSearch();
    void show(Block& block, const Finding& finding);
    void set(wxStaticText* field, const wxString& text);

    Workbench& bench_;
    SceneView& view_;
    wxStaticText* title_ = nullptr;
    wxStaticText* advice_ = nullptr;
    std::array<Block, mostFindings> blocks_;
    std::size_t shownBlocks_ = mostFindings;
    wxListView* meters_ = nullptr;
    std::vector<wxStaticText*> totals_;
    std::array<wxStaticText*, StageTimes::stages> stages_{};
    wxButton* search_ = nullptr;
    wxStaticText* found_ = nullptr;
    std::optional<CostSearch> costs_;
    std::string dearest_;
};

}  // namespace sulfurchamber
