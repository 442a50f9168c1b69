#include "template_desk.hpp"

#include <algorithm>
#include <stdexcept>

#include "tool.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

void placeAndSelect(Workbench& bench, const Template& made, const Point& at) {
    std::vector<BodyId> placed;
    bench.document().edit(tr("Place {}", {tr(made.name())}), [&] {
        placed = placeTemplate(bench.document(), made, at);
        bench.select(placed);
    });
}

class TemplateTool final : public Tool {
public:
    TemplateTool(Workbench& bench, const Template& made)
        : Tool(bench), made_(made), size_(boundsOf(made.scene).size()) {}

    void press(const Pointer& pointer) override { move(pointer); }
    void move(const Pointer& pointer) override { at_ = bench().snapped(pointer.position); }
    void release(const Pointer& pointer) override {
        move(pointer);
        done_ = !pointer.shift;
        placeAndSelect(bench(), made_, *at_);
    }
    bool done() const override { return done_; }
    Preview preview() const override {
        if (!at_) return {};
        return {.kind = Preview::Kind::rectangle,
                .from = *at_ - Point(size_.x() / 2, 0),
                .to = *at_ + Point(size_.x() / 2, size_.y())};
    }
    std::string hint() const override {
        return tr("Click where {} shall stand; Shift and click places several, Esc none",
                  {tr(made_.name())});
    }
    void cancel() override { at_.reset(); }

private:
    Template made_;
    Point size_;
    std::optional<Point> at_;
    bool done_ = false;
};

}  // namespace

std::unique_ptr<Tool> makeTemplateTool(Workbench& bench, const Template& made) {
    return std::make_unique<TemplateTool>(bench, made);
}

void TemplateDesk::followSceneFolder() {
    const auto folder = bench_.document().file().parent_path();
    if (folder == library_.sceneFolder()) return;
    library_.setSceneFolder(folder);
    library_.rescan();
}

// --- placing ---------------------------------------------------------------------------------

void TemplateDesk::save(const std::string& name, const std::string& category, bool besideScene) {
    followSceneFolder();
    if (besideScene && library_.sceneFolder().empty())
        throw std::runtime_error(
            "the scene has no folder yet; save it first, or keep the "
            "template among your own ones");
    bench_.cancel();
    bench_.document().edit(tr("Make the template {}", {name}), [&] {
        const Template made = makeTemplate(bench_.document(), bench_.selection(), name, category);
        library_.save(made, besideScene);
    });
}

void TemplateDesk::place(const std::string& name, const Point& at) {
    const LibraryEntry* entry = library_.find(name);
    if (entry == nullptr) throw std::runtime_error(tr("there is no template \"{}\"", {name}));
    const Template made = Library::load(*entry);
    bench_.cancel();
    placeAndSelect(bench_, made, at);
}

void TemplateDesk::placeFile(const std::filesystem::path& file, const Point& at) {
    const Template made = readTemplate(sulfur::scene::read(file));
    bench_.cancel();
    placeAndSelect(bench_, made, at);
}

void TemplateDesk::hold(const std::string& name) {
    const LibraryEntry* entry = library_.find(name);
    if (entry == nullptr) throw std::runtime_error(tr("there is no template \"{}\"", {name}));
    bench_.take(makeTemplateTool(bench_, Library::load(*entry)));
}

// --- instances -------------------------------------------------------------------------------

std::vector<std::string> TemplateDesk::selectedMembers() const {
    std::vector<std::string> ids;
    const Document& document = bench_.document();
    for (const BodyId body : bench_.selection()) {
        std::string id = document.idOf(body);
        if (!id.empty() && membershipOf(document.plan().body(id))) ids.push_back(std::move(id));
    }
    return ids;
}

bool TemplateDesk::anySelected() const {
    return !selectedMembers().empty();
}

std::string TemplateDesk::selectedTemplate() const {
    const auto ids = selectedMembers();
    return ids.empty() ? "" : membershipOf(bench_.document().plan().body(ids.front()))->name;
}

TemplateDesk::Told TemplateDesk::told() const {
    Told told;
    const Document& document = bench_.document();
    const auto ids = selectedMembers();
    const auto instances = instancesOf(document, bench_.selection());
    if (ids.empty()) return told;
    const auto first = membershipOf(document.plan().body(ids.front()));
    if (ids.size() == 1) {
        told.text = tr("Part \xE2\x80\x9C{}\xE2\x80\x9D of \xE2\x80\x9C{}\xE2\x80\x9D",
                       {first->part, first->instance});
        told.overrides = overridesOf(document, ids.front());
    } else if (instances.size() == 1) {
        told.text = tr("Parts of \xE2\x80\x9C{}\xE2\x80\x9D", {first->instance});
    } else {
        told.text = tr("Parts of {} instances", {std::to_string(instances.size())});
    }
    for (const std::string& instance : instances)
        told.ofInstance += overrideCount(document, instance);
    if (const LibraryEntry* entry = library_.find(first->name))
        told.newerInLibrary = differsFromLibrary(document.scene(), *entry);
    return told;
}

// A template of the program gets a file among one's own, which counts from then on.
void TemplateDesk::write(const Template& made) {
    const LibraryEntry* entry = library_.find(made.name());
    library_.save(made, entry != nullptr && entry->origin == LibraryEntry::Origin::scene);
}

void TemplateDesk::updateFromSelection() {
    const auto instances = instancesOf(bench_.document(), bench_.selection());
    if (instances.size() != 1)
        throw std::runtime_error(instances.empty()
                                     ? "nothing of a template is selected"
                                     : "parts of several instances are selected; a template can "
                                       "follow one of them only");
    bench_.cancel();
    bench_.document().edit(tr("Update the template {}", {selectedTemplate()}), [&] {
        const Template next = templateFrom(bench_.document(), instances.front());
        changeTemplate(bench_.document(), next);
        write(next);
    });
}

void TemplateDesk::resetSelection(const std::string& key) {
    const auto ids = selectedMembers();
    if (ids.empty()) throw std::runtime_error("nothing of a template is selected");
    bench_.cancel();
    bench_.document().edit("Reset to the template", [&] {
        for (const std::string& id : ids) resetOverride(bench_.document(), id, key);
    });
}

void TemplateDesk::applySelection(const std::string& key) {
    const auto ids = selectedMembers();
    if (ids.empty()) throw std::runtime_error("nothing of a template is selected");
    bench_.cancel();
    bench_.document().edit(tr("Apply to the template {}", {selectedTemplate()}), [&] {
        for (const std::string& id : ids) write(applyOverride(bench_.document(), id, key));
    });
}

void TemplateDesk::unlinkSelection() {
    const auto instances = instancesOf(bench_.document(), bench_.selection());
    if (instances.empty()) throw std::runtime_error("nothing of a template is selected");
    bench_.cancel();
    bench_.document().edit("Unlink from the template",
                           [&] { unlink(bench_.document(), instances); });
}

void TemplateDesk::takeFromLibrary() {
    const std::string name = selectedTemplate();
    const LibraryEntry* entry = library_.find(name);
    if (entry == nullptr)
        throw std::runtime_error(tr("the library has no template \"{}\"", {name}));
    const Template next = Library::load(*entry);
    bench_.cancel();
    bench_.document().edit(tr("Take {} from the library", {name}),
                           [&] { changeTemplate(bench_.document(), next); });
}

}  // namespace sulfurchamber
