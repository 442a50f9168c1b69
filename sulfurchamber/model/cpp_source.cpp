#include "cpp_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "cpp_values.hpp"

namespace sulfurchamber {
namespace {

using sulfur::scene::Placement;
using sulfur::scene::Prefab;
using sulfur::scene::Scene;

constexpr std::array<std::string_view, 94> reservedWords{
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break",
    "case", "catch", "char", "char8_t", "char16_t", "char32_t", "class", "compl", "concept",
    "const", "consteval", "constexpr", "constinit", "const_cast", "continue", "co_await",
    "co_return", "co_yield", "decltype", "default", "delete", "do", "double", "dynamic_cast",
    "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if",
    "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr",
    "operator", "or", "or_eq", "private", "protected", "public", "register", "return", "short",
    "signed", "sizeof", "static", "static_assert", "struct", "switch", "template", "this", "throw",
    "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void",
    "volatile", "wchar_t", "while", "xor", "xor_eq",
    // What the source itself uses.
    "world", "plan", "build", "settings", "main", "std"};

// Names of C++ for names of the scene, each once.
class Identifiers {
public:
    // "left wheel" gives leftWheel, or LeftWheel after "make".
    std::string name(const std::string& wanted, const std::string& prefix = "") {
        std::string word = prefix;
        bool capital = !prefix.empty();
        for (const char c : wanted) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte >= 128 || std::isalnum(byte) == 0) {
                capital = !word.empty();
                continue;
            }
            word += capital ? static_cast<char>(std::toupper(byte)) : c;
            capital = false;
        }
        if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0)
            word = "body" + word;
        const bool reserved =
            std::find(reservedWords.begin(), reservedWords.end(), word) != reservedWords.end();
        std::string free = reserved ? word + "Body" : word;
        for (int n = 2; !used_.insert(free).second; ++n) free = word + "_" + std::to_string(n);
        return free;
    }

private:
    std::set<std::string> used_;
};

class SourceWriter {
public:
    explicit SourceWriter(const Scene& scene) : scene_(scene) {}

    std::string write() {
        put("// Made by SulfurChamber" +
            (scene_.title.empty() ? std::string() : " of the scene " + cpp::text(scene_.title)) +
            ". Build it with\n"
            "//   c++ -std=c++20 -O2 FILE.cpp $(pkg-config --cflags --libs sulfur)\n"
            "#include <cstdio>\n#include <cstdlib>\n#include <optional>\n"
            "#include <sulfur/sulfur.hpp>\n\nusing namespace sulfur;\n");
        for (const Prefab& prefab : scene_.blueprints) blueprint(prefab);
        put("WorldSettings settings() {\n    return " + cpp::text(scene_.settings) + ";\n}\n");
        build();
        main();
        return std::move(out_);
    }

private:
    void put(const std::string& text) { out_ += text + "\n"; }
    void line(const std::string& text) { out_ += "    " + text + "\n"; }

    void blueprint(const Prefab& prefab) {
        const auto& is = prefab.blueprint;
        const std::string name = identifiers_.name(is.name, "make");
        makers_.emplace(is.name, name);
        put("Blueprint " + name + "() {");
        const std::string call = cpp::text(prefab.generator);
        sulfur::Blueprint made;
        if (call.empty()) {
            line("Blueprint plan;");
        } else {
            made = sulfur::scene::build(prefab.generator);
            // A floor's recipe is a call without a material.
            const bool floor =
                std::holds_alternative<sulfur::scene::FloorOptions>(prefab.generator);
            if (floor) made.material = {};
            line("Blueprint plan = " + call + ";");
        }
        line("plan.name = " + cpp::text(is.name) + ";");
        if (call.empty()) {
            line("plan.particles = " + cpp::lines(is.particles, 4) + ";");
            if (!is.joints.empty()) line("plan.joints = " + cpp::lines(is.joints, 4) + ";");
            if (!is.angles.empty()) line("plan.angles = " + cpp::lines(is.angles, 4) + ";");
        }
        differences(made, is);
        if (is.selfCollision != made.selfCollision)
            line("plan.selfCollision = " + cpp::text(is.selfCollision) + ";");
        line("return plan;");
        put("}\n");
    }

