// Everything that one can do, in one table.
#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

Action& MainFrame::add(Action action) {
    action.id = wxWindow::NewControlId();
    // Behind the tab is a key.
    const wxString key = action.label.AfterFirst('\t');
    action.label = wxTr(action.label.BeforeFirst('\t')) + (key.empty() ? "" : "\t" + key);
    action.help = tr(action.help);
    actions_.push_back(std::move(action));
    return actions_.back();
}

void MainFrame::makeActions() {
    addFileActions();
    addEditActions();
    addToolActions();
    addPointerActions();
    addViewActions();
    addSimulationActions();
    addRewindActions();
    addMeasureActions();
    addLevelActions();
    addHelpActions();
}

void MainFrame::addFileActions() {
    const auto m = MenuId::file;
    add({"new", m, "&New\tCtrl+N", 0, "Start over with an empty floor", "new",
         [this] { newFile(); }});
    add({"open", m, wxString::FromUTF8("&Open\xE2\x80\xA6\tCtrl+O"), 0, "Open a scene or a level",
         "open", [this] { openDialog(); }});
    add({"open-recent", m,
         wxString::FromUTF8("Recent scenes in &pictures\xE2\x80\xA6\tCtrl+Shift+O"), 0,
         "Choose one of the files that were opened lately by its picture", "",
         [this] { showRecent(); }, [this] { return recent_.GetCount() > 0; }});
    add({"save", m, "&Save\tCtrl+S", 0, "Save the scene as it was built, whatever has moved since",
         "save", [this] { save(); }});
    add({"save-as", m, wxString::FromUTF8("Save &as\xE2\x80\xA6\tCtrl+Shift+S"), 0,
         "Save the scene in another file", "", [this] { saveDialog(); }});
    add({"save-moment", m, wxString::FromUTF8("Save this &moment as a new scene\xE2\x80\xA6"), 0,
         "Save everything where it is now, in a file of its own", "",
         [this] { saveMomentDialog(); }});
    addShareActions();
    add({"import", m, wxString::FromUTF8("&Import outlines\xE2\x80\xA6"), 0,
         "Make bodies from the outlines of an SVG drawing or of a picture with transparency", "",
         [this] { chooseImport(); }});
    add({"quit", m, "&Quit\tCtrl+Q", 0, "Leave SulfurChamber", "", [this] { Close(); }})
        .separatorBefore = true;
}

void MainFrame::addEditActions() {
    const auto m = MenuId::edit;
    const auto copyable = [this] { return bench_.canCopy(); };
    const auto anything = [this] { return bench_.anythingSelected(); };
    add({"undo", m, "&Undo\tCtrl+Z", 0, "Back to the moment before the last change", "undo",
         [this] { bench_.undo(); }, [this] { return bench_.document().canUndo(); }});
    add({"redo", m, "&Redo\tCtrl+Shift+Z", 0, "Do the undone change again", "redo",
         [this] { bench_.redo(); }, [this] { return bench_.document().canRedo(); }});
    add({"cut", m, "Cu&t\tCtrl+X", 0, "Put the selection into the clipboard and remove it", "",
         [this] { canvas_->platform().setClipboard(bench_.cut()); }, copyable})
        .separatorBefore = true;
    add({"copy", m, "&Copy\tCtrl+C", 0, "Put the selection into the clipboard", "",
         [this] { canvas_->platform().setClipboard(bench_.copy()); }, copyable});
    add({"paste", m, "&Paste\tCtrl+V", 0, "Add what is in the clipboard, also from another window",
         "", [this] {
             const std::string text = canvas_->platform().clipboard();
             if (text.empty()) return;
             if (const auto at = view_.pointerInView())
                 bench_.pasteAt(text, *at);
             else
                 bench_.paste(text, {0.5, 0.5});
         }});
    add({"duplicate", m, "&Duplicate\tCtrl+D", 0, "Add a copy of the selection beside it", "",
         [this] { bench_.duplicate(); }, copyable});
    add({"delete", m, "De&lete", WXK_DELETE, "Remove the selection", "",
         [this] { bench_.deleteSelection(); },
         [this, anything] {
             return anything() || !bench_.selectedMeters().empty() || bench_.fitting().has_value();
         }});
    add({"select-all", m, "Select &all\tCtrl+A", 0, "Select all bodies", "",
         [this] { bench_.selectAll(); }})
        .separatorBefore = true;
    add({"finish", m, "Close the &polygon", WXK_RETURN, "End what takes several clicks", "",
         [this] { bench_.finish(); }});
    add({"cancel", m, "Select &nothing", WXK_ESCAPE,
         "Drop what the tool is doing and the selection", "", [this] {
             view_.letGoOfKeys();
             bench_.cancel();
             bench_.select({});
         }});
    addTransformActions();
    addArrangeActions();
    addTemplateActions();
    addSkinActions();
    const auto left = [this] { return strays_ > 0; };
    add({"bring-back", m, "&Bring back what has left", 0,
         "Put what fell out of the world's bounds back to its place", "",
         [this] { bench_.bringBackStrays(); }, left})
        .separatorBefore = true;
    add({"delete-strays", m, "Delete &what has left", 0,
         "Remove what fell out of the world's bounds", "", [this] { bench_.deleteStrays(); },
         left});
}

