// What the menus do to the order of things.
#include "../model/arrange.hpp"
#include "main_frame.hpp"

namespace sulfurchamber {

void MainFrame::addArrangeActions() {
    const auto m = MenuId::edit;
    const auto any = [this] { return !bench_.selection().empty(); };
    const auto under = [this](Action action) { add(std::move(action)).under = "Arrange"; };
    under({"group", m, "&Group\tCtrl+G", 0, "One click selects all of it; with Alt one of it", "",
           [this] { groupSelection(bench_); }, [this] { return canGroup(bench_); }});
    under({"ungroup", m, "U&ngroup\tCtrl+Shift+G", 0, "Dissolve the group", "",
           [this] { ungroupSelection(bench_); }, [this] { return canUngroup(bench_); }});
    under({"lock", m, "&Lock\tCtrl+L", 0, "No click selects it; the page Outline still does", "",
           [this] { setLocked(bench_, bench_.selection(), true); }, any});
    under({"unlock-all", m, "&Unlock all\tCtrl+Shift+L", 0, "Clicks select everything again", "",
           [this] { unlockAll(bench_); }, [this] { return lockedCount(bench_.document()) > 0; }});
    under({"hide", m, "&Hide\tCtrl+H", 0, "Not drawn and not selected, but still simulated", "",
           [this] { setHidden(bench_, bench_.selection(), true); }, any});
    under({"show-all", m, "&Show all\tCtrl+Shift+H", 0, "Nothing is hidden any more", "",
           [this] { showAll(bench_); }, [this] { return hiddenCount(bench_.document()) > 0; }});
    under({"front", m, "Bring to &front\tCtrl+Shift+Up", 0, "Drawn over everything else", "",
           [this] { orderSelection(bench_, true); }, any});
    under({"back", m, "Send to &back\tCtrl+Shift+Down", 0, "Drawn behind everything else", "",
           [this] { orderSelection(bench_, false); }, any});
    addAlignActions();
}

void MainFrame::addAlignActions() {
    struct Entry {
        const char* name;
        const char* label;
        Alignment alignment;
        const char* help;
    };
    static constexpr Entry entries[] = {
        {"align-left", "Align l&eft", Alignment::left, "Left sides in one line"},
        {"align-centre", "Align &centres", Alignment::centre, "Middles in one upright line"},
        {"align-right", "Align &right", Alignment::right, "Right sides in one line"},
        {"align-top", "Align &top", Alignment::top, "Upper sides at one height"},
        {"align-middle", "Align &middles", Alignment::middle, "Middles at one height"},
        {"align-bottom", "Align b&ottom", Alignment::bottom, "Lower sides at one height"}};
    for (const Entry& entry : entries)
        add({entry.name, MenuId::edit, entry.label, 0, entry.help, "",
             [this, entry] { alignSelection(bench_, entry.alignment); },
             [this] { return canAlign(bench_); }})
            .under = "Arrange";
    for (const bool across : {true, false})
        add({across ? "distribute-across" : "distribute-up", MenuId::edit,
             across ? "&Distribute across" : "Distribute u&pwards", 0,
             "Equal gaps between three or more", "",
             [this, across] { distributeSelection(bench_, across); },
             [this] { return canDistribute(bench_); }})
            .under = "Arrange";
}

void MainFrame::addGridActions() {
    struct Entry {
        const char* name;
        const char* label;
        double step;
    };
    static constexpr Entry entries[] = {{"grid-automatic", "&Automatic", 0},
                                        {"grid-tenth", "0.&1 m", 0.1},
                                        {"grid-quarter", "0.&25 m", 0.25},
                                        {"grid-half", "0.&5 m", 0.5},
                                        {"grid-metre", "1 &m", 1}};
    for (const Entry& entry : entries)
        add({entry.name,
             MenuId::view,
             entry.label,
             0,
             entry.step > 0 ? "Distance of the lines to which things snap"
                            : "The distance of the lines follows the zoom",
             "",
             [this, entry] { view_.options().gridStep = entry.step; },
             {},
             [this, entry] { return view_.options().gridStep == entry.step; }})
            .under = "Grid step";
}

void MainFrame::addSnapActions() {
    struct Entry {
        const char* name;
        const char* label;
        int key;
        const char* help;
        bool SnapSwitches::*flag;
    };
    static constexpr Entry entries[] = {
        {"snap", "&Grid", 'S', "What is drawn and moved goes to the fine grid",
         &SnapSwitches::grid},
        {"snap-corners", "&Corners", 0, "Corners of bodies, and ends of ropes and ground",
         &SnapSwitches::corners},
        {"snap-centres", "C&entres", 0, "Centres of mass", &SnapSwitches::centres},
        {"snap-angles", "&Angles", 0, "Lines and turns in steps of 15 degrees",
         &SnapSwitches::angles}};
    for (const Entry& entry : entries)
        add({entry.name,
             MenuId::view,
             entry.label,
             entry.key,
             entry.help,
             "",
             [this, entry] {
                 bool& on = view_.snapping().*entry.flag;
                 on = !on;
             },
             {},
             [this, entry] { return view_.snapping().*entry.flag; }})
            .under = "Snap to";
}

}  // namespace sulfurchamber