    void differences(const sulfur::Blueprint& from, const sulfur::Blueprint& to) {
        if (to.kind != from.kind) line("plan.kind = " + cpp::text(to.kind) + ";");
        if (!(to.material == from.material))
            line("plan.material = " + cpp::text(to.material) + ";");
        if (!(to.filter == from.filter)) line("plan.filter = " + cpp::text(to.filter) + ";");
        if (to.sensor != from.sensor) line("plan.sensor = " + cpp::text(to.sensor) + ";");
    }

    void build() {
        put("void build(World& world) {");
        for (const Placement& placement : scene_.bodies) body(placement);
        for (const auto& one : scene_.connections)
            line("world.connect(" + particle(one.a) + ", " + particle(one.b) + ", " +
                 cpp::text(one.options) + ");");
        for (const auto& one : scene_.attachments)
            line("world.attach(" + particle(one.particle) + ", " + bodies_.at(one.body) + ", " +
                 cpp::text(one.point) + ");");
        for (const auto& one : scene_.vetoes)
            line("world.setCollision(" + bodies_.at(one.a) + ", " + bodies_.at(one.b) +
                 ", false);");
        for (const auto& one : scene_.fields) line("world.add(" + cpp::text(one.field) + ");");
        for (const auto& one : scene_.mechanisms)
            std::visit([&](const auto& spec) { mechanism(one.id, spec); }, one.spec);
        put("}\n");
    }

    void body(const Placement& placement) {
        const std::string name = identifiers_.name(placement.id);
        bodies_.emplace(placement.id, name);
        const Prefab& prefab = *scene_.prefab(placement.blueprint);
        std::string plan = makers_.at(placement.blueprint) + "()";
        const sulfur::Blueprint own = sulfur::scene::blueprintOf(scene_, placement);
        const std::size_t before = out_.size();
        differences(prefab.blueprint, own);
        if (out_.size() > before) {
            const std::string changes = std::exchange(out_, out_.substr(0, before)).substr(before);
            line("const BodyId " + name + " = [&] {");
            line("    Blueprint plan = " + plan + ";");
            put("    " + changes + "        return world.add(plan, " + cpp::text(placement.pose) +
                ").id();");
            line("}();");
        } else {
            line("const BodyId " + name + " = world.add(" + plan + ", " +
                 cpp::text(placement.pose) + ").id();");
        }
        if (placement.state)
            state(name, *placement.state, own);
        else if (placement.velocity != sulfur::Vec2(0, 0))
            line("world.setVelocity(" + name + ", " + cpp::text(placement.velocity) + ");");
        line("static_cast<void>(" + name + ");");
    }

    // As sulfur::scene::applyState does it.
    void state(const std::string& name, const sulfur::scene::BodyState& state,
               const sulfur::Blueprint& plan) {
        const bool disc = plan.particles.size() == 1;
        if (state.angle && disc)
            line("world.setPose(" + name + ", {" + cpp::text(state.positions[0]) + ", " +
                 cpp::text(*state.angle) + "});");
        const auto at = [&](std::size_t i) {
            return "world.particles(" + name + ")[" + std::to_string(i) + "]";
        };
        for (std::size_t i = 0; i < state.positions.size(); ++i)
            line("world.setPosition(" + at(i) + ", " + cpp::text(state.positions[i]) + ");");
        if (plan.kind == sulfur::BodyKind::fixed) return;
        for (std::size_t i = 0; i < state.velocities.size(); ++i)
            line("world.setVelocity(" + at(i) + ", " + cpp::text(state.velocities[i]) + ");");
        if (state.spin != 0 && disc)
            line("world.setVelocity(" + name + ", " + cpp::text(state.velocities[0]) + ", " +
                 cpp::text(state.spin) + ");");
    }

    std::string particle(const sulfur::scene::ParticleRef& ref) const {
        return "world.particles(" + bodies_.at(ref.body) + ")[" + std::to_string(ref.particle) +
               "]";
    }

    // --- mechanisms --------------------------------------------------------------------------