void MainFrame::addTransformActions() {
    const auto m = MenuId::edit;
    const auto any = [this] { return !bench_.selection().empty(); };
    const auto under = [this](Action action) -> Action& {
        Action& made = add(std::move(action));
        made.under = "Transform";
        return made;
    };
    constexpr double step = 3.14159265358979 / 12;
    under({"turn-left", m, wxString::FromUTF8("&Turn left by 15\xC2\xB0"), '[',
           "Turn the selection anticlockwise", "", [this] { bench_.turn(step); }, any})
        .separatorBefore = true;
    under({"turn-right", m, wxString::FromUTF8("Turn &right by 15\xC2\xB0"), ']',
           "Turn the selection clockwise", "", [this] { bench_.turn(-step); }, any});
    under({"larger", m, "&Larger by a tenth\tCtrl++", 0,
           "Scale the selection, its mass with its area", "", [this] { bench_.scale(1.1); }, any});
    under({"smaller", m, "S&maller by a tenth\tCtrl+-", 0,
           "Scale the selection, its mass with its area", "", [this] { bench_.scale(1 / 1.1); },
           any});
    under({"mirror", m, "M&irror\tCtrl+M", 0, "Left becomes right", "", [this] { bench_.mirror(); },
           any});
    struct Way {
        const char* name;
        const char* label;
        int key;
        double x, y;
    };
    static constexpr Way ways[] = {{"nudge-left", "Nudge left", WXK_LEFT, -1, 0},
                                   {"nudge-right", "Nudge right", WXK_RIGHT, 1, 0},
                                   {"nudge-up", "Nudge up", WXK_UP, 0, 1},
                                   {"nudge-down", "Nudge down", WXK_DOWN, 0, -1}};
    for (const Way& way : ways)
        under({way.name, m, way.label, way.key, "Move the selection by a line of the fine grid", "",
               [this, way] { bench_.nudge(sulfur::Point(way.x, way.y) * view_.fineStep()); },
               [this] { return bench_.anythingSelected(); }});
}

