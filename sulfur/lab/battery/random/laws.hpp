// What random worlds must keep, and who breaks it.
#pragma once

#include <string>
#include <vector>

#include "battery/random/scene.hpp"

namespace sulfur::lab {

/// The laws, from the plainest on.
enum class Law : std::uint8_t {
    /// Every place and every velocity is a number.
    finite,
    /// World::validate() finds nothing, at nine moments.
    valid,
    /// A copy that is restored in the middle goes on to the bit for 20 ticks.
    restore,
    /// Nothing of a surface is behind the axis of a wall of the room, m.
    walls,
    /// Among drivers nobody goes faster than these throw: (1 + e)^3 times 1.25 times the speed of
    /// what is fastest at first, a fall through the room included. Three throws in a row, and a
    /// quarter for what is squeezed; the battery's worst so far are twenty times that.
    speed,
    /// In a closed world the sum of m v is that of the start to 1e-5 of the largest sum of m |v|
    /// seen. Everything that moves counts there, so that rounding of the heavy may not be asked
    /// of the light.
    momentum,
    /// Likewise for the sum of m r x v and of the spin of discs, about the centre at the start, over
    /// m |r| |v|.
    angularMomentum,
    /// Without a driver, kinetic, elastic and gravitational energy are together at most those of
    /// the
    /// start and 1 % of what was kinetic then and of what gravity has given since. (Everything
    /// starts unstrained. Whether a velocity is that of the start or of the middle of the tick
    /// before makes m g v h, which is allowed too.)
    energy,
    /// Of a closed world with sleepers: the sums of m v with and without sleeping are the same, to
    /// 1e-5 as above.
    sleeping,
    /// What has friction and little rebound and does not roll moves less than 2 cm in the last
    /// second of seven.
    rest,
};
inline constexpr std::size_t lawCount = 10;

/// Its name, for tables.
const char* name(Law law);
/// The law of a name; throws std::out_of_range.
Law lawOf(const std::string& name);

/// All laws.
std::vector<Law> allLaws();

/// A law that does not hold.
struct Breach {
    Law law = Law::finite;
    double measured = 0;  ///< the worst
    double bound = 0;
    long tick = 0;  ///< the first at which it was seen
};

/// Runs a scene and returns what is broken of `laws`, each once.
std::vector<Breach> judge(const Scene& scene, const std::vector<Law>& laws);

/// Makes a scene smaller, piece by piece, as long as the law stays broken. A scene that keeps the
/// law is returned as it is.
Scene shrink(const Scene& scene, Law law);

}  // namespace sulfur::lab
