#include "stage_times.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <map>

#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Stage;
using sulfur::World;

constexpr double fading = 0.995;  // of what is old, each tick: some 200 ticks count
constexpr int warmTicks = 5;      // caches fill, and neighbours fall into the gap
constexpr int countedTicks = 45;
constexpr double noise = 0.03;  // shares below cannot be told from chance

double sumOfStages(const sulfur::Statistics& tick) {
    double sum = 0;
    for (const double one : tick.seconds) sum += one;
    return sum;
}

std::vector<std::vector<BodyId>> groupsOf(const Document& document) {
    const World& world = document.world();
    std::vector<std::vector<BodyId>> groups;
    std::map<BodyId, std::size_t> placeOf;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) == sulfur::BodyKind::fixed || placeOf.contains(body)) continue;
        std::vector<BodyId> group{body};
        // What hangs together costs together; the ground ties nobody.
        if (const std::string id = document.idOf(body); !id.empty())
            for (const std::string& other : document.plan().tiedTo({id})) {
                const BodyId tied = document.bodyOf(other);
                if (tied && tied != body && world.kind(tied) != sulfur::BodyKind::fixed &&
                    !placeOf.contains(tied))
                    group.push_back(tied);
            }
        for (const BodyId member : group) placeOf[member] = groups.size();
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace

std::string stageTitle(Stage stage) {
    std::string title = sulfur::name(stage);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

void StageTimes::add(const sulfur::Statistics& tick) {
    weight_ = weight_ * fading + 1;
    for (std::size_t i = 0; i < stages; ++i) mean_[i] += (tick.seconds[i] - mean_[i]) / weight_;
}

double StageTimes::seconds(Stage stage) const {
    return mean_[static_cast<std::size_t>(stage)];
}

double StageTimes::seconds() const {
    double sum = 0;
    for (const double one : mean_) sum += one;
    return sum;
}

CostSearch::CostSearch(const Document& document) : base_(document.world().clone()) {
    base_.setProfiling(true);
    auto groups = groupsOf(document);
    const World& world = document.world();
    const auto awake = [&](const std::vector<BodyId>& group) {
        std::size_t particles = 0;
        for (const BodyId body : group)
            if (!world.asleep(body)) particles += world.particles(body).size();
        return particles;
    };
    std::stable_sort(groups.begin(), groups.end(),
                     [&](const auto& a, const auto& b) { return awake(a) > awake(b); });
    for (auto& group : groups) {
        if (candidates_.size() == mostCandidates || awake(group) == 0) break;
        const std::string id = document.idOf(group.front());
        std::string name = id.empty() ? tr("a piece of {}", {world.name(group.front())}) : id;
        if (group.size() > 1) name = tr("{} with what it is tied to", {name});
        candidates_.push_back({std::move(name), std::move(group)});
    }
    runs_.resize(candidates_.empty() ? 0 : candidates_.size() + 1);
}

void CostSearch::begin(std::size_t run) {
    runs_[run].world = base_.clone();
    if (run == 0) return;
    for (const BodyId body : candidates_[run - 1].bodies) runs_[run].world->remove(body);
}

bool CostSearch::goOn(double milliseconds) {
    using Clock = std::chrono::steady_clock;
    const auto until = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
    while (current_ < runs_.size() && Clock::now() < until) {
        Run& run = runs_[current_];
        if (!run.world) begin(current_);
        run.world->step();
        if (++run.ticks > warmTicks) run.seconds.push_back(sumOfStages(run.world->statistics()));
        if (run.ticks < warmTicks + countedTicks) continue;
        run.world.reset();
        ++current_;
    }
    return current_ == runs_.size();
}

double CostSearch::progress() const {
    if (runs_.empty()) return 1;
    const double part =
        current_ < runs_.size() ? runs_[current_].ticks / double(warmTicks + countedTicks) : 0;
    return (static_cast<double>(current_) + part) / static_cast<double>(runs_.size());
}

double CostSearch::medianOf(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<ObjectCost> CostSearch::costs() const {
    std::vector<ObjectCost> found;
    if (current_ < runs_.size() || runs_.empty()) return found;
    const double all = medianOf(runs_[0].seconds);
    for (std::size_t i = 0; i < candidates_.size() && all > 0; ++i) {
        const double share = 1 - medianOf(runs_[i + 1].seconds) / all;
        if (share > noise) found.push_back({candidates_[i].name, share});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const ObjectCost& a, const ObjectCost& b) { return a.share > b.share; });
    return found;
}

}  // namespace sulfurchamber
