// What a person does with templates: each function is one step of the history, and keeps the
// library up to date with it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "instances.hpp"
#include "library.hpp"
#include "workbench.hpp"

namespace sulfurchamber {

/// One thread. Functions throw std::exception with one sentence, and change nothing then. The
/// library's files are no part of the history: undo changes the scene alone.
class TemplateDesk {
public:
    /// Both must outlive it.
    TemplateDesk(Workbench& bench, Library& library) : bench_(bench), library_(library) {}

    Library& library() { return library_; }
    /// Asks the library for the templates beside the scene that is open, if that is another one.
    void followSceneFolder();

    /// Makes a template of the selection and writes its file.
    void save(const std::string& name, const std::string& category, bool besideScene);
    /// Adds an instance with the middle of its lower edge at a place, and selects it.
    void place(const std::string& name, const sulfur::Point& at);
    /// Takes a template in the hand: the next click places it, and with Shift those after it.
    void hold(const std::string& name);
    /// The same for a file, which need not be in the library.
    void placeFile(const std::filesystem::path& file, const sulfur::Point& at);

    /// Whether something that is selected belongs to an instance.
    bool anySelected() const;
    /// The template of the first selected instance; "" where there is none.
    std::string selectedTemplate() const;
    /// What is told of the selection: the part of one body, and how it differs.
    struct Told {
        std::string text;  ///< "Part “wheel” of “Car 2”"; "" where nothing selected is an instance
        std::vector<Override> overrides;  ///< of the one body that is selected
        std::size_t ofInstance = 0;       ///< overrides of the whole instance
        bool newerInLibrary = false;
    };
    Told told() const;

    /// Makes the template what the selected instance is; all others follow.
    void updateFromSelection();
    /// Takes back what differs of the selected bodies: one trait, or all where the key is empty.
    void resetSelection(const std::string& key);
    /// Gives it to the template.
    void applySelection(const std::string& key);
    void unlinkSelection();
    /// Takes the library's version of the selected instance's template into the scene.
    void takeFromLibrary();

private:
    std::vector<std::string> selectedMembers() const;
    void write(const Template& made);

    Workbench& bench_;
    Library& library_;
};

/// Places a scene again and again, with the middle of its lower edge at the pointer.
std::unique_ptr<Tool> makeTemplateTool(Workbench& bench, const Template& made);

}  // namespace sulfurchamber
