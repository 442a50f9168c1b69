// The stages of contact: from the motion that forces alone predict to the one that contacts allow.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

struct State;
struct ContactCore;
struct ContactLoad;
struct SweepKind;

/// Shapes, pairs and lists follow bodies that were made, changed, fell asleep or woke.
void updateShapes(State& state);
/// Couples against rolling change the spins of rigid components, before their motion is predicted.
void resistRolling(State& state);
/// Solver bodies take up the predicted motion, and what rows gave in the last step.
void takeMotion(State& state);
/// Boxes that something leaves in this step are made anew, with their pairs.
void updateBoxes(State& state);
/// What a driver squeezes against something that cannot give way begins the next step without
/// impulses.
void forgetVain(State& state);
/// Bodies that were put into each other are led apart; when the step ends, their places too.
void leadApart(State& state);
void endLeads(State& state);
/// Pairs that may have come to touch are looked at; rows are made, changed and taken away.
void lookAtPairs(State& state);
/// Rows take up how their bodies have moved and turned.
void refreshRows(State& state);
/// Stacks that begin to rest begin with the loads of statics. An accelerator: without this call all
/// works, and large piles take longer to settle.
void loadStacks(State& state);
/// Rows are swept for the `number`-th time in this step, from 1 to 255. Returns whether that has
/// stirred anybody: has changed how fast surfaces part.
bool sweepRows(State& state, int number, SweepKind kind);
/// Whom forces and what rows begin with would throw, rows give less. `answer`: trees and networks
/// answer what has not been given yet.
void forgetWild(State& state, void (*answer)(State&));
/// Impacts with restitution change the predicted motion; when the step ends, also places.
void strikeRows(State& state);
void endBlows(State& state);
/// With Friction::sliding, what presses brakes what slides.
void dragRows(State& state);
/// What moves as one, because it sticks to each other, loses what deviates from that.
void dampSticking(State& state);
/// Places of what would pass through something stay before it.
void holdBackFast(State& state);
/// Events of contacts: who begins to touch, goes on, and parts.
void tellContacts(State& state);
/// Particles and rigid components that are tied take up what the rows have given since they took
/// it.
void giveMotion(State& state);
/// And the other way, before the `number`-th sweep, when somebody else has changed it: whom it
/// stirs is swept again.
void takeMotionOfTied(State& state, int number);
/// The same of all.
void takeMotionAgain(State& state);
/// The same at the end of the step; places take up what the rows have pushed.
void endMotion(State& state);

/// Points that push, with the impacts of the last step; with those of sleepers where it is asked
/// for.
void exportContacts(const State& state, std::vector<ContactLoad>& contacts, bool sleepers);
/// The same of one body, by dense index, with sleepers.
void exportContactsOf(const State& state, std::uint32_t body, std::vector<ContactLoad>& contacts);
/// Sleepers wake that lie in the way, in this step, of what the caller or an impact of the last
/// step has set in motion.
void wakeInTheWay(State& state);
/// Bodies that something comes near wake; those at rest fall asleep.
void updateSleep(State& state);

/// Puts a body to sleep with its island, also what moves. Returns whether it sleeps then. State has
/// room to note all bodies as turned, and members where their clusters are.
bool sleepIsland(State& state, std::uint32_t body);
/// Wakes a body that goes away or leaves its place, and what is near or tied to it.
void wakeTouching(State& state, std::uint32_t body);
/// Whether a body, by slot, is tied to another one or to itself.
bool hasLinks(const ContactCore& core, std::uint32_t bodySlot);

/// Takes away pairs, rows and chunks of a body, by its slot; impulses are kept for heirs.
void removeShape(State& state, std::uint32_t bodySlot);
/// Takes a body that goes away, by dense index, out of all that contacts and sensors know.
void forgetBody(State& state, std::uint32_t body);
/// It can then be done without taking memory, for the body of a slot.
void makeRoomToForget(State& state, std::uint32_t bodySlot);

}  // namespace sulfur::detail
