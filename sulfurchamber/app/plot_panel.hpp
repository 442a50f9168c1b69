// The diagram of what is measured, below the scene.
#pragma once

#include <wx/graphics.h>
#include <wx/panel.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "../model/workbench.hpp"
#include "../view/plot_layout.hpp"

namespace sulfurchamber {

/// Shows the measurements of a workbench. The wheel zooms to the pointer, a drag shows the time
/// between both ends, a double click shows all; what is shown is what is fitted.
class PlotPanel final : public wxPanel {
public:
    /// `choose` shows the menu of this name ("Quantities", "Fit", "Export") at a button.
    PlotPanel(wxWindow* parent, Workbench& bench,
              std::function<void(const wxString&, wxWindow&)> choose);

    /// Shows what is measured now. Cheap; may be called often.
    void refresh();
    void setFit(FitKind fit);
    FitKind fit() const { return fit_; }
    void showAll();
    /// The diagram as PNG. Throws std::runtime_error when it cannot be written.
    void savePicture(const std::filesystem::path& file);
    /// The table as CSV. Throws atlax::Error.
    void saveTable(const std::filesystem::path& file) const;

    // -- for scripts --
    std::pair<double, double> shown() const;
    /// Slope, frequency or mean of the first series.
    std::optional<double> fitValue() const;
    std::optional<double> cursorValue() const;
    wxRect plotOnScreen() const;
    void turnWheel(double share, int notches);

private:
    class Diagram;

    Workbench& bench_;
    Diagram* diagram_ = nullptr;
    PlotRange range_;
    FitKind fit_ = FitKind::none;
};

}  // namespace sulfurchamber
