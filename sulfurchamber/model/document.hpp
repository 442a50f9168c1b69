// What is open in SulfurChamber: the plan of a scene, the world that moves, and the history of the
// edits. Knows nothing of windows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <sulfur/scene.hpp>
#include <sulfur/sulfur.hpp>
#include <unordered_map>
#include <vector>

#include "constants.hpp"
#include "fitting.hpp"
#include "geometry.hpp"
#include "plan.hpp"
#include "shelf.hpp"
#include "timeline.hpp"

namespace sulfurchamber {

/// One scene: its plan, which is edited and saved, and its world, which is stamped from the plan
/// and moves.
///
/// Every change is a step with a name. It goes through edit(), or begin() and commit(), and the
/// functions below "changing", which change the plan and the world in the same moment. Before
/// time passes the world is exactly what the plan says. Later it is a moment of its own: then edits
/// change both, and what they add or move stands in the plan where it stands in the moment. Pieces
/// that broke off, and what rains, are of the moment alone: the plan knows nothing of them.
///
/// Undo and redo go without limit: steps lie on the disk. They restore the plan to the byte, and
/// the world to the bit, also behind time that has passed since. Ticks by themselves are no edits:
/// a scene that was only played has no unsaved changes.
///
/// One thread. Functions that cannot do what they promise throw std::exception with one sentence
/// and leave the document as it was.
class Document {
public:
    /// A new scene: an empty floor. The history lies in a nameless file in `historyFolder`, or
    /// where temporary files are.
    explicit Document(std::filesystem::path historyFolder = {});
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
    /// Takes what was kept of a file that was not saved (empty: of none): it is unsaved still.
    /// Throws as open() does.
    void recover(const std::filesystem::path& kept, const std::filesystem::path& of);
    /// The text of the file: the plan, with the factors of the constants in its numbers. What was
    /// not changed of a level keeps the bytes that its file has.
    std::string text() const;
    /// The plan as it is saved, or the state of this moment.
    sulfur::scene::Scene planScene() const;
    sulfur::scene::Scene momentScene() const { return captureMoment().scene; }
    /// Of this moment, without the factors: what a clipboard takes. Bodies of the world in the
    /// order of the scene's.
    struct Captured {
        sulfur::scene::Scene scene;
        std::vector<sulfur::BodyId> bodies;
    };
    Captured captureForClipboard() const;
    /// Writes the plan, in one piece or not at all. Throws sulfur::scene::WriteError or ReadError.
    void save(const std::filesystem::path& file);
    /// Writes the state of this moment as a scene of its own; what is open stays what it is.
    void saveMoment(const std::filesystem::path& file) const;
    /// Empty until the scene was opened from a file or saved.
    const std::filesystem::path& file() const { return file_; }
    /// The file's name, or "Untitled".
    std::string name() const;
    /// Whether there are edits that are not saved.
    bool modified() const { return state_ != savedState_; }
    /// Another number after each edit, the same again after its undo.
    std::uint64_t state() const { return state_; }

    // -- looking --

