#include <sulfur/version.hpp>

namespace sulfur {

const char* version() {
    return SULFUR_VERSION;
}

}  // namespace sulfur