    std::string pair(const std::string& a, const std::string& b) const {
        return bodies_.at(a) + ", " + bodies_.at(b);
    }
    // Gears name their parts: those of a wheel mean its motor.
    void made(const std::string& id, const std::string& call, const char* part = "",
              const std::optional<sulfur::Drive>& drive = {}) {
        if (id.empty() && !drive) return line(call + ";");
        const std::string name = identifiers_.name(id.empty() ? "mechanism" : id);
        line("const MechanismId " + name + " = " + call + part + ";");
        if (!id.empty()) mechanisms_.emplace(id, name);
        if (drive) line("world.setDrive(" + name + ", " + cpp::text(*drive) + ");");
        line("static_cast<void>(" + name + ");");
    }
    void mechanism(const std::string& id, const sulfur::scene::Hinge& m) {
        made(id, "world.hinge(" + pair(m.a, m.b) + ", " + cpp::text(m.at) + ", " +
                     cpp::text(m.options) + ")");
    }
    void mechanism(const std::string& id, const sulfur::scene::Weld& m) {
        made(id,
             "world.weld(" + pair(m.a, m.b) + ", " + cpp::text(m.at) + ", " + cpp::text(m.options) +
                 ")",
             "", m.drive);
    }
    void mechanism(const std::string& id, const sulfur::scene::Slider& m) {
        std::string line = cpp::text(m.axis);
        if (!m.rail.empty()) {
            line.clear();
            for (const auto place : m.rail)
                line += (line.empty() ? "" : ", ") + ("world.joints(" + bodies_.at(m.a) + ")[") +
                        std::to_string(place) + "]";
            line = "std::vector<JointId>{" + line + "}";
        }
        made(id, "world.slider(" + pair(m.a, m.b) + ", " + cpp::text(m.at) + ", " + line + ", " +
                     cpp::text(m.options) + ")");
    }
    void mechanism(const std::string& id, const sulfur::scene::Wheel& m) {
        made(id,
             "world.wheel(" + pair(m.a, m.b) + ", " + cpp::text(m.at) + ", " + cpp::text(m.axis) +
                 ", " + cpp::text(m.options) + ")",
             id.empty() ? "" : ".motor");
    }
    void mechanism(const std::string& id, const sulfur::scene::Distance& m) {
        made(id, "world.distance(" + bodies_.at(m.a) + ", " + cpp::text(m.atA) + ", " +
                     bodies_.at(m.b) + ", " + cpp::text(m.atB) + ", " + cpp::text(m.options) + ")");
    }
    void mechanism(const std::string& id, const sulfur::scene::Pulley& m) {
        made(id,
             "world.pulley(" + bodies_.at(m.a) + ", " + cpp::text(m.atA) + ", " +
                 cpp::text(m.overA) + ", " + bodies_.at(m.b) + ", " + cpp::text(m.atB) + ", " +
                 cpp::text(m.overB) + ", " + bodies_.at(m.frame) + ", " + cpp::text(m.options) +
                 ")",
             "", m.drive);
    }
    void mechanism(const std::string& id, const sulfur::scene::Gear& m) {
        made(id,
             "world.gear(" + mechanisms_.at(m.first) + ", " + mechanisms_.at(m.second) + ", " +
                 cpp::text(m.ratio) + ")",
             "", m.drive);
    }

    void main() {
        put("// Runs for five seconds, or for as many ticks as the first argument says.\n"
            "int main(int argc, char** argv) {\n"
            "    World world(settings());\n"
            "    build(world);\n"
            "    const int ticks = argc > 1 ? std::atoi(argv[1]) : 5 * world.settings().tickRate;\n"
            "    for (int tick = 0; tick < ticks; ++tick) world.step();\n"
            "    for (const BodyId body : world.bodies()) {\n"
            "        const Point at = world.centreOfMass(body);\n"
            "        std::printf(\"%-20s %9.3f m %9.3f m\\n\", world.name(body).c_str(), at.x(), "
            "at.y());\n"
            "    }\n"
            "    std::printf(\"hash %016llx\\n\", static_cast<unsigned long "
            "long>(world.hash()));\n"
            "}");
    }

    const Scene& scene_;
    std::string out_;
    Identifiers identifiers_;
    std::map<std::string, std::string> makers_;
    std::map<std::string, std::string> bodies_;
    std::map<std::string, std::string> mechanisms_;
};

}  // namespace

std::string cppSource(const Scene& scene) {
    return SourceWriter(scene).write();
}

}  // namespace sulfurchamber
