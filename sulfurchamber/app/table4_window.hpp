// The paper's Table 4 as an experiment, in a window of its own.
#pragma once

#include <wx/button.h>
#include <wx/frame.h>
#include <wx/gauge.h>
#include <wx/listctrl.h>
#include <wx/stattext.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "../model/table4.hpp"

namespace sulfurchamber {

/// Begins at once; the scene goes on beside it. It destroys itself when it is closed, and hides
/// behind nothing of its parent.
class Table4Window final : public wxFrame {
public:
    /// `choose` asks for a file to save (with this name, of this kind), or gives nothing.
    using Choose = std::function<std::optional<std::filesystem::path>(const std::string& name,
                                                                      const std::string& kind)>;
    Table4Window(wxWindow* parent, Choose choose, std::function<void(const std::string&)> tell);

    const Table4& table() const { return table_; }
    /// Begins anew, with other seconds for each column than the usual ten.
    void begin(double seconds = 10);
    /// Shows what has been found since. The frame calls it now and then.
    void refresh();
    /// The table as .csv or the diagram as .png. Throws std::exception.
    void save(const std::filesystem::path& file);

private:
    class Diagram;
    void makeTable();
    void saveAs(const char* name, const char* kind);

    Table4 table_;
    Choose choose_;
    std::function<void(const std::string&)> tell_;
    Diagram* diagram_ = nullptr;
    wxListView* list_ = nullptr;
    wxGauge* progress_ = nullptr;
    wxButton* run_ = nullptr;
    wxButton* csv_ = nullptr;
    wxButton* png_ = nullptr;
};

}  // namespace sulfurchamber
