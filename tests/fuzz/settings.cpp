// Whatever a settings file holds, it is read or refused with atlax::Error; what was read is written
// the same way again and again.
#include <atlax/error.hpp>
#include <atlax/settings.hpp>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const auto document = atlax::parseSettings(text, "fuzz");
        const std::string once = atlax::formatSettings(document);
        if (atlax::formatSettings(atlax::parseSettings(once, "again")) != once) std::abort();
    } catch (const atlax::Error&) {
    }
    return 0;
}
