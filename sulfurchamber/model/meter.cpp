#include "meter.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::scene::Limits;
using sulfur::scene::Node;
using sulfur::scene::Scene;

constexpr const char* metersKey = "meters";

struct KindOfMeter {
    std::string_view name;
    std::string_view title;
    std::size_t least;  // ends
    std::size_t most;
};
constexpr std::array<KindOfMeter, 5> kindsOfMeters{{{"ruler", "Ruler", 2, 2},
                                                    {"protractor", "Protractor", 3, 3},
                                                    {"tracer", "Tracer", 1, 1},
                                                    {"gauge", "Force gauge", 1, 2},
                                                    {"gun", "Speed gun", 2, 2}}};

const KindOfMeter& kindOf(MeterKind kind) {
    return kindsOfMeters[static_cast<std::size_t>(kind)];
}

MeterEnd readEnd(const Node& node, const Scene& scene) {
    MeterEnd end;
    end.at = node.at("at").point(Limits::coordinate * 10);
    const auto body = node.find("body");
    if (!body) return end;
    end.body = body->string(1, Limits::nameBytes);
    if (scene.body(end.body) == nullptr)
        body->fail(tr("is \"{}\"; allowed is the id of a body of the scene", {end.body}));
    if (const auto particle = node.find("particle"))
        end.particle =
            static_cast<std::uint32_t>(particle->integer(0, static_cast<int>(Limits::particles)));
    return end;
}

Meter readMeter(const Node& node, const Scene& scene) {
    Meter meter;
    meter.id = node.at("id").string(1, Limits::nameBytes);
    meter.kind = static_cast<MeterKind>(
        node.at("kind").choice({kindsOfMeters[0].name, kindsOfMeters[1].name, kindsOfMeters[2].name,
                                kindsOfMeters[3].name, kindsOfMeters[4].name}));
    const KindOfMeter& kind = kindOf(meter.kind);
    const Node ends = node.at("ends");
    for (const Node& end : ends.array(kind.least, kind.most))
        meter.ends.push_back(readEnd(end, scene));
    if (meter.kind == MeterKind::gauge)
        for (const MeterEnd& end : meter.ends)
            if (end.body.empty())
                ends.fail(tr("has an end without \"body\"; a gauge holds bodies"));
    return meter;
}

std::string numberOf(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value);
    double back = 0;
    for (int digits = 6; digits < 17; ++digits) {
        std::array<char, 32> shorter{};
        std::snprintf(shorter.data(), shorter.size(), "%.*g", digits, value);
        std::sscanf(shorter.data(), "%lf", &back);
        if (back == value) return shorter.data();
    }
    return text.data();
}

std::string jsonString(const std::string& words) {
    std::string text = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\') text += '\\';
        text += c == '\n' ? std::string("\\n") : c == '\t' ? std::string("\\t") : std::string(1, c);
    }
    return text + '"';
}

std::string jsonOf(const Meter& meter) {
    std::string text = "{\"id\": " + jsonString(meter.id) + ", \"kind\": \"" +
                       std::string(meterName(meter.kind)) + "\", \"ends\": [";
    for (const MeterEnd& end : meter.ends) {
        if (&end != &meter.ends.front()) text += ", ";
        text += "{\"at\": [" + numberOf(end.at.x()) + ", " + numberOf(end.at.y()) + "]";
        if (!end.body.empty()) text += ", \"body\": " + jsonString(end.body);
        if (end.particle) text += ", \"particle\": " + std::to_string(*end.particle);
        text += "}";
    }
    return text + "]}";
}

}  // namespace

std::string_view meterName(MeterKind kind) {
    return kindOf(kind).name;
}

std::string_view meterTitle(MeterKind kind) {
    return kindOf(kind).title;
}

std::vector<Meter> metersOf(const Scene& scene) {
    std::vector<Meter> meters;
    const auto section = scene.section(metersKey);
    if (!section) return meters;
    std::set<std::string> ids;
    for (const Node& node : section->root().array(0, mostMeters)) {
        meters.push_back(readMeter(node, scene));
        if (!ids.insert(meters.back().id).second)
            node.at("id").fail(tr("is \"{}\"; that is another meter's", {meters.back().id}));
    }
    return meters;
}

void setMeters(Scene& scene, std::span<const Meter> meters) {
    if (meters.empty()) {
        sulfur::scene::eraseExtra(scene.extra, metersKey);
        return;
    }
    std::string text = "[";
    for (const Meter& meter : meters)
        text += std::string(&meter == &meters.front() ? "" : ",") + "\n    " + jsonOf(meter);
    sulfur::scene::setExtra(scene.extra, metersKey, text + "\n  ]");
}

std::string addMeter(Scene& scene, Meter meter) {
    auto meters = metersOf(scene);
    if (meters.size() >= mostMeters)
        throw std::runtime_error(
            tr("there are {} meters already; a scene has no more", {std::to_string(mostMeters)}));
    const std::string base(meterName(meter.kind));
    const auto taken = [&](const std::string& id) {
        return std::any_of(meters.begin(), meters.end(),
                           [&](const Meter& other) { return other.id == id; });
    };
    meter.id = base;
    for (int n = 2; taken(meter.id); ++n) meter.id = base + std::to_string(n);
    meters.push_back(meter);
    setMeters(scene, meters);
    return meter.id;
}

void changeMeter(Scene& scene, const Meter& meter) {
    auto meters = metersOf(scene);
    for (Meter& one : meters)
        if (one.id == meter.id) one = meter;
    setMeters(scene, meters);
}

void removeMeters(Scene& scene, std::span<const std::string> ids) {
    auto meters = metersOf(scene);
    std::erase_if(meters, [&](const Meter& one) {
        return std::find(ids.begin(), ids.end(), one.id) != ids.end();
    });
    setMeters(scene, meters);
}

void forgetMeters(Scene& scene, const std::function<bool(const std::string& body)>& gone) {
    if (sulfur::scene::findExtra(scene.extra, metersKey) == nullptr) return;
    auto meters = metersOf(scene);
    std::erase_if(meters, [&](const Meter& meter) {
        return std::any_of(meter.ends.begin(), meter.ends.end(), [&](const MeterEnd& end) {
            return !end.body.empty() && gone(end.body);
        });
    });
    setMeters(scene, meters);
}

void forgetParticleInMeters(Scene& scene, const std::string& body, std::uint32_t particle) {
    if (sulfur::scene::findExtra(scene.extra, metersKey) == nullptr) return;
    auto meters = metersOf(scene);
    std::erase_if(meters, [&](const Meter& meter) {
        return std::any_of(meter.ends.begin(), meter.ends.end(), [&](const MeterEnd& end) {
            return end.body == body && end.particle == particle;
        });
    });
    for (Meter& meter : meters)
        for (MeterEnd& end : meter.ends)
            if (end.body == body && end.particle && *end.particle > particle) --*end.particle;
    setMeters(scene, meters);
}

void renameInMeters(Scene& scene, const std::string& from, const std::string& to) {
    auto meters = metersOf(scene);
    bool any = false;
    for (Meter& meter : meters)
        for (MeterEnd& end : meter.ends)
            if (end.body == from) {
                end.body = to;
                any = true;
            }
    if (any) setMeters(scene, meters);
}

}  // namespace sulfurchamber
