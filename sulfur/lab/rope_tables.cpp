#include "rope_tables.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

namespace sulfur::lab {

RopeTableResult measure(const PaperTable& table, const RopeConstants& rope,
                        const std::vector<Damper>& dampers, const SearchOptions& search) {
    const auto& entries = integrators();
    const std::size_t columns = table.columns.size();
    RopeTableResult result{&table, rope, dampers, search, {}};
    result.rows.assign(entries.size(), std::vector<Cell>(columns));
    // The slow ones, which come last, are begun first.
    std::atomic<std::size_t> next = entries.size() * columns;
    const auto work = [&] {
        for (std::size_t n = next.fetch_sub(1); n >= 1 && n <= entries.size() * columns;
             n = next.fetch_sub(1)) {
            const auto row = (n - 1) / columns, column = (n - 1) % columns;
            const auto& entry = entries[row];
            const auto [rate, damping] = table.columns[column];
            RopeConstants constants = rope;
            constants.damping = damping;
            Cell& cell = result.rows[row][column];
            for (const Damper damper : dampers) {
                constants.damper = damper;
                cell.found.push_back(findLimit(constants, entry, rate, search));
            }
            cell.theory = linearLimit(entry, {rope.mass, damping, 1 / rate}, search.highest);
            cell.paper = table.limit(entry.paperRow, column);
        }
    };
    std::vector<std::future<void>> others;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        others.push_back(std::async(std::launch::async, work));
    work();
    for (auto& other : others) other.get();  // throws what it has thrown
    return result;
}

}  // namespace sulfur::lab
