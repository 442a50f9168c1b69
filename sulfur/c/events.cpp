// What happened during the last tick.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

namespace {

template <class Out, class In>
void copy(const std::vector<In>& from, std::vector<Out>& to) {
    to.clear();
    for (const In& event : from) to.push_back(toC(event));
}

}  // namespace

extern "C" {

SulfurResult sulfur_world_events(const SulfurWorld* world, SulfurEvents* events) {
    return call([&] {
        SulfurEvents& result = required(events, "a result");
        const Events& told = of(world).events();
        EventArrays& e = world->events;
        copy(told.contactsBegun, e.contactsBegun);
        copy(told.contactsPersisted, e.contactsPersisted);
        copy(told.contactsEnded, e.contactsEnded);
        copy(told.jointsBroken, e.jointsBroken);
        copy(told.bodiesSplit, e.bodiesSplit);
        copy(told.particlesLost, e.particlesLost);
        copy(told.sensorsEntered, e.sensorsEntered);
        copy(told.sensorsLeft, e.sensorsLeft);
        copy(told.limitsReached, e.limitsReached);
        copy(told.limitsLeft, e.limitsLeft);
        copy(told.mechanismsBroken, e.mechanismsBroken);
        copy(told.anglesBroken, e.anglesBroken);
        result = {e.contactsBegun.data(),     e.contactsBegun.size(),  e.contactsPersisted.data(),
                  e.contactsPersisted.size(), e.contactsEnded.data(),  e.contactsEnded.size(),
                  e.jointsBroken.data(),      e.jointsBroken.size(),   e.bodiesSplit.data(),
                  e.bodiesSplit.size(),       e.particlesLost.data(),  e.particlesLost.size(),
                  e.sensorsEntered.data(),    e.sensorsEntered.size(), e.sensorsLeft.data(),
                  e.sensorsLeft.size(),       e.limitsReached.data(),  e.limitsReached.size(),
                  e.limitsLeft.data(),        e.limitsLeft.size(),     e.mechanismsBroken.data(),
                  e.mechanismsBroken.size(),  e.anglesBroken.data(),   e.anglesBroken.size()};
    });
}

SulfurResult sulfur_world_contacts(const SulfurWorld* world, SulfurContactInfo* out,
                                   size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).contacts(); });
}

SulfurResult sulfur_body_contacts(const SulfurWorld* world, SulfurBodyId body,
                                  SulfurContactInfo* out, size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        std::vector<ContactInfo> found(of(world).contacts(fromC(body), {}));
        of(world).contacts(fromC(body), found);
        return found;
    });
}

SulfurResult sulfur_world_touches(const SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                  bool* touches) {
    return give(touches, [&] { return of(world).touches(fromC(a), fromC(b)); });
}

}  // extern "C"

}  // namespace sulfur::c
