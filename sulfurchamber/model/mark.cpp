#include "mark.hpp"

#include "words.hpp"

namespace sulfurchamber {

std::string textOf(const Mark& mark) {
    switch (mark.kind) {
        case Mark::Kind::contact:
            return trCount("{} first contact", "{} first contacts", mark.count);
        case Mark::Kind::breakage:
            return trCount("{} joint breaks", "{} joints break", mark.count);
        case Mark::Kind::edit:
            break;
    }
    return tr(mark.label);
}

}  // namespace sulfurchamber