    const sulfur::scene::Scene& scene() const { return plan_.scene(); }
    const Plan& plan() const { return plan_; }
    /// The member "level" of the plan as it is written; empty where the scene is no level.
    const std::string& levelText() const;
    /// For forces, which are no edits.
    sulfur::World& world() { return *world_; }
    const sulfur::World& world() const { return *world_; }
    /// The id in the plan; "" for pieces and for what rained.
    std::string idOf(sulfur::BodyId body) const;
    /// The id in the plan of what a body was made as, also of a piece of it; "" for what rained.
    std::string originOf(sulfur::BodyId body) const;
    /// The body of an id, null when it has broken or the plan has none.
    sulfur::BodyId bodyOf(std::string_view id) const;
    /// What is fitted in the plan: mechanisms, then zones, then thrusters.
    std::vector<FittingRef> fittings() const;
    /// Also a single particle or joint. Precondition: the plan has it.
    Fitting fitting(const FittingRef& ref) const;
    const std::vector<Thruster>& thrusters() const;
    /// A single particle or joint as a part of the plan; nothing where the plan has none such.
    std::optional<FittingRef> partOf(sulfur::ParticleId particle) const;
    std::optional<FittingRef> partOf(sulfur::JointId joint) const;
    bool hasPart(const FittingRef& ref) const;
    /// What tells a part from another one that comes to have its place. Precondition: hasPart().
    std::string markOf(const FittingRef& ref) const;
    /// Where a particle is now, or both ends of a joint, metres; nothing where it has broken.
    std::vector<sulfur::Point> placesOf(const FittingRef& ref) const;
    /// What the mechanisms of the plan are in this moment; null where they are not there.
    const std::vector<sulfur::scene::MadeMechanism>& made() const;
    /// What a zone of the plan is in this moment; null when it is not there.
    sulfur::FieldId fieldOf(std::size_t zone) const;
    /// Whether a body of the plan is but a point, or a line, that something is fitted to.
    bool isPeg(const std::string& id) const;
    /// With the pegs whose mechanisms tie them to these bodies alone.
    std::vector<sulfur::BodyId> withPegs(std::span<const sulfur::BodyId> bodies) const;
    /// Grows with everything that may change what a view has derived from the world, except
    /// for ticks: edits, undo, other files.
    std::uint64_t revision() const { return revision_; }
    /// Called when bodies have got new handles: with what gives the new handle for an old one, null
    /// when it is gone.
    std::function<void(const std::function<sulfur::BodyId(sulfur::BodyId)>&)> onNewHandles;

    // -- time --

    bool playing() const { return playing_; }
    void play();
    void pause() { playing_ = false; }
    /// From now on the world is a moment of its own. play() and tick() do it too.
    void startTime();
    /// Advances by one tick, playing or not.
    void tick();
    /// These act in the next tick, for which they are recorded: they are no edits.
    void push(const Push& push);
    void letFall(const sulfur::scene::Prefab& prefab, const sulfur::Pose& pose);
    void thrust(const Thrust& thrust);
    /// From the next tick on.
    void drive(sulfur::MechanismId mechanism, const sulfur::Drive& drive);
    /// Whether time has passed since the plan.
    bool canReset() const { return moved_; }
    /// Stamps the world from the plan again. Stops playing. Can itself be undone.
    void reset();

    // -- rewinding --

    /// The recorded past. Each tick is recorded, and each edit of a moment.
    const Timeline& timeline() const { return timeline_; }
    /// The present moment where the world is just what is recorded of it; none behind an edit that
    /// no tick has followed yet.
    std::optional<Moment> recordedMoment() const;
    /// Stops playing and brings the world to a recorded moment, as Timeline::go() does. The plan
    /// and the history stay: what a later edit has added is in the plan, but not in this moment.
    /// Going on from there, by time or by edits, starts a branch. Returns whether the moment is
    /// reached. Precondition: something is recorded.
    bool goTo(const Moment& moment, double milliseconds = 1e9);

    /// Brings another world to a recorded moment, as Timeline::replay() does.
    bool replay(sulfur::World& other, const Moment& moment, double milliseconds) {
        return timeline_.replay(other, moment, milliseconds);
    }
    /// Runs `look` while another world stands in the place of this one's: a moment that was
    /// replayed. Neither world and nothing of the document may be changed by it.
    void lookAt(std::unique_ptr<sulfur::World>& other, const std::function<void()>& look);

    // -- history --

    /// Runs `change` as one step of the history. When it throws, all is as before and the exception
    /// goes on. A step that has changed nothing is none.
    void edit(const std::string& label, const std::function<void()>& change);
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
    /// The labels of all steps, the oldest first, those that could be redone last.
    std::vector<std::string> history() const;
    /// How many of them are done.
    std::size_t historyPlace() const;

    // -- constants --

    const Constants& constants() const { return constants_; }
    /// What the scene began with.
    const Constants& initialConstants() const { return initialConstants_; }
    /// Sets one or several constants, clamped to their limits, as a part of the open edit, or as
    /// an edit of its own.
    void setConstants(const Constants& constants);

