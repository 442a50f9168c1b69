#include "integrators/position_sweeps.hpp"

#include <cmath>

namespace sulfur::lab {

namespace {

double crossOf(const Vec& a, const Vec& b) {
    return a.x() * b.y() - a.y() * b.x();
}

void turnBy(SweptBody& body, double angle) {
    body.turn = (body.turn + angle * Vec(-body.turn.y(), body.turn.x())).normalized();
}

}  // namespace

PositionSweeps::PositionSweeps(std::vector<SweptBody> bodies, std::vector<SweptLink> links,
                               double gravity, int sweeps)
    : bodies_(std::move(bodies)), links_(std::move(links)), gravity_(gravity), sweeps_(sweeps) {}

void PositionSweeps::hold(const SweptLink& link) {
    SweptBody &a = bodies_[link.a], &b = bodies_[link.b];
    const Vec atA = a.at(link.onA), atB = b.at(link.onB), apart = atB - atA;
    const double length = apart.norm();
    if (length == 0) return;
    const Vec along = apart / length;
    const double armA = crossOf(atA - a.place, along), armB = crossOf(atB - b.place, along);
    const double answer = a.inverseMass + b.inverseMass + armA * armA * a.inverseInertia +
                          armB * armB * b.inverseInertia;
    if (answer == 0) return;
    const double push = (length - link.length) / answer;
    a.place += push * a.inverseMass * along;
    b.place -= push * b.inverseMass * along;
    if (a.inverseInertia > 0) turnBy(a, push * armA * a.inverseInertia);
    if (b.inverseInertia > 0) turnBy(b, -push * armB * b.inverseInertia);
}

void PositionSweeps::step(double h) {
    before_ = bodies_;
    for (SweptBody& body : bodies_) {
        if (body.inverseMass == 0) continue;
        body.velocity.y() -= h * gravity_;
        body.place += h * body.velocity;
        if (body.inverseInertia > 0) turnBy(body, h * body.spin);
    }
    for (int sweep = 0; sweep < sweeps_; ++sweep) {
        for (const SweptLink& link : links_) hold(link);
        for (std::size_t i = links_.size(); i-- > 0;) hold(links_[i]);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        SweptBody& body = bodies_[i];
        body.velocity = (body.place - before_[i].place) / h;
        if (body.inverseInertia > 0)
            body.spin =
                std::atan2(crossOf(before_[i].turn, body.turn), before_[i].turn.dot(body.turn)) / h;
    }
}

}  // namespace sulfur::lab