void MainFrame::addToolActions() {
    struct Entry {
        ToolKind kind;
        const char* label;
        int key;
        const char* help;
    };
    static constexpr Entry entries[] = {
        {ToolKind::select, "&Select and drag", 'V',
         "Select and move; while playing: pull with a spring"},
        {ToolKind::box, "&Box", 'B', "Rigid boxes"},
        {ToolKind::ball, "Ba&ll", 'O', "Balls"},
        {ToolKind::wheel, "&Wheel", 'W', "Wheels; on a body they turn about an axle"},
        {ToolKind::polygon, "Pol&ygon", 'Y', "Rigid polygons, corner by corner"},
        {ToolKind::wall, "Wa&ll", 'N', "Walls that crumble"},
        {ToolKind::ground, "&Ground", 'G', "Fixed lines to stand on"},
        {ToolKind::jelly, "&Jelly", 'J', "Soft boxes"},
        {ToolKind::draw, "&Draw", 'L', "Soft bodies, drawn freehand"},
        {ToolKind::cloth, "Cl&oth", 'Q', "Cloths that hang by their corners"},
        {ToolKind::rope, "&Rope", 'R', "Ropes between two points"},
        {ToolKind::chain, "C&hain", 'H', "Chains of rigid links"},
        {ToolKind::bridge, "Br&idge", 'U', "Bridges of planks between two pins"},
        {ToolKind::particle, "Pa&rticle", '1', "Particles, one by one"},
        {ToolKind::joint, "Joi&nt", '2', "Joints between particles, one by one"},
        {ToolKind::hinge, "&Hinge", '4', "Two bodies turn about a point"},
        {ToolKind::motor, "&Motor", '5', "A hinge that turns by itself, or by keys"},
        {ToolKind::weld, "&Weld", '6', "Two bodies become as one"},
        {ToolKind::spring, "&Spring", '7', "A spring between two bodies"},
        {ToolKind::cable, "&Cable", '8', "A distance that only pulls"},
        {ToolKind::winch, "Wi&nch", '9', "A cable that is wound in and out by keys"},
        {ToolKind::slider, "S&lider", '0', "A body that is led along a rail"},
        {ToolKind::axle, "&Axle\tCtrl+Shift+X", 0, "A driven wheel with suspension"},
        {ToolKind::pulley, "&Pulley\tCtrl+Shift+Y", 0, "A rope that runs over two points"},
        {ToolKind::gear, "&Gear\tCtrl+Shift+J", 0, "Two mechanisms that turn together"},
        {ToolKind::thruster, "&Thruster\tCtrl+Shift+T", 0, "A force on a body, by a key"},
        {ToolKind::wind, "&Wind\tCtrl+Shift+W", 0, "A zone in which air moves"},
        {ToolKind::gravity, "&Gravity zone\tCtrl+Shift+K", 0,
         "A zone in which things weigh nothing, or fall elsewhere"},
        {ToolKind::conveyor, "&Conveyor\tCtrl+Shift+B", 0, "A belt, or a body whose surface runs"},
        {ToolKind::liquid, "&Liquid\tCtrl+Shift+A", 0, "A pool of many small drops"},
        {ToolKind::pin, "&Pin", 'P', "Hold a particle where it is, or let it go"},
        {ToolKind::cut, "&Cut", 'X', "Cut through joints"},
        {ToolKind::erase, "&Erase", 'E', "Remove bodies and what is fitted to them"},
        {ToolKind::measure, "R&uler", '3', "Rulers, which hold on to particles and bodies"},
        {ToolKind::protractor, "Protra&ctor\tCtrl+Shift+P", 0, "Angles between three places"},
        {ToolKind::tracer, "&Tracer\tCtrl+Shift+D", 0, "Lets a point of a body leave a trail"},
        {ToolKind::gauge, "&Force gauge\tCtrl+Shift+F", 0,
         "Force in a joint or mechanism, or of all contacts of a body"},
        {ToolKind::gun, "Speed gu&n\tCtrl+Shift+M", 0, "Speed of what passes a beam"},
    };
    for (const Entry& entry : entries) {
        const std::string name(toolName(entry.kind));
        const ToolGroup group = groupOf(entry.kind);
        Action& action = add({"tool-" + name,
                              MenuId::tools,
                              entry.label,
                              entry.key,
                              entry.help,
                              name,
                              [this, kind = entry.kind] { bench_.setTool(kind); },
                              {},
                              [this, kind = entry.kind] { return bench_.tool() == kind; }});
        if (group == ToolGroup::select) continue;
        for (const ToolGroupInfo& info : toolGroups())
            if (info.group == group)
                action.under = wxString::FromUTF8(info.title.data(), info.title.size());
    }
}

