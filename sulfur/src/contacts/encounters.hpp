// Which bodies are near each other, and which of them touch.
#pragma once

#include <cstdint>
#include <sulfur/ids.hpp>

namespace sulfur::detail {

struct ContactCore;
struct State;

/// Whether two bodies, or two parts of one, touched at the end of the last tick.
bool areTouching(const ContactCore& core, BodyId a, BodyId b);
/// Whether two bodies pass through each other because the caller has said so when they came near.
bool passThrough(const ContactCore& core, BodyId a, BodyId b);
/// A new pair of chunks joins the encounter of its bodies, or begins one.
void enterEncounter(State& state, std::uint32_t pair);
/// A pair that ends leaves it.
void leaveEncounter(ContactCore& core, std::uint32_t pair);
/// So many rows more of an encounter press, or less.
void addPressing(ContactCore& core, std::uint32_t encounter, int more);
/// An impact of this step has struck an encounter; call the other when the next step begins.
void noteStruck(ContactCore& core, std::uint32_t encounter);
void forgetStruck(ContactCore& core);

}  // namespace sulfur::detail
