// What the meters of a document show now, and what they have shown.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "document.hpp"
#include "measurement.hpp"
#include "meter.hpp"

namespace sulfurchamber {

/// What a meter of a kind tells; the first is what it shows. Their `get` is null: Meters reads
/// them.
std::span<const Quantity> readingsOf(MeterKind kind);
/// Those that this one has: a gauge tells a strain of joints alone.
std::span<const Quantity> readingsOf(const Meter& meter);

/// Follows the meters of a document. Each tick adds a sample of each reading; where time has been
/// rewound, samples from there on are replaced as it goes on. One thread.
class Meters {
public:
    /// `document` must outlive it.
    explicit Meters(const Document& document) : document_(document) {}

    /// Those of the plan, in their order.
    const std::vector<Meter>& all() const;
    /// Null when there is none of this id.
    const Meter* find(std::string_view id) const;
    /// Where an end is, metres, `alpha` of the next tick on; nothing when its body has broken.
    std::optional<sulfur::Point> place(const Meter& meter, std::size_t end, double alpha = 1) const;
    /// What a reading is at this moment; nothing where there is nothing to read, such as a beam in
    /// which nobody is.
    std::optional<double> read(const Meter& meter, const Quantity& reading) const;
    /// Where the beam of a gun ends: at its second end, or at what is in the way.
    std::optional<sulfur::Point> beamEnd(const Meter& gun) const;

    /// After each tick.
    void sample();
    void clear();
    /// Of this meter, in the order of readingsOf(); empty when there is none.
    std::span<const Series> record(std::string_view id) const;
    /// The last value of the meter's first reading until now; a gun keeps what has passed last.
    std::optional<Sample> last(const Meter& meter) const;
    /// The full scale of a gauge, N: a round number above what it has shown in the last 10 s.
    double scaleOf(const Meter& gauge) const;

private:
    // What a meter holds on to, found once and looked for again when it has another handle.
    struct Held {
        std::array<sulfur::BodyId, 3> bodies{};
        sulfur::JointId joint;
        sulfur::MechanismId mechanism;
        std::uint64_t searched = 0;  ///< state in which something was not found
    };
    struct Entry {
        Meter meter;
        std::vector<Series> series;
        mutable Held held;
    };

    void follow() const;
    const Entry& entryOf(const Meter& meter) const;
    std::uint64_t stamp() const;
    sulfur::BodyId bodyOf(const Entry& entry, std::size_t end) const;
    std::optional<double> readAngle(const Meter& meter) const;
    std::optional<double> readForce(const Entry& entry) const;
    std::optional<double> readStrain(const Entry& entry) const;
    std::optional<sulfur::JointId> jointOf(const Entry& entry) const;
    std::optional<double> mechanismForce(const Entry& entry) const;
    std::optional<double> readBeam(const Meter& gun) const;
    std::optional<sulfur::CastHit> hitOf(const Meter& gun) const;

    const Document& document_;
    mutable std::string text_;  ///< of the member that was read
    mutable std::vector<Entry> entries_;
    mutable std::vector<Meter> meters_;
};

/// A round number: 1, 2 or 5 times a power of ten, at least `value` and 1e-3.
double roundAbove(double value);

// -- picking and placing --

/// A meter under the pointer: one of its ends, or the whole.
struct MeterPick {
    std::string id;
    std::optional<std::size_t> end;  ///< nothing: between them
};
/// Where a gauge has its dial, for a pointer that reaches so far (metres), and how large it is.
sulfur::Point dialOf(const sulfur::Point& anchor, double reach);
double dialRadius(double reach);
/// What is within `reach` of a point.
std::optional<MeterPick> meterAt(const Meters& meters, const sulfur::Point& point, double reach);
/// An end at a place: at the particle within reach, on the body there, or in the world.
MeterEnd endAt(const Document& document, const sulfur::Point& point, double reach);
/// The ends of a gauge that is put there: a mechanism, a joint or a body; none where there is
/// nothing of the plan.
std::vector<MeterEnd> gaugeAt(const Document& document, const sulfur::Point& point, double reach);

}  // namespace sulfurchamber
