#include <atlax/arguments.hpp>
#include <charconv>
#include <cmath>
#include <sstream>

namespace atlax {

std::function<std::string(const std::string&)> between(double low, double high) {
    return [low, high](const std::string& text) {
        double value = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, value);
        const bool whole = read.ec == std::errc() && read.ptr == end;
        if (whole && std::isfinite(value) && value >= low && value <= high) return std::string();
        std::ostringstream message;
        message << '"' << text << "\" is no number from " << low << " to " << high;
        return message.str();
    };
}

}  // namespace atlax
