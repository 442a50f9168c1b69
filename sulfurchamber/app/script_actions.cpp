// Each action of the program, one after the other.
#include <wx/accel.h>

#include <atlax/files.hpp>
#include <iostream>

#include "script.hpp"

namespace sulfurchamber {
namespace {

// Frames in which what an action began shows itself.
constexpr int framesOfAction = 3;
constexpr int framesOfKey = 300;  // until it has arrived

// Files, places and names are asked for by what ends with three dots, and a script cannot answer.
bool asks(const Action& action) {
    const std::string label = action.label.utf8_string();
    return label.substr(0, label.find('\t')).ends_with("\xE2\x80\xA6");
}

// Keys as wxUIActionSimulator takes them; 0 where there is none.
struct KeyPress {
    int code = 0;
    int modifiers = wxMOD_NONE;
    auto operator<=>(const KeyPress&) const = default;
};
KeyPress keyOf(const Action& action) {
    if (action.plainKey != 0)
        return {action.plainKey & ~(withShift | withControl | withAlt),
                ((action.plainKey & withShift) != 0 ? wxMOD_SHIFT : 0) |
                    ((action.plainKey & withControl) != 0 ? wxMOD_CONTROL : 0) |
                    ((action.plainKey & withAlt) != 0 ? wxMOD_ALT : 0)};
    const std::unique_ptr<wxAcceleratorEntry> entry(wxAcceleratorEntry::Create(action.label));
    if (!entry) return {};
    static_assert(int{wxACCEL_ALT} == int{wxMOD_ALT} && int{wxACCEL_CTRL} == int{wxMOD_CONTROL} &&
                  int{wxACCEL_SHIFT} == int{wxMOD_SHIFT});
    return {entry->GetKeyCode(), entry->GetFlags()};
}

}  // namespace

void Script::everyAction(const Words& words) {
    Round round;
    round.file = words[1];
    round.ticks = static_cast<int>(number(words[2]));
    const std::set<std::string> left(words.begin() + 3, words.end());
    round.byKey = words[0] == "every-key";
    std::set<std::string> known;
    std::map<KeyPress, std::string> keys;
    for (const Action& action : frame_.actions()) {
        known.insert(action.name);
        const KeyPress key = keyOf(action);
        if (round.byKey && key.code == 0) continue;
        if (const auto [other, isNew] = keys.emplace(key, action.name); round.byKey && !isNew)
            fail("the actions " + other->second + " and " + action.name + " have one key");
        if (!left.contains(action.name) && !asks(action)) round.names.push_back(action.name);
    }
    for (const std::string& name : left)
        if (!known.contains(name)) fail("there is no action " + name);
    tryAction(std::make_shared<const Round>(std::move(round)), 0);
}

void Script::tryAction(const std::shared_ptr<const Round>& round, std::size_t index) {
    if (index == round->names.size()) {
        std::string missed;
        for (const std::string& name : round->names)
            if (!done_.contains(name)) missed += ' ' + name;
        std::cout << "actions done: " << done_.size() << ", never available:" << missed
                  << std::endl;
        return;
    }
    const std::string& name = round->names[index];
    frame_.bench().cancel();
    if (!frame_.openFile(round->file)) fail(frame_.lastProblem());
    for (int i = 0; i < round->ticks; ++i) frame_.bench().tick();
    frame_.perform("select-all");
    const std::string before = frame_.bench().document().text();
    const std::string told = frame_.lastProblem();
    const auto look = [this, round, index, before, told] {
        // What cannot be done is not offered.
        if (frame_.lastProblem() != told)
            fail("the action " + round->names[index] +
                 " is offered but refuses: " + frame_.lastProblem());
        takeBack(round->names[index], before);
        tryAction(round, index + 1);
    };
    if (round->byKey) {
        pressKeyOf(name, look);
    } else {
        if (frame_.perform(name)) done_.insert(name);
        waitForFrames(framesOfAction, look);
    }
}

// What is not available has no key that does anything.
void Script::pressKeyOf(const std::string& name, std::function<void()> then) {
    const auto& actions = frame_.actions();
    const auto action = std::find_if(actions.begin(), actions.end(),
                                     [&](const Action& one) { return one.name == name; });
    if (action->enabled && !action->enabled()) {
        waitForFrames(1, std::move(then));
        return;
    }
    const KeyPress key = keyOf(*action);
    frame_.canvas().SetFocus();
    simulator_.Char(key.code, key.modifiers);
    const auto frames = std::make_shared<int>(0);
    waitFor([this, name, frames] { return frame_.lastAction() == name || ++*frames > framesOfKey; },
            [this, name, then = std::move(then)] {
                if (frame_.lastAction() != name)
                    fail("the key of " + name + " does " + frame_.lastAction());
                done_.insert(name);
                waitForFrames(framesOfAction, then);
            });
}

// Whatever an action has changed, undo leads back to each byte.
void Script::takeBack(const std::string& name, const std::string& before) {
    frame_.perform("level-edit");
    frame_.perform("lesson-end");
    Workbench& bench = frame_.bench();
    bench.cancel();
    while (bench.document().canUndo()) {
        bench.document().undo();
        bench.documentChanged();
    }
    if (bench.document().text() != before) fail("undo does not take back the action " + name);
}

}  // namespace sulfurchamber
