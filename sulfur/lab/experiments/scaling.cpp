// scaling: how the time of a tick grows with what is in the world.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/clock.hpp"
#include "bench/plots.hpp"
#include "bench/show.hpp"
#include "bench/ticks.hpp"
#include "experiments/experiment.hpp"

namespace sulfur::lab {

namespace {

struct Curve {
    bench::Growth growth;
    std::vector<bench::Spread> times;  ///< s, one for each size
    bench::PowerLaw law;
};

class Scaling final : public Experiment {
public:
    std::string name() const override { return "scaling"; }
    std::string description() const override {
        return "time of a tick against bodies, joints, contacts, sleepers, extent, threads";
    }

    void declare(CLI::App& app) override {
        app.add_flag("--quick", quick_, "Only the three smallest sizes, shorter measurements");
        std::vector<std::string> keys;
        for (const bench::Growth& growth : bench::growths(false)) keys.push_back(growth.key);
        app.add_option("--only", only_, "Only these")->check(CLI::IsMember(keys));
    }

    Report run() override {
        const bench::TickOptions options =
            quick_ ? bench::TickOptions{.warmUp = 10, .ticks = 10, .repeats = 3}
                   : bench::TickOptions{};
        std::vector<Curve> all;
        for (bench::Growth& growth : bench::growths(quick_)) {
            if (!only_.empty() && std::find(only_.begin(), only_.end(), growth.key) == only_.end())
                continue;
            Curve measured{std::move(growth), {}, {}};
            std::optional<bench::Pinned> pin;
            if (!measured.growth.threads) pin.emplace();
            std::vector<std::pair<double, double>> points;
            for (const double size : measured.growth.sizes) {
                const auto world = measured.growth.make(size);
                measured.times.push_back(bench::tickTime(*world, options, measured.growth.threads));
                points.emplace_back(size, measured.times.back().median);
            }
            measured.law = bench::fitPowerLaw(points);
            all.push_back(std::move(measured));
        }
        Report report{asText(all), asCsv(all), asJson(all)};
        for (const Curve& measured : all)
            report.pictures.push_back(
                {"scaling_" + measured.growth.key + ".svg", picture(measured)});
        return report;
    }

private:
    static std::string asText(const std::vector<Curve>& all) {
        std::string out =
            "Time of a tick, microseconds of processor time: the median, and the exponent p of "
            "time = c size^p\nthrough all sizes. One thread, but where threads are what grows: "
            "there on the wall.\n";
        for (const Curve& m : all) {
            out += fmt::format("\n{}: p = {:.2f}\n", m.growth.title, m.law.exponent);
            for (std::size_t i = 0; i < m.times.size(); ++i)
                out += fmt::format("{:>12g}{:>14.1f}  ({:.1f} - {:.1f})\n", m.growth.sizes[i],
                                   1e6 * m.times[i].median, 1e6 * m.times[i].least,
                                   1e6 * m.times[i].most);
        }
        return out;
    }

    static std::string asCsv(const std::vector<Curve>& all) {
        std::string out = "growth,size,tick_s,least_s,most_s,exponent\n";
        for (const Curve& m : all)
            for (std::size_t i = 0; i < m.times.size(); ++i)
                out += fmt::format("{},{},{},{},{},{}\n", m.growth.key, m.growth.sizes[i],
                                   m.times[i].median, m.times[i].least, m.times[i].most,
                                   m.law.exponent);
        return out;
    }

    static std::string asJson(const std::vector<Curve>& all) {
        std::string out = "{\n  \"growths\": [";
        const char* separator = "\n";
        for (const Curve& m : all) {
            out += fmt::format("{}    {{\"growth\": {}, \"exponent\": {}, \"points\": [", separator,
                               bench::jsonText(m.growth.key), bench::jsonNumber(m.law.exponent));
            separator = ",\n";
            for (std::size_t i = 0; i < m.times.size(); ++i)
                out += fmt::format("{}{{\"size\": {}, \"tick\": {}}}", i == 0 ? "" : ", ",
                                   m.growth.sizes[i], bench::jsonNumber(m.times[i].median));
            out += "]}";
        }
        return out + "\n  ]\n}\n";
    }

    static std::string picture(const Curve& m) {
        Plot plot;
        plot.title = "Time of a tick: " + m.growth.title;
        plot.xTitle = m.growth.title;
        plot.yTitle = "time of a tick (microseconds)";
        plot.xLogarithmic = true;
        Series series{"measured", bench::colourOf("sulfur"), false, true, false, {}};
        Series law{fmt::format("size^{:.2f}", m.law.exponent), "#707070", true, false, true, {}};
        for (std::size_t i = 0; i < m.times.size(); ++i) {
            const double size = m.growth.sizes[i];
            series.points.emplace_back(size, 1e6 * m.times[i].median);
            law.points.emplace_back(size, 1e6 * m.law.factor * std::pow(size, m.law.exponent));
        }
        plot.series = {std::move(series), std::move(law)};
        bench::fitAxes(plot);
        return draw(plot);
    }

    bool quick_ = false;
    std::vector<std::string> only_;
};

}  // namespace

std::unique_ptr<Experiment> makeScaling() {
    return std::make_unique<Scaling>();
}

}  // namespace sulfur::lab