// Everything that the mouse does in the scene, by keys.
void MainFrame::addPointerActions() {
    struct Way {
        const char* name;
        const char* label;
        int key;
        double x, y;
    };
    static constexpr Way ways[] = {{"pointer-left", "Pointer left", WXK_LEFT, -1, 0},
                                   {"pointer-right", "Pointer right", WXK_RIGHT, 1, 0},
                                   {"pointer-up", "Pointer up", WXK_UP, 0, 1},
                                   {"pointer-down", "Pointer down", WXK_DOWN, 0, -1}};
    for (const Way& way : ways)
        add({way.name, MenuId::tools, way.label, way.key | withShift,
             "Move the pointer by a line of the fine grid", "",
             [this, way] { view_.movePointer(sulfur::Point(way.x, way.y) * view_.fineStep()); }})
            .under = "Pointer";
    struct Press {
        const char* name;
        const char* label;
        int held;
        atlax::Modifiers modifiers;
    };
    static constexpr Press presses[] = {
        {"pointer-button", "Press or let go", 0, atlax::Modifiers::None},
        {"pointer-shift", "Press with Shift", withShift, atlax::Modifiers::Shift},
        {"pointer-control", "Press with Ctrl", withControl, atlax::Modifiers::Control},
        {"pointer-alt", "Press with Alt", withAlt, atlax::Modifiers::Alt}};
    for (const Press& press : presses)
        add({press.name, MenuId::tools, press.label, WXK_INSERT | press.held,
             "Press the button of the mouse where the pointer is, or let it go", "",
             [this, press] { view_.switchButton(press.modifiers); }})
            .under = "Pointer";
}

