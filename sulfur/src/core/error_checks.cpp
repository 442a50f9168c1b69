#include "core/error_checks.hpp"

#include <algorithm>
#include <sstream>

#include "core/limits.hpp"

namespace sulfur::detail {

namespace {

[[noreturn]] void refuse(ErrorCode code, const Subject& what, double value,
                         const std::string& allowed) {
    std::ostringstream message;
    message << what.text() << " is " << value << "; allowed is " << allowed;
    throw Error(code, message.str());
}

}  // namespace

std::string Subject::text() const {
    return kind ? std::string(kind) + ' ' + std::to_string(index) + ": " + property : property;
}

void requireFinite(double value, const Subject& what) {
    if (!std::isfinite(value)) refuse(ErrorCode::notFinite, what, value, "a finite number");
}

void requireRange(double value, double low, double high, const Subject& what) {
    requireFinite(value, what);
    if (value >= low && value <= high) return;
    std::ostringstream allowed;
    allowed << low << " to " << high;
    refuse(ErrorCode::outOfRange, what, value, allowed.str());
}

void requirePositive(double value, const Subject& what) {
    requireFinite(value, what);
    if (!(value > 0)) refuse(ErrorCode::outOfRange, what, value, "more than 0");
}

void requireNonNegativeOrInfinite(double value, const Subject& what) {
    if (std::isnan(value)) refuse(ErrorCode::notFinite, what, value, "0 to infinity");
    if (value < 0) refuse(ErrorCode::outOfRange, what, value, "0 to infinity");
}

void requireMassRatio(double one, double other, const Subject& what) {
    const auto [low, high] = std::minmax(one, other);
    if (high <= maxMassRatio * low) return;
    std::ostringstream message;
    message << what.text() << " of " << low << " kg beside " << high
            << " kg in what is tied together; allowed is a ratio of at most " << maxMassRatio;
    throw Error(ErrorCode::outOfRange, message.str());
}

void validate(const Material& material) {
    requireRange(static_cast<double>(material.kineticFriction), 0, 1e6, "kinetic friction");
    requireRange(static_cast<double>(material.staticFriction),
                 static_cast<double>(material.kineticFriction), 1e6, "static friction");
    requireRange(static_cast<double>(material.restitution), 0, 1, "restitution");
    requireRange(static_cast<double>(material.surfaceSpeed), -1000, 1000, "surface speed");
    requireRange(static_cast<double>(material.rollingResistance), 0, 1000, "rolling resistance");
}

}  // namespace sulfur::detail
