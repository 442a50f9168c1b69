// The level of the day, proven on the player's own machine before anybody is asked to play it.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

namespace quaoar {

/// Makes and proves the level of a date on a thread of its own, of low priority, and keeps both
/// files; what was kept before and still holds is taken at once. The functions belong to one
/// thread.
class Daily {
public:
    /// Courses of a day that are tried one after the other.
    static constexpr int mostPlans = 4;
    /// Simulated seconds that one of them gets.
    static constexpr double budget = 1500;

    /// Begins. Files lie in `folder`; those of other days that lie there go.
    Daily(std::filesystem::path folder, std::string date);
    ~Daily();
    Daily(const Daily&) = delete;
    Daily& operator=(const Daily&) = delete;

    /// Whether it is there, with a proof that holds. Nothing is ready as long as it is tried, and
    /// never where no course could be proven or nothing can be written.
    bool ready() const { return ready_; }
    /// Whether nothing more happens.
    bool ended() const { return ended_; }
    /// The level; its proof lies beside it.
    const std::filesystem::path& file() const { return file_; }
    /// In the player's data folder (XDG_DATA_HOME).
    static std::filesystem::path usualFolder();

private:
    void run(const std::stop_token& stop);
    bool isKept() const;
    bool prove(int plan, const std::stop_token& stop) const;
    void removeOthers() const;

    std::filesystem::path folder_;
    std::string date_;
    std::filesystem::path file_;
    std::atomic<bool> ready_ = false;
    std::atomic<bool> ended_ = false;
    std::jthread thread_;
};

}  // namespace quaoar
