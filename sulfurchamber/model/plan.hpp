// The plan of a scene: what is edited and saved. Plain data with names; knows no world.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <sulfur/scene.hpp>
#include <unordered_map>
#include <vector>

namespace sulfurchamber {

/// Calls change(name) for each body that connections, attachments, vetoes and mechanisms name.
void forEachTiedName(sulfur::scene::Scene& scene, const std::function<void(std::string&)>& change);

/// A scene with what makes it quick to edit: indices of its names, and equal blueprints shared.
///
/// Plain value, one thread. Functions that take an id expect one of the scene and throw
/// std::out_of_range otherwise.
class Plan {
public:
    Plan() = default;
    explicit Plan(sulfur::scene::Scene scene);

    const sulfur::scene::Scene& scene() const { return scene_; }
    /// For what has no function here: settings, unknown members. Not for bodies and blueprints.
    sulfur::scene::Scene& scene() { return scene_; }

    bool contains(std::string_view id) const;
    const sulfur::scene::Placement& body(std::string_view id) const;
    /// Its id and its blueprint must stay.
    sulfur::scene::Placement& body(std::string_view id);
    const sulfur::scene::Prefab& prefab(std::string_view name) const;
    /// The blueprint of a body with what its placement says otherwise.
    sulfur::Blueprint blueprint(std::string_view id) const;
    /// The same as a prefab, whose recipe says it too, if it can.
    sulfur::scene::Prefab dressed(std::string_view id) const;
    std::size_t particles() const { return particles_; }  ///< of all bodies
    std::size_t joints() const { return joints_; }  ///< of all bodies, with angles and connections

    /// Adds a body that has everything of `placement` but its id and its blueprint: an equal
    /// blueprint is shared, the id is made of the prefab's name. Returns the id.
    std::string add(sulfur::scene::Prefab prefab, sulfur::scene::Placement placement);
    /// Takes bodies out with what holds on to them, and blueprints that only they had.
    void remove(const std::vector<std::string>& ids);
    /// Changes the blueprints of these bodies; `change` sees each one once. What placements said
    /// otherwise becomes part of their blueprints. Others who share a blueprint keep what it was.
    void change(const std::vector<std::string>& ids,
                const std::function<void(sulfur::scene::Prefab&)>& change);
    /// Gives a body another id, wherever it is named. Throws std::runtime_error when that is taken
    /// or unusable, or when an unknown member of the scene, such as a level, names the body.
    void rename(const std::string& id, const std::string& to);
    void connect(sulfur::scene::Connection connection);
    void remove(std::size_t connection);
    /// Takes what mechanisms hold of a body along with it, from one pose of its frame to another.
    /// Their limits stay where they are in the world.
    void carryMechanisms(const std::string& id, const sulfur::Pose& from, const sulfur::Pose& to);
    /// All that hang together by connections, attachments and mechanisms with one of these, with
    /// themselves.
    std::vector<std::string> tiedTo(const std::vector<std::string>& ids) const;
    /// `base`, base2, base3, ...: the first that is free.
    std::string freeId(const std::string& base);

private:
    void index();
    void count(const sulfur::Blueprint& blueprint, int sign);
    std::string share(sulfur::scene::Prefab prefab);
    void forgetLostEnds();
    void forgetUnused(const std::vector<std::string>& names);

    sulfur::scene::Scene scene_;
    std::unordered_map<std::string, std::size_t> bodies_;
    std::unordered_map<std::string, std::size_t> prefabs_;
    std::unordered_map<std::string, std::size_t> users_;  ///< how many bodies have a blueprint
    std::unordered_map<std::string, std::string> texts_;  ///< of blueprints: their names
    std::unordered_map<std::string, int> numbers_;        ///< from which freeId() counts on
    std::size_t particles_ = 0;
    std::size_t joints_ = 0;
};

/// Makes the blueprint of a recipe anew, keeping what a recipe does not say: name, kind, filter,
/// sensor, self-collision, skin.
void rebuild(sulfur::scene::Prefab& prefab);

}  // namespace sulfurchamber