    // -- changing, inside of an edit --

    /// Adds a body. `name` becomes its id, with a number where it is taken.
    sulfur::BodyId add(const std::string& name, const sulfur::scene::Generator& recipe,
                       const sulfur::Pose& pose);
    /// Throws std::runtime_error when the scene would have more than files may hold.
    sulfur::BodyId add(const sulfur::scene::Prefab& prefab,
                       const sulfur::scene::Placement& placement);
    /// Adds a body to this moment alone.
    sulfur::BodyId addPassing(const sulfur::scene::Prefab& prefab, const sulfur::Pose& pose);
    /// Adds all bodies of a scene with what ties them to each other, moved by `by` metres.
    std::vector<sulfur::BodyId> insert(const sulfur::scene::Scene& scene, const sulfur::Point& by);
    void remove(std::span<const sulfur::BodyId> bodies);
    /// Moves bodies without turning them, metres.
    void translate(std::span<const sulfur::BodyId> bodies, const sulfur::Point& by);
    /// Puts the frame of a body's blueprint at a pose.
    void place(sulfur::BodyId body, const sulfur::Pose& pose);
    /// The same, and its pegs go along.
    void placeWithPegs(sulfur::BodyId body, const sulfur::Pose& pose);
    /// Puts bodies at rest where the plan has them, and what it does not have in a row above all
    /// else. Of this moment alone.
    void bringBack(std::span<const sulfur::BodyId> bodies);
    /// Changes the blueprints of bodies; `change` sees each one once, without the factors of the
    /// constants. Handles of these bodies may be others afterwards.
    void change(std::span<const sulfur::BodyId> bodies,
                const std::function<void(sulfur::scene::Prefab&)>& change);
    /// Gives a body of the plan another id. Throws as Plan::rename does.
    void rename(sulfur::BodyId body, const std::string& to);
    /// A joint between bodies.
    sulfur::JointId connect(sulfur::ParticleId a, sulfur::ParticleId b,
                            sulfur::ConnectOptions options = {});
    /// Holds a particle where it is on another body: an axle.
    void attach(sulfur::ParticleId particle, sulfur::BodyId body);
    /// Two bodies that pass through each other from now on.
    void letPass(sulfur::BodyId a, sulfur::BodyId b);
    /// A joint between two particles of the plan. Within a body it becomes a part of its blueprint.
    /// A body of one particle becomes a part of the other body; else it is a joint between bodies.
    void join(sulfur::ParticleId a, sulfur::ParticleId b, const sulfur::JointSpec& joint);
    void setPinned(sulfur::ParticleId particle, bool pinned);
    void remove(sulfur::JointId joint);
    /// Adds a mechanism, a zone or a thruster. A mechanism without an id gets one. Points are those
    /// of this moment.
    FittingRef fit(const Fitting& fitting);
    /// Changes one. In a moment a mechanism is made anew where its bodies are, unless `live`: then
    /// nothing changes but what drives it, and its keys.
    void refit(const FittingRef& ref, const std::function<void(Fitting&)>& change, bool live);
    /// Takes one away, with gears that need it and pegs that only it had, with a particle all that
    /// holds on to it.
    void unfit(const FittingRef& ref);
    /// Changes the plan as a whole. The world becomes what the plan says then: a moment is left, to
    /// which undo leads back.
    void rebuild(const std::function<void(Plan&)>& change);
    /// For members of the plan that are not of bodies and blueprints: texts, the level, fields.
    sulfur::scene::Scene& planForEditing() { return plan_.scene(); }
    sulfur::scene::Placement& placementForEditing(std::string_view id) { return plan_.body(id); }
    /// Sets the member "level" of the plan; the empty text takes it away. Throws
    /// sulfur::scene::ReadError unless it is one JSON value.
    void setLevelText(std::string json);

private:
    struct Side;
    struct Step;

