// Puts pieces of a level into the picture.
#include <algorithm>

#include "geometry.hpp"
#include "level_pieces.hpp"
#include "tool.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

class PlaceTool final : public Tool {
public:
    PlaceTool(Workbench& bench, LevelPiece piece) : Tool(bench), info_(infoOf(piece)) {}

    void press(const Pointer& pointer) override {
        from_ = to_ = bench().snapped(pointer.position);
        body_ = bodyAt(world(), pointer.position, pointer.reach);
        reach_ = pointer.reach;
        pressed_ = true;
    }
    void move(const Pointer& pointer) override {
        to_ = bench().snapped(pointer.position);
        reach_ = pointer.reach;
    }
    void cancel() override {
        pressed_ = false;
        corners_.clear();
    }

    void release(const Pointer& pointer) override {
        if (!pressed_) return;
        pressed_ = false;
        to_ = bench().snapped(pointer.position);
        const bool dragged = (to_ - from_).norm() > 2 * pointer.reach;
        if (info_.placing == Placing::corners && !dragged)
            addCorner(pointer);
        else if (corners_.empty())
            place(info_.placing == Placing::click ? from_ : to_);
    }

    void finish() override {
        if (corners_.size() < 3) return;
        std::vector<Point> outline = std::exchange(corners_, {});
        add([&] { return addGround(document(), std::move(outline)); });
    }

    Preview preview() const override {
        if (!corners_.empty()) {
            Preview shown{Preview::Kind::outline, corners_.front(), to_, 0, corners_};
            shown.points.push_back(to_);
            return shown;
        }
        if (!pressed_ || (to_ - from_).norm() < reach_) return {};
        if (info_.placing == Placing::way) return {Preview::Kind::line, from_, to_, 0, {}};
        if (info_.placing == Placing::click) return {};
        return {Preview::Kind::rectangle, from_, to_, 0, {}};
    }

    std::string hint() const override {
        if (corners_.size() > 2)
            return "Click the next corner, or the first one (or Enter) to close; Escape drops it";
        return std::string(info_.hint);
    }

private:
    void addCorner(const Pointer& pointer) {
        const bool closes =
            corners_.size() > 2 && ((to_ - corners_.front()).norm() <= pointer.reach ||
                                    (to_ - corners_.back()).norm() <= pointer.reach / 2);
        if (closes)
            finish();
        else if (corners_.empty() || to_ != corners_.back())
            corners_.push_back(to_);
    }

    void place(const Point& end) {
        add([&] { return placePiece(document(), info_.piece, from_, end, body_); });
    }

    void add(const std::function<LevelThing()>& make) {
        std::string label = tr(std::string(info_.label));
        std::erase(label, '&');
        LevelThing made;
        document().edit(tr("Add {}", {label}), [&] { made = make(); });
        bench().selectThings({made});
    }

    const LevelPieceInfo& info_;
    Point from_{0, 0};
    Point to_{0, 0};
    BodyId body_;
    double reach_ = 0.1;
    bool pressed_ = false;
    std::vector<Point> corners_;
};

}  // namespace

std::unique_ptr<Tool> makePlaceTool(Workbench& bench, LevelPiece piece) {
    return std::make_unique<PlaceTool>(bench, piece);
}

}  // namespace sulfurchamber