void MainFrame::addViewActions() {
    const auto m = MenuId::view;
    ViewOptions& o = view_.options();
    const auto toggle = [&](const char* name, const wxString& label, int key, const char* help,
                            const char* picture, bool& flag) -> Action& {
        return add({name,
                    m,
                    label,
                    key,
                    help,
                    picture,
                    [&flag] { flag = !flag; },
                    {},
                    [&flag] { return flag; }});
    };
    // In menus of their own, because the whole must fit on a small screen.
    add({"fit", m, "Zoom to &fit", 'F', "Show everything", "fit", [this] { view_.zoomToFit(); }})
        .under = "Zoom";
    add({"zoom-in", m, "Zoom &in", '+', "Larger; the mouse wheel zooms to the pointer", "",
         [this] { view_.zoom(1.25f); }})
        .under = "Zoom";
    add({"zoom-out", m, "Zoom &out", '-', "Smaller", "", [this] { view_.zoom(0.8f); }}).under =
        "Zoom";
    toggle("grid", "&Grid", '#', "Lines at round metres", "grid", o.grid).separatorBefore = true;
    toggle("rulers", "R&ulers", 0, "Metres at the edges", "", o.rulers);
    addGridActions();
    addSnapActions();
    toggle("velocities", "&Velocity arrows", 'A', "Arrows as long as the way of 0.12 s", "arrows",
           o.velocities)
        .separatorBefore = true;
    add({"trails",
         m,
         "&Trails of the selection\tCtrl+T",
         0,
         "Lines where the centres of mass of what is selected have been",
         "",
         [this] { bench_.setTrails(!bench_.trails()); },
         {},
         [this] { return bench_.trails(); }});
    toggle("strain", "Joints coloured by st&rain", 'T',
           "Amber and red: stretched by up to 8 %; cyan: pressed", "strain", o.strain);
    toggle("gravity", "&Weights", 0, "Arrows of the force of gravity on each body", "", o.gravity)
        .under = "Forces";
    toggle("joint-forces", "&Joints", 0, "Arrows of what joints and mechanisms pull and push", "",
           o.jointForces)
        .under = "Forces";
    toggle("contact-forces", "&Contacts", 0, "Arrows of what contacts push and rub", "",
           o.contactForces)
        .under = "Forces";
    toggle("contacts", "&Contacts", 'C', "Where bodies touch, and in which direction", "",
           o.contacts);
    toggle("joints", "Inner &joints", 'I', "Joints inside of bodies", "", o.joints);
    toggle("skeleton", "S&keleton", 'K',
           "What the physics sees: particles, joints under load, surfaces, contacts, fields", "",
           o.skeleton);
    struct Page {
        const char* name;
        const char* label;
    };
    static constexpr Page pages[] = {
        {"scene", "Page of the scene\tCtrl+1"},     {"object", "Page of the object\tCtrl+2"},
        {"history", "Page of the history\tCtrl+3"}, {"measure", "Page of the measuring\tCtrl+4"},
        {"outline", "Page of the outline\tCtrl+5"}, {"library", "Page of the library\tCtrl+6"}};
    for (const Page& page : pages)
        add({"page-" + std::string(page.name), m, page.label, 0,
             "Bring this page of the side panel to the front", "",
             [this, page] {
                 showSide(true);
                 side_->showPage(page.name);
             }})
            .under = "Page";
    add({"panel",
         m,
         "Side &panel\tF9",
         0,
         "Constants, properties and history beside the scene",
         "",
         [this] { showSide(!side_->IsShown()); },
         {},
         [this] { return side_->IsShown(); }});
    addThemeActions();
    add({"fullscreen",
         m,
         "F&ullscreen\tF11",
         0,
         "Use the whole screen",
         "",
         [this] {
             ShowFullScreen(!IsFullScreen(), wxFULLSCREEN_NOBORDER | wxFULLSCREEN_NOCAPTION);
         },
         {},
         [this] { return IsFullScreen(); }});
}

void MainFrame::addThemeActions() {
    struct Entry {
        const char* name;
        const char* label;
    };
    static constexpr Entry entries[] = {
        {"system", "As the &system"}, {"light", "&Light"}, {"dark", "&Dark"}};
    for (const Entry& entry : entries)
        add({"theme-" + std::string(entry.name),
             MenuId::view,
             entry.label,
             0,
             "How light the scene and the panels are, from the next start on",
             "",
             [this, entry] { chooseTheme(entry.name); },
             {},
             [this, entry] { return theme_ == entry.name; }})
            .under = "Theme";
}

void MainFrame::addLanguageActions() {
    std::vector<std::string> all = languages();
    all.insert(all.begin(), "");  // that of the system
    for (const std::string& language : all)
        add({"language-" + (language.empty() ? "system" : language),
             MenuId::help,
             language.empty() ? wxString("As the &system")
                              : wxString::FromUTF8(nameOfLanguage(language)),
             0,
             "The language of the menus, from the next start on",
             "",
             [this, language] { chooseLanguage(language); },
             {},
             [this, language] { return language_ == language; }})
            .under = "Language";
}

void MainFrame::addSimulationActions() {
    const auto m = MenuId::simulation;
    add({"reset", m, "&Reset\tCtrl+R", 0, "Back to the scene as it was built", "reset",
         [this] {
             bench_.cancel();
             bench_.document().reset();
             bench_.documentChanged();
         },
         [this] { return bench_.document().canReset(); }});
    add({"play", m, "&Play or pause", WXK_SPACE, "Let time run, or stop it", "play", [this] {
             bench_.cancel();
             if (bench_.document().playing())
                 bench_.document().pause();
             else
                 bench_.document().play();
         }});
    add({"tick", m, "Single &tick", '.', "Pause and advance by one tick", "tick",
         [this] { view_.singleTick(); }});
    addSpeedActions();
    add({"drop", m, "&Drop ten boxes", 'D', "Ten boxes fall into the scene", "",
         [this] { bench_.dropBoxes(10); }})
        .separatorBefore = true;
}

