// What the menus do with measuring.
#include <wx/menu.h>

#include <algorithm>

#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

void MainFrame::addMeasureActions() {
    const auto m = MenuId::measure;
    add({"plot",
         m,
         "&Plot of the selection\tF8",
         0,
         "A diagram of what is selected, or of the whole scene, over time",
         "plot",
         [this] { showPlot(!plot_->IsShown()); },
         {},
         [this] { return plot_->IsShown(); }});
    for (const Quantity& one : quantities())
        add({"plot-" + std::string(one.key),
             m,
             wxString::FromUTF8(one.name.data(), one.name.size()),
             0,
             std::string(one.help),
             "",
             [this, &one] { toggleQuantity(one); },
             {},
             [this, &one] {
                 const auto& measured = bench_.measured();
                 return std::find(measured.begin(), measured.end(), &one) != measured.end();
             }})
            .under = "Quantities";
    add({"table4", m, wxString::FromUTF8("Table &4 of the paper\xE2\x80\xA6"), 0,
         "Boxes that drop each second against the share of a core, beside the paper's figures", "",
         [this] { showTable4(); }});
    add({"plot-meters", m, "Readings of all m&eters\tShift+F8", 0,
         "Selects the meters of the scene and plots what they show", "",
         [this] {
             std::vector<std::string> ids;
             for (const Meter& meter : bench_.meters().all()) ids.push_back(meter.id);
             bench_.selectMeters(std::move(ids));
             plot_->Show(true);
             bench_.measure(bench_.measured());
             centre_->Layout();
         },
         [this] { return !bench_.meters().all().empty(); }});
    struct Way {
        const char* name;
        const char* label;
        FitKind fit;
    };
    static constexpr Way ways[] = {{"fit-none", "&Nothing", FitKind::none},
                                   {"fit-mean", "&Mean", FitKind::mean},
                                   {"fit-line", "&Line", FitKind::line},
                                   {"fit-sine", "&Sine", FitKind::sine}};
    for (const Way& way : ways)
        add({way.name,
             m,
             way.label,
             0,
             "Laid over the part of each curve that is shown",
             "",
             [this, way] { plot_->setFit(way.fit); },
             {},
             [this, way] { return plot_->fit() == way.fit; }})
            .under = "Fit";
    addPlotActions();
}

void MainFrame::addPlotActions() {
    const auto m = MenuId::measure;
    const auto any = [this] {
        const auto& series = bench_.measurements().series();
        return std::any_of(series.begin(), series.end(),
                           [](const Series& one) { return !one.samples.empty(); });
    };
    add({"plot-csv", m, wxString::FromUTF8("&Table as CSV\xE2\x80\xA6"), 0,
         "All samples, for a spreadsheet", "",
         [this] {
             const auto file = canvas_->platform().chooseFile({.title = tr("Save the table"),
                                                               .save = true,
                                                               .name = "measured.csv",
                                                               .kinds = {{tr("Tables"), {"csv"}}}});
             if (file) savePlot(*file);
         },
         any})
        .under = "Export";
    add({"plot-png", m, wxString::FromUTF8("&Picture as PNG\xE2\x80\xA6"), 0,
         "The diagram as it is shown, for paper", "",
         [this] {
             const auto file =
                 canvas_->platform().chooseFile({.title = tr("Save the diagram"),
                                                 .save = true,
                                                 .name = "measured.png",
                                                 .kinds = {{tr("Pictures"), {"png"}}}});
             if (file) savePlot(*file);
         },
         any})
        .under = "Export";
    add({"plot-all", m, "Show &all of the time", 0, "As a double click on the diagram does", "",
         [this] { plot_->showAll(); }, any});
    add({"plot-clear", m, "&Forget what was measured", 0, "Samples from now on", "",
         [this] {
             bench_.clearMeasurements();
             plot_->showAll();
         },
         any});
}

void MainFrame::showTable4() {
    if (table4_) {
        table4_->Raise();
        return;
    }
    const auto choose = [this](const std::string& name, const std::string& kind) {
        const bool table = kind == "csv";
        return canvas_->platform().chooseFile(
            {.title = table ? tr("Save the table") : tr("Save the diagram"),
             .save = true,
             .name = name,
             .kinds = {{table ? tr("Tables") : tr("Pictures"), {kind}}}});
    };
    auto* window = new Table4Window(this, choose, [this](const std::string& problem) {
        tellInDialog(problem, "The table cannot be made");
    });
    table4_ = window;
    window->Show();
}

void MainFrame::showPlot(bool on) {
    plot_->Show(on);
    if (on && bench_.measured().empty()) bench_.measure({quantity("height"), quantity("energy")});
    centre_->Layout();
}

void MainFrame::toggleQuantity(const Quantity& one) {
    auto measured = bench_.measured();
    if (std::erase(measured, &one) == 0) {
        // In the order of the table, so that colours stay.
        measured.push_back(&one);
        std::sort(measured.begin(), measured.end());
    }
    bench_.measure(std::move(measured));
    if (!plot_->IsShown()) showPlot(true);
}

void MainFrame::chooseUnder(const wxString& under, wxWindow& at) {
    wxMenu menu;
    for (const Action& action : actions_) {
        if (action.under != under) continue;
        wxMenuItem* item = action.checked
                               ? menu.AppendCheckItem(action.id, action.label.BeforeFirst('\t'))
                               : menu.Append(action.id, action.label.BeforeFirst('\t'));
        if (action.checked) item->Check(action.checked());
        if (action.enabled) item->Enable(action.enabled());
    }
    at.PopupMenu(&menu);
}

bool MainFrame::savePlot(const std::filesystem::path& file) {
    try {
        if (file.extension() == ".png")
            plot_->savePicture(file);
        else
            plot_->saveTable(file);
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The measurements cannot be saved");
        return false;
    }
    return true;
}

}  // namespace sulfurchamber
