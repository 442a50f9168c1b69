// The application of wxWidgets.
#pragma once

#include <wx/app.h>

#include <memory>

#include "../model/workbench.hpp"
#include "options.hpp"

namespace sulfurchamber {

class MainFrame;
class Script;

class ChamberApp final : public wxApp {
public:
    /// Both must outlive the application.
    ChamberApp(Workbench& bench, const Options& options);
    ~ChamberApp() override;

    bool OnInit() override;
    int OnRun() override;
    int FilterEvent(wxEvent& event) override;
    bool OnExceptionInMainLoop() override;
    void OnAssertFailure(const wxChar* file, int line, const wxChar* function,
                         const wxChar* condition, const wxChar* message) override;
    void setExitCode(int code) { exitCode_ = code; }

private:
    Workbench& bench_;
    const Options& options_;
    std::unique_ptr<Script> script_;
    int exitCode_ = 0;
};

ChamberApp& chamberApp();

}  // namespace sulfurchamber
