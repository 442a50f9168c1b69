// World: looking at attachments.
#include "world/impl.hpp"

namespace sulfur {

std::vector<AttachmentId> World::attachments() const {
    std::vector<AttachmentId> found;
    for (const detail::Attachment& held : impl_->state().attachments) found.push_back(held.id);
    return found;
}

AttachmentInfo World::info(AttachmentId id) const {
    const detail::State& state = impl_->state();
    const detail::Attachment& held = state.attachments[detail::indexOf(state, id)];
    AttachmentInfo info;
    info.particle = state.particles.id[held.particle];
    info.count = held.count;
    for (std::uint32_t k = 0; k < held.count; ++k) {
        info.supports[k] = state.particles.id[held.support[k]];
        info.weights[k] = held.weight[k];
    }
    return info;
}

}  // namespace sulfur
