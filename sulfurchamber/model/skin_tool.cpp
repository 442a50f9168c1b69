// Puts the picture of a body in its place by handles.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "skins.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

class SkinTool final : public Tool {
public:
    SkinTool(Workbench& bench, BodyId body) : Tool(bench), id_(bench.document().idOf(body)) {}

    void press(const Pointer& pointer) override {
        const auto frame = frameNow();
        if (!frame) return;
        const Point at = toBody(pointer.position);
        from_ = at;
        before_ = *frame;
        doing_ = Doing::nothing;
        const auto corners = frame->corners();
        const auto hit = [&](const Point& place) { return (place - at).norm() <= pointer.reach; };
        if (hit(knobOf(*frame)))
            doing_ = Doing::turn;
        else if (std::any_of(corners.begin(), corners.end(), hit))
            doing_ = Doing::scale;
        else if (contains(*frame, at))
            doing_ = Doing::move;
        done_ = doing_ == Doing::nothing;
        if (!done_) document().begin("Move the skin");
    }

    void move(const Pointer& pointer) override {
        if (doing_ == Doing::nothing || !document().editing()) return;
        const Point at = toBody(pointer.position);
        SkinMapping next = before_;
        const Point out = from_ - before_.centre, now = at - before_.centre;
        if (doing_ == Doing::move) next.centre += at - from_;
        if (doing_ == Doing::turn) next.angle += std::atan2(sulfur::cross(out, now), out.dot(now));
        if (doing_ == Doing::scale && pointer.shift) {
            next.size *= std::max(now.norm() / std::max(out.norm(), 1e-9), 1e-3);
        } else if (doing_ == Doing::scale) {
            const Eigen::Rotation2Dd back(-before_.angle);
            const Point a = back * out, b = back * now;
            next.size.x() *= std::max(std::abs(b.x() / nonZero(a.x())), 1e-3);
            next.size.y() *= std::max(std::abs(b.y() / nonZero(a.y())), 1e-3);
        }
        for (int axis = 0; axis < 2; ++axis) {
            double& side = next.size[axis];
            side = std::copysign(std::clamp(std::abs(side), SkinLimits::leastSize, 100.0), side);
        }
        const BodyId body = document().bodyOf(id_);
        document().change({&body, 1}, [&](auto& prefab) { setMapping(prefab, next); });
    }

    void release(const Pointer& pointer) override {
        move(pointer);
        doing_ = Doing::nothing;
        document().commit();
    }
    void cancel() override {
        if (doing_ != Doing::nothing) document().rollback();
        doing_ = Doing::nothing;
    }
    bool done() const override { return done_; }

    Preview preview() const override {
        const auto frame = frameNow();
        if (!frame) return {};
        Preview shown{.kind = Preview::Kind::skin};
        for (const Point& corner : frame->corners()) shown.points.push_back(toWorld(corner));
        shown.to = toWorld(knobOf(*frame));
        return shown;
    }
    std::string hint() const override {
        return "Drag the picture, its corners (Shift: evenly) or its knob; click beside it to end";
    }

private:
    enum class Doing : std::uint8_t { nothing, move, scale, turn };

    static double nonZero(double value) { return std::abs(value) > 1e-9 ? value : 1e-9; }
    std::optional<SkinMapping> frameNow() const {
        if (!document().plan().contains(id_) || !document().bodyOf(id_)) return std::nullopt;
        return mappingOf(document().plan().dressed(id_));
    }
    sulfur::Pose pose() const { return world().pose(document().bodyOf(id_)); }
    Point toBody(const Point& place) const {
        return Eigen::Rotation2Dd(-pose().angle) * (place - pose().position);
    }
    Point toWorld(const Point& local) const {
        return pose().position + Eigen::Rotation2Dd(pose().angle) * local;
    }
    static Point knobOf(const SkinMapping& frame) {
        const double up = std::abs(frame.size.y()) / 2 + 0.15 * frame.size.cwiseAbs().maxCoeff();
        return frame.centre + Eigen::Rotation2Dd(frame.angle) * Point(0, up);
    }
    static bool contains(const SkinMapping& frame, const Point& at) {
        const Point local = Eigen::Rotation2Dd(-frame.angle) * (at - frame.centre);
        return std::abs(local.x()) <= std::abs(frame.size.x()) / 2 &&
               std::abs(local.y()) <= std::abs(frame.size.y()) / 2;
    }

    std::string id_;
    SkinMapping before_;
    Point from_{0, 0};
    Doing doing_ = Doing::nothing;
    bool done_ = false;
};

}  // namespace

std::unique_ptr<Tool> makeSkinTool(Workbench& bench, BodyId body) {
    return std::make_unique<SkinTool>(bench, body);
}

}  // namespace sulfurchamber
