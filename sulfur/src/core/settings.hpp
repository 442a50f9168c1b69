// What was chosen, not derived: every tuned value of the physics, with its unit and its reason.
//
// What is written as a multiple or a part of another value follows it. Limits of the public
// interface are in limits.hpp; constants of mathematics, of rounding and of the machine stand where
// they are used. Kernels include this header, so that it may have no function (joint_sweep.hpp).
#pragma once

#include <cstdint>

namespace sulfur::detail::tuned {

// Time and what is torn apart.

/// Hz, the least rate of steps. All values here are tuned for 500 steps a second; this is the
/// nearest multiple of 60, 120 and 240 Hz.
inline constexpr int leastStepRate = 480;
/// m/s, at which comes together what the caller has torn apart (a length changed at once), not in
/// one tick; and what is attached over a gap, which is an everyday thing and must throw nobody: a
/// kilogram gets an eighth of a joule.
inline constexpr double closingSpeed = 5, attachingSpeed = closingSpeed / 10;

/// Mass of the pin of a hinge, as a share of the lighter body: so little that nobody sees it, and
/// far from what the arithmetic loses.
inline constexpr double pinShare = 1e-3;

/// Passes over mechanisms that push each other, in a sweep; how many of them begin with solving at
/// once what is held; and the share of the largest multiplier whose change asks for another one.
inline constexpr int mostRowPasses = 32, mostHolds = 16;
inline constexpr double settledRow = 1e-6;

// What is slow, under a gravity of leastGravity to mostGravity, m/s^2. Beyond, these speeds are in
// proportion to it (model/slow_speeds.hpp): else what is thrown under a small gravity would fall
// asleep where it turns around, and where lengths are in millimetres hardly anything would be slow.
inline constexpr double leastGravity = 1, mostGravity = 100;

/// m/s: what moves slower for long enough falls asleep.
inline constexpr double restingSpeed = 0.005;
/// As a share of that, where neither gravity nor air holds what moves: it drifts on for ever, and
/// sleep would take its momentum.
inline constexpr double driftingShare = 0.01;
/// m/s: what slips slower is held by static friction, so that noise of a tick does not let go of
/// what rests.
inline constexpr double creepSpeed = restingSpeed / 5;
/// m/s: what is pushed apart faster does not rest.
inline constexpr double restingPush = 2 * creepSpeed;
/// m/s: a sweep that changes how fast surfaces part by no more leaves their bodies alone.
inline constexpr double settledChange = restingSpeed / 10;
/// m/s, by which what rows begin with may change anybody's motion: a tenth of a second's fall.
/// What stays in its place is changed by a fiftieth of that at 500 Hz.
inline constexpr double wildChange = 1;
/// m/s: what slides faster does not stick.
inline constexpr double stickingSpeed = 2 * restingSpeed;
/// m/s: slower impacts do not rebound, so that what lies comes to rest.
inline constexpr double slowestRebound = 0.1;
/// m/s: a driver that closes in more slowly has not pressed in vain, because the sweeps have not
/// ended it yet.
inline constexpr double vainSpeed = slowestRebound;
/// s at rest, after which an island falls asleep.
inline constexpr double timeToSleep = 0.5;
/// 1/s, of deviations in what sticks together. Waves in a pyramid of base 100 take about a second.
inline constexpr double decayRate = 5;

// How what is wrong in places is mended, without a velocity.

/// Share of an overlap, of a missing area or of a way out that goes in a step: faster, neighbours
/// that are mended at once would overshoot.
inline constexpr double recoveryShare = 0.2;
/// 1/s: the same by time, in steps of 1/500 s.
inline constexpr double recoveryRate = 500 * recoveryShare;
/// m/s, the fastest that this pushes anybody.
inline constexpr double recoverySpeed = 0.5;
/// m/s, of a body that is led apart: slower than rows push, so that it is led through no floor.
inline constexpr double leadingSpeed = 0.98 * recoverySpeed;
/// m/s, of a particle that all its triangles lead back.
inline constexpr double mostRecoverySpeed = 0.9;
/// Share of the thickness from which on rows push apart what is led apart.
inline constexpr double tolerated = 0.9;
/// Share of the thickness below which rows would push what was put into each other out on whatever
/// side each corner happens to be: it is led apart first.
inline constexpr double entangled = 0.5;

// Distances, in the thickness of what touches.

/// Overlap that stays. Without it, what lies is pushed out and falls back, by micrometres that are
/// millimetres a second in a step, and rows never come to rest.
inline constexpr double slop = 1e-4;
/// By which two bodies may go on in a step after their pair should have been looked at: the place
/// at which they touch changes by less than a hundredth of the thickness.
inline constexpr double unnoticed = 0.25;
/// What comes nearer in a step is held back before it would pass. It may overlap by as much, which
/// is less than what goes unnoticed.
inline constexpr double fast = unnoticed / 2;
/// By which a sleeper may be nearer, when it wakes, than it was predicted to be: forces do not move
/// anybody so far in a step.
inline constexpr double unforeseen = unnoticed / 4;
/// How far a body may go before its rows are refreshed: an edge that rolls on a corner is then
/// wrong by the square of that, a two-hundredth of the thickness.
inline constexpr double refreshWithin = 0.01;
/// By which another row may come too late where a corner has one already: that much a seam is felt.
inline constexpr double seam = 0.1;
/// Parts of one body that are this near in the blueprint belong together and never touch.
inline constexpr double togetherWithin = 1.2;
/// In the length of a side, how far beyond its end the foot of a perpendicular may be, so that
/// nothing slips through where two sides meet.
inline constexpr double beyondEnds = 1e-5;
/// By which what is nearly at a limit counts as there, so that what lies does not seem to come and
/// go. Round things, which may be as thick as they are large, have a direction to lose.
inline constexpr double reached = 1.0 / 64, reachedRound = reached / 16;
/// m and rad, from its reference, beyond which a body gets a new one: single precision is then
/// finer than anything above.
inline constexpr double farthestFromReference = 0.5, largestTurn = farthestFromReference / 5;

// How often, and how many times.

/// What comes nearer by about a third each time is a tenth of what it was after so many times.
inline constexpr int rounds = 8;
/// Steps between dampings of what sticks, and between searches for islands that may fall asleep:
/// piles change slowly.
inline constexpr std::uint64_t pileInterval = rounds;
/// Steps between looks at what changes slowly.
inline constexpr std::uint64_t seldom = 8 * pileInterval;
/// Up to so many times the sweeps of the settings, beside joints, while one of them still stirs
/// anybody.
inline constexpr int mostTimes = 2;
/// Sweeps over trees that a contact strains, while so many of them mend at least a share of that:
/// what is squeezed may have no solution.
inline constexpr int trial = rounds, mostForStrain = 6 * trial;
inline constexpr double mended = 1.0 / 4;
/// Rounds of impacts, which pass a blow on along a row of bodies, and sweeps over the points of one
/// blow that does not rebound.
inline constexpr int impactRounds = 8 * rounds, plasticSweeps = impactRounds / 2;
/// Rounds of the search for the moment at which two outlines touch.
inline constexpr int momentRounds = 2 * rounds;
/// Pairs that a chunk has with larger ones, so that what is put into one place has a price in
/// memory and time. Where nothing overlaps, boxes meet far fewer.
inline constexpr std::uint32_t mostPairs = rounds * rounds;
/// Chunks of one size, not smaller than itself, that a chunk looks at to find these.
inline constexpr std::uint32_t mostMet = 4 * mostPairs;
/// Rounds in which what is fast is held back from one another.
inline constexpr int keepingRounds = rounds;

// What a step may cost, so that no scene stops the game. Each is a number for every mover that is
// awake (a particle or rigid component that contacts push), and nothing below it is cut short.

/// Movers that even the smallest world counts as: what is few may take longer.
inline constexpr std::uint32_t fewMovers = rounds * rounds;
/// Pairs for each chunk, and rows for each mover. Where all have more, they are a crowd: a chunk
/// then has as many with what moves, and a look makes the nearest row alone. Piles have about six
/// pairs and three rows.
inline constexpr std::uint32_t crowdedPairs = 2 * rounds, crowdedRows = 2 * rounds;
/// Rows that are swept, in all sweeps of a tick, and in a step of several. A pile of three rows for
/// each mover takes 60.
inline constexpr std::uint32_t sweptRows = 256, sweptRowsOfStep = 96;
/// The same of the sweeps that follow while links stay strained; a link counts as `rowsOfLink`.
inline constexpr std::uint32_t strainedRows = 320, rowsOfLink = rounds;
/// Surfaces of a body that was put into another one which are compared with all of the other.
inline constexpr std::uint32_t mostCompared = rounds * rounds;
/// Meetings that impacts look at, and pairs whose ways continuous collision does; for each
/// particle, pairs that are looked at. Those of corners and sides count as several; see priceOf().
inline constexpr std::uint32_t askedMeetings = 4 * rounds, keptPairs = 2 * rounds,
                               lookedPairs = rounds;
/// Of networks, for each node: products of blocks, of a step and of its sweeps. A node, and in a
/// pass over them each node and contact, count as `productsOfNode`. Sweeps that come
/// after that wait for the last one.
inline constexpr std::uint64_t networkProducts = 2048, productsOfNode = rounds;

// Loads.

/// One in so many rows that bear must be new for loads to be found by statics: what has rested for
/// longer is better left to the sweeps.
inline constexpr std::uint32_t newShare = 16;
/// The least share of a load along a normal that bears: what leans farther is held by friction too.
inline constexpr double steep = 0.9;

/// Of the worst: a joint that bears as much breaks with it, because a crack opens where a body is
/// loaded most; a body that bears as much of what is pressed in vain stands in the way.
inline constexpr double loadShare = 0.25;

// Joints.

/// Load h^2 K of a spring up to which all of it is a force. The explicit part never goes beyond
/// twice as much.
inline constexpr double softLimit = 1;
/// NSV is stable below a load h^2 K + 2 h B of 4. The springs and dampers of lattices are forces up
/// to so much of it, which leaves some for the stiffness of what is strained.
inline constexpr double forceLimit = 3;
/// Load h B of other dampers up to which they are forces: what is no lattice may be solved as a
/// whole, which is more exact.
inline constexpr double dampedLimit = softLimit / 4;
/// The load, in these limits, from which on a joint is no force at all any more.
inline constexpr double stiffLimit = 1024;
/// How many times stiffness counts at links of ropes, which may move in shorter steps than the
/// forces of springs are found in.
inline constexpr double weightOfLinks = 16;
/// rad/s, and a ratio: bending of a rope, from link to link. The load of its stiffness in a step,
/// 16 h^2 w^2, is a quarter at 480 Hz, that of its damping, 64 h z w, is 2.4: together they stay
/// below the limit of forces.
inline constexpr double ropeFrequency = 60, ropeDamping = 0.3;
/// How far apart, in the list of a body, angular joints may be that push the same thing, to be
/// solved as a whole: those of a strip are two apart.
inline constexpr std::uint32_t widestGroup = 8;
/// How many times steeper an angle may become, by arms that shorten, until its damper brakes less.
inline constexpr double mostSteepened = 4;
/// Of a link's length, beyond which it is strained: a body has no rigid components then, and a tree
/// needs more sweeps.
inline constexpr double strainLimit = 1e-4;
/// Whip is 2 w (tension / length) h^2. Pulls along directions of the step's start explode above
/// about 1, in joints that are swept one by one.
inline constexpr double mostWhip = 1;
/// Of a swept joint, beyond which it pulls along its present direction.
inline constexpr double sweptWhip = mostWhip / 5;

// Triangles of soft bodies, in their area at rest.

/// What a triangle may be pressed to, and where it begins to be looked at in all sweeps of a tick.
inline constexpr double leastShare = 0.2, watchedShare = 1.5 * leastShare;
/// To where what is flatter is led back, after which its springs open it: leading it farther would
/// work against a heap that presses on it.
inline constexpr double recoveredShare = leastShare / 4;
/// What one that is turned over may give in a tick: neighbours that are led back in opposite
/// directions would lock each other.
inline constexpr double givenShare = leastShare / 100;
/// Flatter ones have no side that could be told from the other: twice the area over the sum of the
/// squares of the sides, which is 0.29 for three equal ones and 0.25 for half a square.
inline constexpr double flattest = 0.01;

// Trees.

/// Steps of a tree in a tick.
inline constexpr std::uint32_t mostSteps = 64;
/// Of a link's length.
inline constexpr double treeTolerance = 1e-8;
/// A step is halved when it does more: mostWhip, summed over the links of a node, or this, the sine
/// of the angle that a link turns by.
inline constexpr double mostTurn = 0.2;
/// The shortest steps may do this: less exact, but still far from the explosion, which linear
/// theory puts at a whip of 4.
inline constexpr double tolerableWhip = 3 * mostWhip, tolerableTurn = 3.5 * mostTurn;
/// Below both of these the steps are doubled.
inline constexpr double calmWhip = 0.15 * mostWhip, calmTurn = 0.4 * mostTurn;
/// Newton's method: passes of a step with factors of their own, and passes of a chain, which uses
/// the factors of an earlier one as long as each takes all but a part of the error away. The
/// fallback, which converges more slowly, has more.
inline constexpr int newtonPasses = 6, chainPasses = 10, fallbackPasses = 2 * chainPasses;
inline constexpr double worthwhile = 0.05;
/// Of networks: passes of a step, passes of projections, which wander where a net snaps straight
/// (24 were too few for one of 10 x 10 with 10,000 times a node's mass, 48 are enough), and passes
/// that cost as much as to renew the factors.
inline constexpr int networkPasses = 2 * newtonPasses, projectionPasses = 4 * networkPasses,
                     factorPasses = newtonPasses / 2;
/// Of a link's length: what passes leave, what they leave in the sweeps, what a step may leave at
/// last that keeps energy, or that brakes, and beyond which its multipliers are of no use. What
/// rows begin with may strain a tree as much as what brakes.
inline constexpr double networkTolerance = treeTolerance, sweptTolerance = strainLimit / 100,
                        networkTolerable = 10 * strainLimit,
                        brakingTolerable = 10 * networkTolerable,
                        uselessError = 10 * brakingTolerable;
/// Turn of a link, rad, beyond which factors are renewed.
inline constexpr double factorTurn = 0.02;
/// Compliance of what is rigid in a network, as a share of what its ends answer a push with: a
/// load of a million times the mass of a link strains it by about a thousandth.
inline constexpr double networkCompliance = 1e-7;
/// rad, by which a pass of a projection may turn a link or a node, for which directions still hold.
inline constexpr double projectedTurn = 0.3;
/// Products of blocks that a factorisation may take for each node: nets of 10,000 nodes take 1,000.
inline constexpr std::uint64_t mostProducts = 4000;
/// Smaller than this, relative to what moves there, nothing can: the link is redundant.
inline constexpr double redundantPivot = 1e-13;
/// Steps of a tree that may pull along directions of their end, and steps in which it then goes
/// through what is left: they brake, so that they need not be short.
inline constexpr std::uint32_t mostFallbacks = rounds, coarseSteps = rounds;
/// Times in a sweep that contacts of a tree which would have to pull are let go.
inline constexpr int mostReleases = 4;
/// Of the contacts of networks that touch: how many are solved together, and passes over these.
inline constexpr std::size_t networkContacts = 4 * rounds;
inline constexpr int networkContactPasses = 8 * rounds;
/// What wedges of contacts, and links beside them, may multiply a push by.
inline constexpr double contactLeverage = rounds;
/// Compliance of a contact, as a share of the tree's own mobility: where a link points along the
/// normal, both would otherwise be the same row.
inline constexpr double softest = 1e-3;

}  // namespace sulfur::detail::tuned