void MainFrame::addSpeedActions() {
    const auto m = MenuId::simulation;
    struct Speed {
        const char* name;
        const char* label;
        int permille;
    };
    static constexpr Speed speeds[] = {{"speed-four", "&Four times as fast", 4000},
                                       {"speed-twice", "T&wice as fast", 2000},
                                       {"speed-normal", "&Normal speed", 1000},
                                       {"speed-half", "&Half speed", 500},
                                       {"speed-tenth", "A &tenth of the speed", 100},
                                       {"speed-hundredth", "A h&undredth of the speed", 10},
                                       {"speed-thousandth", "A th&ousandth of the speed", 1}};
    const auto under = [this](Action action) -> Action& {
        Action& made = add(std::move(action));
        made.under = "Speed";
        return made;
    };
    for (const Speed& speed : speeds)
        under({speed.name,
               m,
               speed.label,
               0,
               "How fast time runs changes no result",
               "",
               [this, speed] { view_.setSpeedPermille(speed.permille); },
               {},
               [this, speed] { return view_.speedPermille() == speed.permille; }})
            .separatorBefore = speed.permille == 4000;
    under({"slow",
           m,
           "&Slow motion",
           'M',
           "A quarter of the speed, and back",
           "slow",
           [this] { view_.setSpeedPermille(view_.speedPermille() == 250 ? 1000 : 250); },
           {},
           [this] { return view_.speedPermille() == 250; }});
    under({"faster", m, "Fas&ter\tCtrl+Up", 0, "The next higher speed, up to four times", "",
           [this] { changeSpeed(1); }, [this] { return view_.speedPermille() < 4000; }});
    under({"slower", m, "Slo&wer\tCtrl+Down", 0, "The next lower speed, down to a thousandth", "",
           [this] { changeSpeed(-1); }, [this] { return view_.speedPermille() > 1; }});
}

void MainFrame::addRewindActions() {
    const auto m = MenuId::simulation;
    const auto any = [this] { return !bench_.document().timeline().empty(); };
    const auto some = [this] { return !bench_.document().timeline().others().empty(); };
    const auto under = [this](Action action) -> Action& {
        Action& made = add(std::move(action));
        made.under = "Rewind";
        return made;
    };
    under({"tick-back", m, "Single tick &back", ',', "Back by one tick", "back",
           [this] { seekBy(-static_cast<double>(bench_.document().world().tickDuration())); }, any})
        .separatorBefore = true;
    under({"second-back", m, "A &second back", WXK_PAGEUP, "Rewind by a second", "",
           [this] { seekBy(-1); }, any});
    under({"second-on", m, "A second &on", WXK_PAGEDOWN, "Towards the end by a second", "",
           [this] { seekBy(1); }, any});
    under({"mark-back", m, "&Previous mark\tCtrl+PgUp", 0,
           "Back to an edit, a break or a first contact", "", [this] { seekMark(false); }, any});
    under({"mark-on", m, "Ne&xt mark\tCtrl+PgDn", 0, "On to an edit, a break or a first contact",
           "", [this] { seekMark(true); }, any});
    under({"oldest", m, "To the &oldest moment", WXK_HOME, "As far back as is recorded", "",
           [this] { seekBy(-1e9); }, any});
    under({"newest", m, "To the &end", WXK_END, "The latest moment of this line", "",
           [this] { seekBy(1e9); }, any});
    under({"other-future", m, "Another f&uture", 'Z',
           "The end of the next branch that was left by going on from an earlier moment", "",
           [this] { showOtherFuture(); }, some});
}

}  // namespace sulfurchamber
