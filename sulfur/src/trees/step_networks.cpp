// A network goes through the tick, in one step if it can.
//
// Each step solves for the places at its end and for the multipliers together, by Newton's method
// with factors that are kept until directions have turned. Links pull along an average of their
// directions before, at the start and at the end of the step, 1/4, 1/2 and 1/4 (Newmark 1959):
// that keeps energy as SHAKE does, and light links under great tension do not whip, however long
// the step. Where it does not converge, links pull along their directions at the end, which brakes,
// and at last in shorter steps.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/touch_rows.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "trees/geometry.hpp"
#include "trees/networks.hpp"
#include "trees/node_motion.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

using Motion = StepScratch::Motion;
using Held = NetworkScratch::Link;

/// Newmark's weight of the step's end.
constexpr double averaged = 0.25;

class NetworkStepper {
public:
    NetworkStepper(State& state, Tree& tree)
        : state_(state),
          tree_(tree),
          factor_(state.trees.factors[tree.network]),
          scratch_(state.trees.scratch.network),
          nodes_(state.trees.scratch.step.nodes),
          motion_(state.trees.scratch.step.motion),
          before_(state.trees.scratch.step.before),
          links_(scratch_.links) {}

    void run() {
        load();
        while (!attempt(tree_.steps) && tree_.steps < tuned::mostNetworkSteps) tree_.steps *= 2;
        store();
        state_.statistics.chainSteps += tree_.steps;
        tree_.lastStep = tick() / tree_.steps;
        if (calm_ && tree_.steps > 1) tree_.steps /= 2;
    }

private:
    double tick() const { return static_cast<double>(state_.h); }
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }
    const NetworkLink& link(std::size_t l) const { return state_.trees.links[tree_.firstLink + l]; }

    // --- the tick's start ------------------------------------------------------------------

    void load() {
        const std::size_t count = tree_.last - tree_.first;
        nodes_.resize(count);
        motion_.resize(count);
        scratch_.inverseMass.resize(count);
        scratch_.sizes.assign(count, 1);
        for (std::size_t i = 0; i < count; ++i) {
            loadNode(state_, node(i), nodes_[i]);
            scratch_.inverseMass[i] = inverseMassOf(state_, node(i));
            if (nodes_[i].inverseMass > 0) mass_ += 1 / nodes_[i].inverseMass;
            free_ &= nodes_[i].inverseMass > 0;
        }
        pressed_ = isPressed();
        links_.resize(tree_.lastLink - tree_.firstLink);
        for (std::size_t l = 0; l < links_.size(); ++l) loadLink(l);
    }

    /// Whether contacts pushed on it in the last step. They are absent from this one, so that what
    /// they had bent would swing to the other side if it kept its energy.
    bool isPressed() const {
        const ContactCore& core = state_.core;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const TreeNode& n = node(i);
            if (n.cluster == none && n.particle == none) continue;
            const auto m = n.cluster != none ? moverOfCluster(state_, n.cluster)
                                             : moverOfParticle(state_, n.particle);
            if (m == none) continue;
            const SolverBody& body = core.movers.bodies[m];
            if (body.vx != 0 || body.vy != 0 || body.spin != 0) return true;
        }
        return false;
    }

    Point armOf(std::size_t i, const LinkEnd& end) const {
        const auto cluster = node(i).cluster;
        if (cluster == none) return {0, 0};
        return turned(state_.clusters.list[cluster].heading, end.place);
    }

    void loadLink(std::size_t l) {
        const NetworkLink& n = link(l);
        Held& data = links_[l];
        data = {};
        data.guess = n.pushed;
        data.armHere = armOf(n.here, n.atHere);
        data.armThere = armOf(n.there, n.atThere);
        if (n.kind == LinkKind::joint) {
            loadJoint(n.link, data);
        } else {
            data.rows = 2;
            data.size = std::max({data.armHere.norm(), data.armThere.norm(), 1e-3});
        }
        for (const auto i : {n.here, n.there})
            scratch_.sizes[i] = std::min(scratch_.sizes[i], data.size);
    }

    void loadJoint(std::uint32_t j, Held& data) {
        const Joints& joints = state_.joints;
        data.rest = static_cast<double>(joints.restLength[j]);
        data.elastic.rigid = joints.kind[j] == JointKind::rigid;
        data.stiffness = static_cast<double>(joints.stiffness[j]) -
                         static_cast<double>(joints.explicitStiffness[j]);
        data.damping = static_cast<double>(joints.damping[j] - joints.explicitDamping[j]);
        data.rows = 1;
        data.size = std::max(data.rest, 1e-3);
    }

    // --- one try with a number of steps -----------------------------------------------------

    bool attempt(std::uint32_t steps) {
        const double step = tick() / steps;
        for (std::size_t i = 0; i < nodes_.size(); ++i) motion_[i] = nodes_[i].start;
        for (std::size_t l = 0; l < links_.size(); ++l) prepareLink(l, step);
        calm_ = true;
        for (std::uint32_t s = 0; s < steps; ++s) {
            const double kick = s == 0 ? (tree_.lastStep + step) / 2 : step;
            before_ = motion_;
            torn_ = false;
            for (std::size_t l = 0; l < links_.size(); ++l) {
                links_[l].warm = links_[l].lambda;
                torn_ |= isTorn(l, step);
            }
            bool made = false;
            for (const auto way : {Way::keeps, Way::brakes, Way::gives}) {
                if (way == Way::keeps && (pressed_ || torn_)) continue;
                motion_ = before_;
                for (Held& data : links_) {
                    if (way == Way::gives) data.warm = {0, 0};
                    data.lambda = data.warm;
                }
                made = makeStep(kick, step, way);
                if (made) break;
                calm_ = false;
                ++state_.statistics.chainFallbacks;
            }
            if (!made && steps < tuned::mostNetworkSteps) return false;
            finishStep(step);
        }
        return true;
    }

    void prepareLink(std::size_t l, double step) {
        Held& data = links_[l];
        const double perPush = step / resistance(state_, step);
        data.elastic.hk = data.stiffness * step * perPush;
        data.elastic.hb = data.damping * perPush;
        data.impulse = {0, 0};
        for (std::size_t r = 0; r < 2; ++r) data.lambda[r] = data.guess[r] * step * perPush;
        data.warm = data.lambda;
    }

    /// How a step is made: links pull along averages, or along their directions at the end, or
    /// along these and what is rigid stretches.
    enum class Way : std::uint8_t { keeps, brakes, gives };

    bool makeStep(double kick, double step, Way way) {
        brakes_ = way != Way::keeps;
        softness_ = way == Way::gives ? tuned::givingCompliance : tuned::networkCompliance;
        scratch_.predicted.resize(nodes_.size());
        scratch_.turned.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            scratch_.turned[i] = unitVector(-step * motion_[i].spin);
        for (std::size_t l = 0; l < links_.size(); ++l) beginLink(l, step);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Motion& m = motion_[i];
            m.displacement = step * m.velocity;
            m.turning = step * m.spin;
        }
        scratch_.guess = motion_;
        predictNodes(state_, nodes_, kick, step, motion_);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Motion& m = motion_[i];
            scratch_.predicted[i] = {m.displacement[0], m.displacement[1], m.turning};
            m.displacement = scratch_.guess[i].displacement;
            m.turning = scratch_.guess[i].turning;
        }
        if (brakes_) tree_.factorStep = Tree::stale;
        const bool made = converge(step);
        if (tree_.factorStep == 0) factorise(step);  // the sweeps need it
        if (brakes_) tree_.factorStep = Tree::stale;
        return made;
    }

    /// The link at the step's start, and where it was a step earlier.
    void beginLink(std::size_t l, double step) {
        const NetworkLink& n = link(l);
        Held& data = links_[l];
        const Motion &here = motion_[n.here], &there = motion_[n.there];
        data.start.armHere = turned(here.heading, data.armHere);
        data.start.armThere = turned(there.heading, data.armThere);
        data.start.apart = (here.place - there.place) + (data.start.armHere - data.start.armThere);
        data.before.armHere = turned(scratch_.turned[n.here], data.start.armHere);
        data.before.armThere = turned(scratch_.turned[n.there], data.start.armThere);
        data.before.apart = data.start.apart - step * (here.velocity - there.velocity) +
                            (data.before.armHere - data.start.armHere) -
                            (data.before.armThere - data.start.armThere);
        data.length = data.start.apart.norm();
        const bool joint = n.kind == LinkKind::joint;
        const double error = joint ? data.length - data.rest : data.length;
        const double left = joint && !data.elastic.rigid ? 0 : errorLeft(error, step);
        data.left = {left, 0};
        if (!joint && left > 0)
            data.left = {left / data.length * data.start.apart[0],
                         left / data.length * data.start.apart[1]};
        data.mobility =
            mobilityOf(n.here, data.start.armHere) + mobilityOf(n.there, data.start.armThere);
        // What cannot hold pulls no harder than would stop all masses at once at that speed, times
        // by how much it is too long, so that in the end all are stretched alike.
        const double asked = std::abs(error) - std::hypot(data.left[0], data.left[1]);
        const double share = joint ? data.rest / std::max(data.length, data.rest) : 1;
        data.least =
            std::max(softness_ * data.mobility, share * asked / (mass_ * closingSpeed * step));
        data.turnHere = scratch_.inverseMass[n.here][2];
        data.turnThere = scratch_.inverseMass[n.there][2];
        if (data.mobility == 0) data.rows = 0;
    }

    /// Whether a link is wrong by more than a step closes.
    bool isTorn(std::size_t l, double step) const {
        const NetworkLink& n = link(l);
        const Motion &here = motion_[n.here], &there = motion_[n.there];
        const Point apart = (here.place - there.place) + turned(here.heading, links_[l].armHere) -
                            turned(there.heading, links_[l].armThere);
        const Held& data = links_[l];
        if (n.kind == LinkKind::joint && !data.elastic.rigid) return false;
        return errorLeft(apart.norm() - data.rest, step) != 0;
    }

    /// 1/kg, in the direction in which a node moves most easily at that arm.
    double mobilityOf(std::size_t i, const Point& arm) const {
        const Freedoms& w = scratch_.inverseMass[i];
        return w[0] + w[2] * arm.squaredNorm();
    }

    bool converge(double step) {
        double last = 0, best = std::numeric_limits<double>::infinity();
        bool fresh = false;
        int stalls = 0;
        for (int pass = 0;; ++pass) {
            const double worst = evaluate();
            if (!brakes_ && fresh && worst > best / 2) ++stalls;
            if (worst < best) {
                best = worst;
                for (Held& data : links_) data.best = data.lambda;
                scratch_.best = motion_;
            }
            if (worst <= tuned::networkTolerance) {
                calm_ &= pass <= tuned::calmPasses;
                settle();
                return true;
            }
            if (pass == tuned::networkPasses || stalls == 2 || !(worst < 1e2 * best)) break;
            const bool slow = pass > 0 && worst > tuned::networkProgress * last && !fresh;
            fresh = slow || (pass == 0 && (tree_.factorStep != step || hasTurned()));
            if (fresh) factorise(step);
            correct();
            last = worst;
        }
        calm_ = false;
        // Without a solution everything flies freely, which throws nobody.
        const bool useful = best <= tuned::uselessError;
        for (Held& data : links_) data.lambda = useful ? data.best : std::array<double, 2>{0, 0};
        if (useful) motion_ = scratch_.best;
        evaluate();
        settle();
        return best <= (brakes_ ? tuned::brakingTolerable : tuned::networkTolerable);
    }

    /// Residuals at the present displacements; the largest error, relative to the links' lengths.
    double evaluate() {
        double worst = 0;
        auto& residual = scratch_.nodes;
        residual.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Motion& m = motion_[i];
            const Freedoms change =
                Freedoms(m.displacement[0], m.displacement[1], m.turning) - scratch_.predicted[i];
            const Freedoms& w = scratch_.inverseMass[i];
            for (int k = 0; k < 3; ++k) residual[i][k] = w[k] > 0 ? change[k] / w[k] : 0;
            scratch_.turned[i] = unitVector(m.turning);
        }
        for (std::size_t l = 0; l < links_.size(); ++l) {
            updateLink(l);
            const Held& data = links_[l];
            for (int r = 0; r < data.rows; ++r) {
                const auto k = static_cast<std::size_t>(r);
                residual[link(l).here] -= data.lambda[k] * data.here[k];
                residual[link(l).there] -= data.lambda[k] * data.there[k];
                worst = std::max(worst, std::abs(data.value[k]) / data.size);
            }
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Freedoms off = scratch_.inverseMass[i].cwiseProduct(residual[i]);
            worst = std::max({worst, off.head<2>().norm() / scratch_.sizes[i], std::abs(off[2])});
            if (!off.allFinite()) return std::numeric_limits<double>::infinity();
        }
        return worst;
    }

    /// The share of the average by which a pull takes part in what the step does. What pushes
    /// explodes sideways by itself; it goes only so far that the matrix stays positive.
    double shareOf(double pushed, double mobility) const {
        const double share = brakes_ ? 1 : averaged;
        return pushed > 0 ? std::min(share, averaged / (pushed * mobility)) : share;
    }
    Point average(const Point& before, const Point& start, const Point& now, double share) const {
        return brakes_ ? Point(start + share * (now - start))
                       : Point(start + share * ((now - start) + (before - start)));
    }

    void updateLink(std::size_t l) {
        const NetworkLink& n = link(l);
        Held& data = links_[l];
        if (data.rows == 0) return;
        const Motion &here = motion_[n.here], &there = motion_[n.there];
        Span& now = data.now;
        now.armHere = turned(scratch_.turned[n.here], data.start.armHere);
        now.armThere = turned(scratch_.turned[n.there], data.start.armThere);
        now.apart = data.start.apart + (here.displacement - there.displacement) +
                    (now.armHere - data.start.armHere) - (now.armThere - data.start.armThere);
        if (n.kind == LinkKind::joint)
            updateJoint(n, data);
        else
            updateMeeting(n, data);
    }

    /// How a distance along `direction` changes with the freedoms that a node has.
    Freedoms along(std::size_t i, const Point& direction, const Point& arm) const {
        return ofMovable({direction[0], direction[1], cross(arm, direction)},
                         scratch_.inverseMass[i]);
    }

    void updateJoint(const NetworkLink& n, Held& data) {
        const double length = data.now.apart.norm();
        const double lambda = data.lambda[0];
        data.share = shareOf(data.warm[0] / std::max(data.length, 1e-12), data.mobility);
        const Point mean = average(data.before.apart, data.start.apart, data.now.apart, data.share);
        const double size = mean.norm();
        data.direction = size > 1e-12 ? Point(mean / size) : Point(1, 0);
        setArms(data, data.warm[0] * data.direction);
        data.here[0] = along(n.here, data.direction, data.meanHere);
        data.there[0] = -along(n.there, data.direction, data.meanThere);
        const double error = length - data.rest - data.left[0];
        data.compliance = std::max(complianceOf(data.elastic), data.least);
        data.value[0] = data.elastic.rigid || data.compliance == data.least
                            ? error + data.compliance * lambda
                            : valueOf(data.elastic, error, length - data.length, lambda);
    }

    void updateMeeting(const NetworkLink& n, Held& data) {
        setArms(data, Point(data.warm[0], data.warm[1]));
        data.compliance = data.least;
        for (std::size_t r = 0; r < 2; ++r) {
            const Point unit = r == 0 ? Point(1, 0) : Point(0, 1);
            data.here[r] = along(n.here, unit, data.meanHere);
            data.there[r] = -along(n.there, unit, data.meanThere);
            data.value[r] = data.now.apart[static_cast<Eigen::Index>(r)] - data.left[r] +
                            data.compliance * data.lambda[r];
        }
    }

    /// The arms at which a push of `push` acts on the node here, and against it on the other.
    void setArms(Held& data, const Point& push) {
        data.shareHere = shareOf(-push.dot(data.start.armHere), data.turnHere);
        data.shareThere = shareOf(push.dot(data.start.armThere), data.turnThere);
        data.meanHere =
            average(data.before.armHere, data.start.armHere, data.now.armHere, data.shareHere);
        data.meanThere =
            average(data.before.armThere, data.start.armThere, data.now.armThere, data.shareThere);
    }

    bool hasTurned() const {
        for (std::size_t l = 0; l < links_.size(); ++l) {
            const Held& data = links_[l];
            const NetworkRow& row = state_.trees.rows[tree_.firstLink + l];
            for (int r = 0; r < data.rows; ++r) {
                const auto k = static_cast<std::size_t>(r);
                const Freedoms here = data.here[k] - row.here[k];
                const Freedoms there = data.there[k] - row.there[k];
                const double turn = std::max(here.head<2>().norm(), there.head<2>().norm());
                const double lever = std::max(std::abs(here[2]), std::abs(there[2])) / data.size;
                if (!(std::max(turn, lever) <= tuned::factorTurn)) return true;
            }
        }
        return false;
    }

    /// Makes the matrix of the links as they are.
    void factorise(double step) {
        for (std::size_t l = 0; l < links_.size(); ++l)
            state_.trees.rows[tree_.firstLink + l] = rowOf(link(l), links_[l]);
        factoriseNetwork(state_, tree_, stepRows(state_, tree_), factor_.step);
        tree_.factorStep = step;
        ++state_.statistics.networkFactors;
    }

    /// What pushes resists being turned by less than nothing, but not so much that the matrix would
    /// no longer be positive.
    NetworkRow rowOf(const NetworkLink& n, const Held& data) const {
        NetworkRow row;
        if (data.rows == 0) return row;
        row.here = data.here;
        row.there = data.there;
        row.stiffness = {1 / data.compliance, data.rows == 2 ? 1 / data.compliance : 0};
        Point push(data.lambda[0], data.lambda[1]);
        if (data.rows == 1) {
            push = data.lambda[0] * data.direction;
            const Point across = perpendicular(data.direction);
            row.acrossHere = along(n.here, across, data.meanHere);
            row.acrossThere = -along(n.there, across, data.meanThere);
            row.tension = std::max(-data.share * data.lambda[0] / std::max(data.length, 1e-12),
                                   -averaged / data.mobility);
        }
        if (data.turnHere > 0)
            row.turnHere =
                std::max(data.shareHere * push.dot(data.meanHere), -averaged / data.turnHere);
        if (data.turnThere > 0)
            row.turnThere =
                std::max(-data.shareThere * push.dot(data.meanThere), -averaged / data.turnThere);
        return row;
    }

    void correct() {
        auto& values = scratch_.values;
        values.resize(links_.size());
        for (std::size_t l = 0; l < links_.size(); ++l) values[l] = links_[l].value;
        correctNetwork(state_, tree_, stepRows(state_, tree_), stepSystem(state_, tree_),
                       scratch_.nodes, values);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            motion_[i].displacement += scratch_.nodes[i].head<2>();
            motion_[i].turning += scratch_.nodes[i][2];
        }
        for (std::size_t l = 0; l < links_.size(); ++l)
            for (int r = 0; r < links_[l].rows; ++r)
                links_[l].lambda[static_cast<std::size_t>(r)] +=
                    values[l][static_cast<std::size_t>(r)];
    }

    /// Displacements are what the multipliers give, so that no momentum is lost to the tolerance.
    void settle() {
        auto& given = scratch_.nodes;
        given = scratch_.predicted;
        for (std::size_t l = 0; l < links_.size(); ++l) {
            const NetworkLink& n = link(l);
            for (int r = 0; r < links_[l].rows; ++r) {
                const auto k = static_cast<std::size_t>(r);
                const double lambda = links_[l].lambda[k];
                given[n.here] +=
                    lambda * scratch_.inverseMass[n.here].cwiseProduct(links_[l].here[k]);
                given[n.there] +=
                    lambda * scratch_.inverseMass[n.there].cwiseProduct(links_[l].there[k]);
            }
        }
        if (free_) turnBack(given);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            motion_[i].displacement = given[i].head<2>();
            motion_[i].turning = given[i][2];
        }
    }

    /// Averaged directions are not quite those between the ends when the step begins, so that pulls
    /// leave a small couple. Of a network that nothing holds it is given back by turning the whole,
    /// which changes no length.
    void turnBack(std::vector<Freedoms>& given) const {
        double couple = 0, inertia = 0;
        for (std::size_t l = 0; l < links_.size(); ++l) {
            const Held& data = links_[l];
            const Point apart = motion_[link(l).here].place - motion_[link(l).there].place +
                                data.meanHere - data.meanThere;
            for (int r = 0; r < data.rows; ++r) {
                const auto k = static_cast<std::size_t>(r);
                couple += data.lambda[k] * cross(apart, data.here[k].head<2>());
            }
        }
        Point centre(0, 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            centre += motion_[i].place / (nodes_[i].inverseMass * mass_);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            inertia += (motion_[i].place - centre).squaredNorm() / nodes_[i].inverseMass;
            if (nodes_[i].inverseInertia > 0) inertia += 1 / nodes_[i].inverseInertia;
        }
        if (!(inertia > 0)) return;
        const double turn = -couple / inertia;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            given[i].head<2>() += turn * perpendicular(Point(motion_[i].place - centre));
            if (nodes_[i].inverseInertia > 0) given[i][2] += turn;
        }
    }

    void finishStep(double step) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) moveNode(nodes_[i], step, motion_[i]);
        const double newtons = resistance(state_, step) / step;
        for (Held& data : links_)
            for (std::size_t r = 0; r < 2; ++r) data.impulse[r] += newtons * data.lambda[r];
    }

    // --- the tick's end ---------------------------------------------------------------------

    void store() {
        if (!allFinite(motion_)) stop();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            state_.trees.predicted[tree_.first + i] =
                storeNode(state_, node(i), nodes_[i], motion_[i]);
        }
        const double perNewton = tick() / resistance(state_, tick());
        for (std::size_t l = 0; l < links_.size(); ++l) {
            NetworkLink& n = state_.trees.links[tree_.firstLink + l];
            const auto& impulse = links_[l].impulse;
            n.pushed = {impulse[0] / tick(), impulse[1] / tick()};
            if (n.kind == LinkKind::joint) {
                state_.joints.lambda[n.link] = static_cast<Real>(impulse[0] * perNewton);
                continue;
            }
            const Vec2 force = (Point(impulse[0], impulse[1]) / tick()).cast<Real>();
            if (n.kind == LinkKind::hinge)
                state_.clusters.hinges[n.link].force = force;
            else
                state_.attachments[n.link].force = force;
        }
    }

    /// No number is left to go on with: everything stays where it was.
    void stop() {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            motion_[i] = nodes_[i].start;
            motion_[i].velocity = Point(0, 0);
            motion_[i].spin = 0;
        }
        for (Held& data : links_) data.impulse = {0, 0};
        tree_.factorStep = Tree::stale;
    }

    State& state_;
    Tree& tree_;
    NetworkFactor& factor_;
    NetworkScratch& scratch_;
    std::vector<StepScratch::Node>& nodes_;
    std::vector<Motion>&motion_, &before_;
    std::vector<Held>& links_;
    double mass_ = 0;       // kg, of all nodes
    double softness_ = 0;   // of what is rigid, in what its ends answer a push with
    bool pressed_ = false;  // isPressed()
    bool free_ = true;      // no node is held fast
    bool torn_ = false;     // isTorn() of any link
    bool brakes_ = false;   // whether links pull along their directions at the end
    bool calm_ = true;      // whether all steps converged at once
};

}  // namespace

void stepNetwork(State& state, Tree& tree) {
    NetworkStepper(state, tree).run();
}

}  // namespace sulfur::detail
