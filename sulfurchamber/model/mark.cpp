#include "mark.hpp"

namespace sulfurchamber {

std::string textOf(const Mark& mark) {
    const std::string count = std::to_string(mark.count);
    switch (mark.kind) {
        case Mark::Kind::contact:
            return count + (mark.count == 1 ? " first contact" : " first contacts");
        case Mark::Kind::breakage:
            return count + (mark.count == 1 ? " joint breaks" : " joints break");
        case Mark::Kind::edit:
            break;
    }
    return mark.label;
}

}  // namespace sulfurchamber
