// Force fields.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurField sulfur_field_default(SulfurFieldKind kind) {
    SulfurField field = toC(Field{});
    field.kind = kind;
    return field;
}

SulfurResult sulfur_world_add_field(SulfurWorld* world, const SulfurField* field,
                                    SulfurFieldId* id) {
    return give(id, [&] { return of(world).add(fromC(required(field, "the field"))); });
}

SulfurResult sulfur_field_set(SulfurWorld* world, SulfurFieldId field, const SulfurField* to) {
    return call([&] { of(world).set(fromC(field), fromC(required(to, "the field"))); });
}

SulfurResult sulfur_field_info(const SulfurWorld* world, SulfurFieldId field, SulfurField* info) {
    return give(info, [&] { return of(world).field(fromC(field)); });
}

SulfurResult sulfur_field_remove(SulfurWorld* world, SulfurFieldId field) {
    return call([&] { of(world).remove(fromC(field)); });
}

SulfurResult sulfur_field_exists(const SulfurWorld* world, SulfurFieldId field, bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(field)); });
}

SulfurResult sulfur_world_fields(const SulfurWorld* world, SulfurFieldId* out, size_t capacity,
                                 size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).fields(); });
}

}  // extern "C"

}  // namespace sulfur::c
