// Bodies from drawings and pictures.
#include <wx/dialog.h>
#include <wx/radiobox.h>
#include <wx/sizer.h>
#include <wx/spinctrl.h>
#include <wx/stattext.h>

#include <array>

#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

// What of the outlines, and how large.
class ImportDialog final : public wxDialog {
public:
    ImportDialog(wxWindow* parent, const wxString& file)
        : wxDialog(parent, wxID_ANY, wxTr("Bodies from outlines")) {
        const std::array<wxString, 3> kinds{wxTr("Rigid"), wxTr("Soft, filled with springs"),
                                            wxTr("Fixed")};
        kind_ = new wxRadioBox(this, wxID_ANY, wxTr("What they become"), wxDefaultPosition,
                               wxDefaultSize, static_cast<int>(kinds.size()), kinds.data(), 1,
                               wxRA_SPECIFY_COLS);
        const DrawingOptions usual;
        size_ = number(DrawingLimits::leastSize, DrawingLimits::mostSize, usual.size, 0.1, 2);
        tolerance_ = number(0.0001, 1, usual.tolerance, 0.001, 4);
        auto* fields = new wxFlexGridSizer(2, FromDIP(wxSize(8, 6)));
        const auto row = [&](const wxString& label, wxWindow* field) {
            fields->Add(new wxStaticText(this, wxID_ANY, label), wxSizerFlags().CentreVertical());
            fields->Add(field);
        };
        row(wxTr("Longer side, m"), size_);
        row(wxTr("Lines may miss curves by, m"), tolerance_);
        auto* column = new wxBoxSizer(wxVERTICAL);
        const auto border = wxSizerFlags().Expand().Border(wxALL, FromDIP(8));
        column->Add(new wxStaticText(this, wxID_ANY, file), border);
        column->Add(kind_, border);
        column->Add(fields, border);
        column->Add(CreateSeparatedButtonSizer(wxOK | wxCANCEL), border);
        SetSizerAndFit(column);
        CentreOnParent();
    }

    OutlineKind kind() const {
        constexpr std::array<OutlineKind, 3> kinds{OutlineKind::rigid, OutlineKind::soft,
                                                   OutlineKind::fixed};
        return kinds.at(static_cast<std::size_t>(kind_->GetSelection()));
    }
    DrawingOptions options() const { return {size_->GetValue(), tolerance_->GetValue()}; }

private:
    wxSpinCtrlDouble* number(double least, double most, double value, double step,
                             unsigned digits) {
        auto* field = new wxSpinCtrlDouble(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                                           wxSP_ARROW_KEYS, least, most, value, step);
        field->SetDigits(digits);
        return field;
    }

    wxRadioBox* kind_;
    wxSpinCtrlDouble* size_;
    wxSpinCtrlDouble* tolerance_;
};

}  // namespace

bool MainFrame::importOutlines(const std::filesystem::path& file, OutlineKind kind,
                               const DrawingOptions& options, const sulfur::Point& place) {
    bench_.cancel();
    std::vector<std::string> leftOut;
    try {
        const Drawing drawing = readOutlines(file, options);
        leftOut = drawing.leftOut;
        std::vector<sulfur::BodyId> made;
        Document& document = bench_.document();
        document.edit(tr("Import {}", {file.stem().string()}), [&] {
            made = addShapes(document, drawing.shapes, kind, place, leftOut);
            bench_.select(made);
        });
    } catch (const std::exception& error) {
        tell(error.what());
        return false;
    }
    if (!leftOut.empty())
        tell(tr("Not all outlines became bodies ({} did not). {}",
                {std::to_string(leftOut.size()), leftOut.front()}));
    nextRefreshNs_ = 0;
    return true;
}

void MainFrame::importDialog(const std::filesystem::path& file, const sulfur::Point& place) {
    if (options_.unattended()) {
        importOutlines(file, OutlineKind::rigid, {}, place);
        return;
    }
    ImportDialog dialog(this, wxString::FromUTF8(file.filename().string()));
    if (dialog.ShowModal() == wxID_OK) importOutlines(file, dialog.kind(), dialog.options(), place);
}

void MainFrame::chooseImport() {
    const std::vector<atlax::FileKind> kinds{{tr("Drawings and pictures"), {"svg", "png"}},
                                             {tr("All files"), {}}};
    const auto file = canvas_->platform().chooseFile(
        {.title = tr("Make bodies from a drawing or a picture"), .kinds = kinds});
    const atlax::Vec2 middle = canvas_->platform().size().toVec() * 0.5f;
    if (file) importDialog(*file, view_.toWorld(middle));
}

}  // namespace sulfurchamber
