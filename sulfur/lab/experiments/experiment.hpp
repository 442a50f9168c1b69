// An experiment of the laboratory, as the program runs it.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sulfur::lab {

/// What an experiment found, in every form that it can be shown in.
struct Report {
    std::string text, csv, json;
    struct Picture {
        std::string file;  ///< name without a folder
        std::string svg;
    };
    std::vector<Picture> pictures = {};
    bool passed = true;  ///< false: something did not hold that must
};

class Experiment {
public:
    virtual ~Experiment() = default;
    virtual std::string name() const = 0;
    virtual std::string description() const = 0;
    /// Adds the experiment's own options.
    virtual void declare(CLI::App& app) = 0;
    virtual Report run() = 0;
};

using Experiments = std::vector<std::unique_ptr<Experiment>>;

/// All of them, in the order of --list.
Experiments allExperiments();

std::unique_ptr<Experiment> makeTable2();
std::unique_ptr<Experiment> makeTable3();
std::unique_ptr<Experiment> makeAccuracy();
std::unique_ptr<Experiment> makeStability();
std::unique_ptr<Experiment> makeBroadPhase();
std::unique_ptr<Experiment> makeBench();
std::unique_ptr<Experiment> makeTable4();
std::unique_ptr<Experiment> makeScaling();
std::unique_ptr<Experiment> makeSkip();
std::unique_ptr<Experiment> makeMemory();

}  // namespace sulfur::lab
