// What a scene keeps of its bodies beside physics: groups, locks, what is hidden, what is in front;
// and putting bodies in order.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <sulfur/scene.hpp>
#include <vector>

namespace sulfurchamber {

class Document;
class Workbench;

/// Files keep these as members "group", "locked", "hidden" and "order" of the body, which mean
/// nothing to the physics and to other programs.
struct BodyMarks {
    std::string group;    ///< names from the outermost on, with '/' between; "": none
    bool locked = false;  ///< no click means it
    bool hidden = false;  ///< neither drawn nor picked; it moves as before
    int order = 0;        ///< higher is drawn in front, -1000000 to 1000000

    friend bool operator==(const BodyMarks&, const BodyMarks&) = default;
};
/// What is no value of such a member counts as if it were not there.
BodyMarks marksOf(const sulfur::scene::Placement& body);
void setMarks(sulfur::scene::Placement& body, const BodyMarks& marks);

/// The first name of a group, "" of none.
std::string outermost(const std::string& group);

/// The marks of bodies of a document, found out once until that changes. Pieces have none.
class MarkBook {
public:
    const BodyMarks& of(const Document& document, sulfur::BodyId body);

private:
    std::uint64_t revision_ = 0;
    std::map<sulfur::BodyId, BodyMarks> marks_;
};

/// Gives groups of a scene that will be inserted names that the other scene does not have.
void freshenGroups(sulfur::scene::Scene& inserted, const sulfur::scene::Scene& into);

// Each of these is one step of the history; without anything to do they are none.

/// The selection becomes a group; groups in it stay inside of it.
bool canGroup(const Workbench& bench);
void groupSelection(Workbench& bench);
/// The outermost groups of the selection are dissolved.
bool canUngroup(const Workbench& bench);
void ungroupSelection(Workbench& bench);
/// Gives a group another name, at its level; throws std::runtime_error when that is unusable.
void renameGroup(Workbench& bench, const std::string& group, const std::string& name);
/// What is locked or hidden is no longer selected.
void setLocked(Workbench& bench, std::span<const sulfur::BodyId> bodies, bool on);
void setHidden(Workbench& bench, std::span<const sulfur::BodyId> bodies, bool on);
void unlockAll(Workbench& bench);
void showAll(Workbench& bench);
/// How many bodies of the plan are locked, and hidden.
std::size_t lockedCount(const Document& document);
std::size_t hiddenCount(const Document& document);
/// In front of, or behind, all others that are drawn.
void orderSelection(Workbench& bench, bool front);

/// Which sides, or middles, come to stand in line.
enum class Alignment : std::uint8_t { left, centre, right, top, middle, bottom };
/// Needs two bodies or groups, each of which moves as a whole.
bool canAlign(const Workbench& bench);
void alignSelection(Workbench& bench, Alignment alignment);
/// Equal gaps between bodies or groups; needs three.
bool canDistribute(const Workbench& bench);
void distributeSelection(Workbench& bench, bool horizontally);

}  // namespace sulfurchamber
