#include "table4.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <paper_tables.hpp>
#include <sulfur/shapes.hpp>
#include <sulfur/world.hpp>
#include <system_error>

namespace sulfurchamber {
namespace {

using sulfur::Real;
using sulfur::World;

constexpr double boxSide = 1;      // metres, as the paper's
constexpr double dropHeight = 29;  // metres above the ground
constexpr double wallHeight = 40;
constexpr double dropSpeed = 5;     // m/s downwards, so that boxes leave room for the next
constexpr double boxSpacing = 1.3;  // metres between boxes that drop at the same height

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Wide enough that boxes of the same moment do not meet in the air.
double arenaHalf(int rate) {
    return std::max(10.0, rate / 4.0);
}

void buildArena(World& world, double half) {
    const auto x = static_cast<Real>(half + 0.05);
    const auto top = static_cast<Real>(wallHeight);
    world.add(sulfur::shapes::ground(
        {.points = {{-x, top}, {-x, Real(-0.05)}, {x, Real(-0.05)}, {x, top}}}));
}

// The places go round the arena in steps of the golden section: no two neighbours in a row.
void dropOne(World& world, int number, double half) {
    const int slots = std::max(1, static_cast<int>((2 * half - boxSide) / boxSpacing));
    const double golden = std::fmod(number * 0.6180339887498949, 1.0);
    const int slot = std::min(slots - 1, static_cast<int>(golden * slots));
    const double x = -half + boxSide + slot * boxSpacing;
    const double angle = 0.6 * (std::fmod(number * 0.7548776662466927, 1.0) - 0.5);
    const sulfur::shapes::BoxOptions box{.size = {Real(boxSide), Real(boxSide)}, .mass = 1};
    const auto body = world.add(sulfur::shapes::box(box), {{x, dropHeight}, angle});
    world.setVelocity(body.id(), {0, static_cast<Real>(-dropSpeed)});
}

std::string percentText(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value < 10 ? "%.2f" : "%.1f", value);
    return text.data();
}

}  // namespace

std::span<const int> table4Rates() {
    return sulfur::lab::paperBoxRates();
}

std::vector<Table4Machine> table4Machines() {
    std::vector<Table4Machine> machines;
    for (const auto& machine : sulfur::lab::paperTable4())
        machines.push_back({machine.name, machine.percent});
    return machines;
}

void Table4::start(std::vector<int> rates, double seconds) {
    stop();
    {
        const std::lock_guard lock(mutex_);
        cells_.clear();
    }
    progress_ = 0;
    running_ = true;
    try {
        thread_ = std::jthread([this, rates = std::move(rates), seconds](std::stop_token stop) {
            run(stop, rates, seconds);
            running_ = false;
        });
    } catch (const std::system_error&) {
        running_ = false;
        throw;
    }
}

void Table4::stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

std::vector<Table4Cell> Table4::cells() const {
    const std::lock_guard lock(mutex_);
    return cells_;
}

void Table4::run(std::stop_token stop, std::vector<int> rates, double seconds) {
    for (std::size_t i = 0; i < rates.size(); ++i) {
        World world;
        const double half = arenaHalf(rates[i]);
        buildArena(world, half);
        const auto ticks =
            static_cast<int>(std::lround(seconds * static_cast<double>(world.settings().tickRate)));
        int made = 0;
        const double before = threadSeconds();
        for (int tick = 0; tick < ticks; ++tick) {
            if (stop.stop_requested()) return;
            for (; made < rates[i] * seconds && world.time() + 1e-9 >= made / double(rates[i]);
                 ++made)
                dropOne(world, made, half);
            world.step();
            progress_ =
                (static_cast<double>(i) + (tick + 1.0) / ticks) / static_cast<double>(rates.size());
        }
        const double taken = threadSeconds() - before;
        const std::lock_guard lock(mutex_);
        cells_.push_back({rates[i], 100 * taken / seconds, static_cast<std::size_t>(made)});
    }
}

std::string table4Csv(std::span<const Table4Cell> cells) {
    std::string text = "share of processor time (%) by boxes a second";
    for (const int rate : table4Rates()) text += "," + std::to_string(rate);
    text += "\n";
    for (const Table4Machine& machine : table4Machines()) {
        text += "\"paper: " + machine.name + "\"";
        for (const double percent : machine.percent) text += "," + percentText(percent);
        text += "\n";
    }
    text += "this machine";
    for (const int rate : table4Rates()) {
        text += ",";
        for (const Table4Cell& cell : cells)
            if (cell.rate == rate) text += percentText(cell.percent);
    }
    return text + "\n";
}

}  // namespace sulfurchamber
