// What is open in SulfurChamber: a scene, its running world and the history of its edits. Knows
// nothing of windows.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <sulfur/scene.hpp>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfurchamber {

/// The constants that one turns while the simulation runs.
struct Constants {
    double gravity = 9.81;   ///< m/s^2 downwards; negative lets things rise
    double elasticity = 1;   ///< factor on the stiffness of all elastic joints
    double friction = 1;     ///< factor on the sliding and static friction of all bodies
    double airFriction = 0;  ///< 1/s
};

/// Bounds of Constants, for sliders and for checks.
struct ConstantLimits {
    static constexpr double gravity = 30;  ///< -gravity to gravity
    static constexpr double minElasticity = 0.05;
    static constexpr double maxElasticity = 20;
    static constexpr double friction = 3;     ///< 0 to friction
    static constexpr double airFriction = 5;  ///< 0 to airFriction, and at most the tick rate
};

/// One scene with its world.
///
/// Every change goes through edit() (or begin() and commit()), which remembers the state before,
/// so that it can be undone exactly: undo goes back to the moment before the change, also when
/// time has passed since. Ticks by themselves are no edits: a scene that was only played has no
/// unsaved changes.
///
/// One thread. Functions that cannot do what they promise throw std::exception with one sentence
/// and leave the document as it was.
class Document {
public:
    /// A new scene: an empty floor.
    Document();
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    // -- files --

    /// Starts over with an empty floor.
    void clear();
    /// Reads a scene or a level. Throws sulfur::scene::ReadError.
    void open(const std::filesystem::path& file);
    /// Takes a scene without a file, such as a new one. Throws as open() does.
    void adopt(sulfur::scene::Scene scene);
    /// The state of this moment as a scene.
    sulfur::scene::Scene capture() const;
    /// Writes the state of this moment, in one piece or not at all. Throws
    /// sulfur::scene::WriteError or ReadError.
    void save(const std::filesystem::path& file);
    /// Empty until the scene was opened from a file or saved.
    const std::filesystem::path& file() const { return file_; }
    /// The file's name, or "Untitled".
    std::string name() const;
    const sulfur::scene::Scene& scene() const { return scene_; }
    /// Whether there are edits that are not saved.
    bool modified() const { return state_ != savedState_; }

    // -- the world --

    sulfur::World& world() { return *world_; }
    const sulfur::World& world() const { return *world_; }
    /// Grows with everything that may change what a view has derived from the world, except
    /// for ticks: edits, undo, other files.
    std::uint64_t revision() const { return revision_; }

    // -- time --

    bool playing() const { return playing_; }
    void play();
    void pause() { playing_ = false; }
    /// Advances by one tick, playing or not.
    void tick();
    /// Whether time has passed since the state to which reset() returns.
    bool canReset() const { return beforePlay_ != nullptr; }
    /// Back to the state before the first play or tick, also undoing what was edited since. Stops
    /// playing. Can itself be undone.
    void reset();

    // -- edits --

    /// Runs `change` as one step of the history. When it throws, the world is as before and the
    /// exception goes on.
    void edit(const std::string& label, const std::function<void(sulfur::World&)>& change);
    /// Begins a step that takes a while, such as a drag. Commits one that is open.
    void begin(const std::string& label);
    void commit();
    /// Undoes what was done since begin().
    void rollback();
    bool editing() const { return open_ != nullptr; }

    bool canUndo() const { return !undo_.empty() || open_ != nullptr; }
    bool canRedo() const { return !redo_.empty(); }
    /// Both stop playing.
    void undo();
    void redo();
    /// Label of the step that undo() or redo() would take, "" when there is none.
    std::string undoLabel() const;
    std::string redoLabel() const;

    // -- constants --

    const Constants& constants() const { return constants_; }
    /// What the scene began with.
    const Constants& initialConstants() const { return initialConstants_; }
    /// Sets one or several constants, clamped to their limits, as a part of the open edit, or as
    /// an edit of its own.
    void setConstants(const Constants& constants);
    /// Things made by a tool get the factors of the moment, too. Part of an edit.
    sulfur::Body addScaled(const sulfur::Blueprint& blueprint, const sulfur::Pose& pose);

private:
    struct Checkpoint;
    struct Step;

    std::unique_ptr<Checkpoint> checkpoint() const;
    void restore(const Checkpoint& checkpoint);
    void startTime();
    void push(std::deque<Step>& steps, Step step);
    void applyElasticity(double factor);
    void applyFriction(double factor);

    sulfur::scene::Scene scene_;
    sulfur::scene::Instance instance_;
    std::unique_ptr<sulfur::World> world_;
    std::filesystem::path file_;

    Constants constants_;
    Constants initialConstants_;
    // What the factors apply to, kept while a factor is not 1, so that 1 gives back every bit.
    std::map<sulfur::JointId, sulfur::Real> unscaledStiffness_;
    std::map<sulfur::BodyId, sulfur::Material> unscaledMaterial_;

    std::deque<Step> undo_;
    std::deque<Step> redo_;
    std::unique_ptr<Step> open_;
    std::shared_ptr<const Checkpoint> beforePlay_;
    std::uint64_t state_ = 0;
    std::uint64_t savedState_ = 0;
    std::uint64_t lastState_ = 0;
    std::uint64_t revision_ = 0;
    bool playing_ = false;
};

}  // namespace sulfurchamber
