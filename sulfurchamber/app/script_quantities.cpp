// What scripts of the window can ask about.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../model/fitting_properties.hpp"
#include "../model/geometry.hpp"
#include "../model/properties.hpp"
#include "../model/skins.hpp"
#include "../model/transform.hpp"
#include "library_panel.hpp"
#include "outline_panel.hpp"
#include "properties_panel.hpp"
#include "script.hpp"

namespace sulfurchamber {

double Script::quantity(const std::string& name) const {
    Workbench& bench = frame_.bench();
    const Document& document = bench.document();
    const sulfur::World& world = document.world();
    const auto bodies = world.bodies();
    if (name == "bodies") return static_cast<double>(totals(world).bodies);
    if (name == "particles") return static_cast<double>(totals(world).particles);
    if (name == "joints") {
        const Totals sums = totals(world);
        return static_cast<double>(sums.rigidJoints + sums.elasticJoints);
    }
    if (name == "contacts") return static_cast<double>(world.contacts().size());
    if (const auto found = levelQuantity(name)) return *found;
    if (name == "time") return world.time();
    if (name == "table4.cells")
        return frame_.table4() == nullptr
                   ? 0
                   : static_cast<double>(frame_.table4()->table().cells().size());
    if (name == "difference" || name == "measured") {
        const auto findings = bench.textbook().findings();
        if (findings.empty()) fail("the scene is none of the textbook");
        const auto value = name == "measured" ? findings[0].measured : findings[0].difference();
        return value.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    if (name == "meters") return static_cast<double>(bench.meters().all().size());
    if (name.starts_with("meter.")) {
        const Meter* meter = bench.meters().find(name.substr(6));
        if (meter == nullptr) fail("there is no " + name);
        const auto last = bench.meters().last(*meter);
        return bench.meters()
            .read(*meter, readingsOf(meter->kind)[0])
            .value_or(last ? last->value : std::numeric_limits<double>::quiet_NaN());
    }
    if (name == "selected")
        return static_cast<double>(bench.selection().size() + bench.selectedMeters().size());
    if (name == "hidden") return static_cast<double>(hiddenCount(document));
    if (name == "locked") return static_cast<double>(lockedCount(document));
    if (name == "outline-rows") return static_cast<double>(frame_.outline().rowCount());
    if (name == "zoom") return frame_.sceneView().metresPerPixel();
    if (name == "modified") return document.modified() ? 1 : 0;
    if (name == "playing") return document.playing() ? 1 : 0;
    if (name == "problem") return frame_.lastProblem().empty() ? 0 : 1;
    if (name == "gravity") return document.constants().gravity;
    if (name == "elasticity") return document.constants().elasticity;
    if (name == "rain") return bench.rain();
    if (name == "fittings") return static_cast<double>(document.fittings().size());
    if (name.starts_with("property.") && bench.fitting()) {
        const Fitting fitting = document.fitting(*bench.fitting());
        const FittingProperty* property = fittingProperty(name.substr(9), fitting);
        if (property == nullptr) fail("it has no " + name);
        return *property->get(fitting);
    }
    if (name.starts_with("property.")) {
        if (const PlaceProperty* place = placeProperty(name.substr(9))) {
            const auto frame = selectionFrame(bench);
            return frame ? place->get(*frame) : std::numeric_limits<double>::quiet_NaN();
        }
        const NumberProperty* property = numberProperty(name.substr(9));
        if (property == nullptr) fail("there is no " + name);
        return common(document, bench.selection(), *property)
            .value.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    if (name == "branches") {
        const Timeline& timeline = document.timeline();
        return timeline.empty() ? 0 : static_cast<double>(timeline.others().size() + 1);
    }
    if (name == "past.pictures") return frame_.timeBar().pictures();
    if (name == "past.card") return frame_.sceneView().showsPast() ? 1 : 0;
    if (name == "speed") return frame_.sceneView().speedPermille() / 1000.0;
    if (name == "fps") return frame_.sceneView().framesPerSecond();
    if (name == "slide-cost") return slideCost_;
    const auto& series = bench.measurements().series();
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (name == "series") return static_cast<double>(series.size());
    if (name == "samples")
        return series.empty() ? 0 : static_cast<double>(series[0].samples.size());
    if (name == "plot.from") return frame_.plot().shown().first;
    if (name == "plot.to") return frame_.plot().shown().second;
    if (name == "plot.fit") return frame_.plot().fitValue().value_or(none);
    if (name == "plot.cursor") return frame_.plot().cursorValue().value_or(none);
    if (name == "page") return frame_.side().GetSelection() + 1;
    if (name == "instances") return static_cast<double>(instancesOf(document.scene()).size());
    if (name == "overrides") {
        std::size_t count = 0;
        for (const auto& one : instancesOf(document, bench.selection()))
            count += overrideCount(document, one);
        return static_cast<double>(count);
    }
    if (name == "templates")
        return static_cast<double>(frame_.side().library().grid().items().size());
    if (name == "swatch") return static_cast<double>(frame_.side().properties().swatchColours());
    if (name == "skins") {
        std::size_t count = 0;
        for (const auto& body : document.scene().bodies)
            if (!skinOf(document.plan().prefab(body.blueprint)).empty()) ++count;
        return static_cast<double>(count);
    }
    if (name == "pictures") return frame_.thumbnails().working() ? 1 : 0;
    if (name == "strays") return static_cast<double>(bench.strays().size());
    if (name == "film") return frame_.sceneView().guide().film() ? 1 : 0;
    if (name == "lesson.step") {
        const LessonRun* run = frame_.lesson().run();
        return run == nullptr ? none : static_cast<double>(run->step());
    }
    if (name == "gallery.pictures")
        return frame_.gallery() == nullptr ? 0 : static_cast<double>(frame_.gallery()->pictures());
    if (name == "lesson.showing") return frame_.lesson().showing() ? 1 : 0;
    if (name == "steps") return static_cast<double>(document.historyPlace());
    if (name == "newest.x" || name == "newest.y") {
        if (bodies.empty()) fail("there is no body");
        const sulfur::Point centre = world.centreOfMass(bodies.back());
        return name == "newest.x" ? centre.x() : centre.y();
    }
    fail("there is no quantity " + name);
}

bool Script::holds(const Words& words) const {
    const double is = quantity(words[1]);
    const double wanted = number(words[3]);
    const std::string& op = words[2];
    if (op == "=") return is == wanted;
    if (op == "!=") return is != wanted;
    if (op == "<") return is < wanted;
    if (op == ">") return is > wanted;
    fail("\"" + op + "\" is not one of = != < >");
}

void Script::expect(const Words& words) {
    if (holds(words)) return;
    std::ostringstream text;
    text << words[1] << " is " << quantity(words[1]) << ", expected " << words[2] << " "
         << words[3];
    fail(text.str());
}

}  // namespace sulfurchamber
