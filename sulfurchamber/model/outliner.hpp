// All that a scene has as rows of a tree: bodies in their groups, mechanisms, fields, thrusters.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "workbench.hpp"

namespace sulfurchamber {

struct OutlineRow {
    enum class Kind : std::uint8_t { group, body, mechanism, field };
    Kind kind = Kind::body;
    int depth = 0;      ///< in how many groups it lies
    std::string name;   ///< for people
    std::string group;  ///< of a group: all names from the outermost on
    bool open = true;   ///< of a group: whether what is in it follows
    /// Those that it means: one, those of the group, or those that the mechanism joins.
    std::vector<sulfur::BodyId> bodies = {};
    bool hidden = false;  ///< all of them
    bool locked = false;
    bool renamable = false;
    std::optional<FittingRef> fitting = {};  ///< what a mechanism, a field or a thruster is
};

/// Finds the rows when the document has changed, and not more often.
class Outliner {
public:
    /// Complexity: linear in what there is.
    const std::vector<OutlineRow>& rows(const Workbench& bench);
    /// Only rows whose names have this text, in any case, with the groups that they lie in.
    void setSearch(const std::string& text);
    const std::string& search() const { return search_; }
    /// Opens or closes a group.
    void toggle(const std::string& group);
    /// Grows whenever rows() has found others.
    std::uint64_t version() const { return version_; }

private:
    std::vector<OutlineRow> rows_;
    std::set<std::string> closed_;
    std::string search_;
    std::uint64_t revision_ = 0;
    std::uint64_t version_ = 0;
    bool fresh_ = true;
};

/// The rectangle around what a row means; nothing where nothing of it is there.
std::optional<Bounds> boundsOf(const Workbench& bench, const OutlineRow& row);
/// Gives a body or a group another name, as a step. Throws std::runtime_error where that is taken
/// or unusable.
void rename(Workbench& bench, const OutlineRow& row, const std::string& name);

}  // namespace sulfurchamber