    Captured captureMoment() const;
    void noteFile(const std::filesystem::path& file);
    void stamp();
    Side side();
    void restore(const Side& side);
    void go(std::vector<Step>& from, std::vector<Step>& to, bool back);
    void requireRoom(std::size_t particles, std::size_t joints) const;
    std::uint64_t keyOf(const std::string& id);
    std::optional<sulfur::scene::ParticleRef> refOf(sulfur::ParticleId particle) const;
    void bringPlanHere(std::span<const sulfur::BodyId> bodies);
    void insertMechanisms(const sulfur::scene::Scene& scene, const sulfur::Point& by,
                          const std::map<std::string, sulfur::BodyId, std::less<>>& made);
    std::string freeMechanismId(std::string_view base) const;
    void makeInMoment(const sulfur::scene::SceneMechanism& mechanism);
    void remakeInMoment(std::size_t mechanism);
    void matchMechanisms() const;
    void renewRails(const std::string& body, std::size_t jointsBefore);
    void followRails(const std::string& body,
                     const std::vector<sulfur::scene::MadeMechanism>& there);
    std::vector<sulfur::BodyId> bodiesOfMechanism(std::size_t mechanism) const;
    void setZone(std::size_t zone, const std::optional<sulfur::Field>& field);
    Fitting part(const FittingRef& ref) const;
    sulfur::JointId jointOf(const FittingRef& part) const;
    const sulfur::Blueprint& sharedBlueprint(const std::string& id) const;
    void setPart(const FittingRef& ref, const Fitting& to);
    void removePart(const FittingRef& ref);
    void requirePlan() const;
    void merge(const std::string& into, const std::string& single, std::uint32_t other,
               const sulfur::JointSpec& joint);
    void takeOver(const std::function<void()>& change);
    void setFactors(const Constants& wanted);
    void changePiece(sulfur::BodyId body,
                     const std::function<void(sulfur::scene::Prefab&)>& change);
    std::vector<std::string> idsOf(std::span<const sulfur::BodyId> bodies) const;
    void touched();
    void followTime(const std::function<void()>& go);
    void beforeActing();
    std::size_t placeOfPassing(const sulfur::scene::Prefab& prefab);

    Plan plan_;
    std::string text_;  ///< of the plan, without the factors, as it was at the last commit
    std::unique_ptr<sulfur::World> world_;
    std::filesystem::path file_;
    std::string fileText_;    ///< of a level: its bytes when it was opened or saved
    std::string fileFormat_;  ///< the same in the layout of sulfur::scene

    // Bodies of the world bear the key of their plan's id as user data: it comes along with
    // snapshots. What rains bears the place of its blueprint in `passing_`.
    std::unordered_map<std::string, std::uint64_t> keys_;
    std::vector<std::string> ids_;  ///< by key - 1
    std::vector<sulfur::scene::Prefab> passing_;
    // What fell last, as it is with the constants: those that follow share it.
    struct Falling {
        std::size_t place = 0;
        Constants constants;
        std::shared_ptr<const sulfur::Blueprint> blueprint;
    };
    Falling falling_;

    // What is found out about fittings, until the plan or the mechanisms of the world change.
    struct Fitted {
        std::optional<std::uint64_t> revision;
        std::vector<Thruster> thrusters;
        std::optional<std::uint64_t> matched;  ///< revision
        std::vector<sulfur::MechanismId> there;
        std::vector<sulfur::scene::MadeMechanism> made;
    };
    mutable Fitted fitted_;

    Constants constants_;
    Constants initialConstants_;

    Shelf shelf_;
    std::vector<Step> undo_;
    std::vector<Step> redo_;
    std::unique_ptr<Step> open_;
    std::uint64_t state_ = 0;
    std::uint64_t savedState_ = 0;
    std::uint64_t lastState_ = 0;
    std::uint64_t revision_ = 0;
    bool moved_ = false;  ///< whether the world is a moment of its own
    Timeline timeline_;
    bool touched_ = false;        ///< by an edit that is not recorded yet
    bool touchedInStep_ = false;  ///< by the open edit
    bool playing_ = false;
};

/// Where things may be: all that the plan has, with as much around it again, at least 50 m.
Bounds worldBounds(const Document& document);

}  // namespace sulfurchamber
