#include "model/influences.hpp"

namespace sulfur::detail {

namespace {

template <class Id, class List>
std::string validateHandles(const Slots<Id>& slots, const List& list, const char* what) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (!slots.contains(list[i].id) || slots.dense(list[i].id) != i)
            return std::string(what) + " handle leads elsewhere (index " + std::to_string(i) + ")";
    return {};
}

}  // namespace

std::string Influences::validate() const {
    if (!fieldSlots.sound() || !grabSlots.sound()) return "handles of influences that fit no list";
    for (std::size_t i = 0; i < grabs.size(); ++i) {
        const Grab& grab = grabs[i];
        if (grab.count < 1 || grab.count > grab.support.size())
            return "grab of no or too many particles (index " + std::to_string(i) + ")";
        if (!grab.target.allFinite() || !grab.impulse.allFinite())
            return "grab is not finite (index " + std::to_string(i) + ")";
    }
    const std::string broken = validateHandles(fieldSlots, fields, "field");
    return broken.empty() ? validateHandles(grabSlots, grabs, "grab") : broken;
}

}  // namespace sulfur::detail
