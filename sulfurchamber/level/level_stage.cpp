#include "level_stage.hpp"

#include <atlax/backend.hpp>

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;

constexpr Color found = Color::hex(0x7CE0A3);
constexpr Color wrong = Color::hex(0xFF5E57);

}  // namespace

LevelStage::LevelStage(Workbench& bench, SceneView& view)
    : bench_(bench), view_(view), desk_(bench.document()) {
    view_.scenery = [this](atlax::Canvas& canvas, const atlax::Camera& camera) {
        return drawScenery(canvas, camera);
    };
    view_.overlay = [this](atlax::Canvas& canvas, const atlax::Camera& camera,
                           const atlax::Font& font) { drawOverlay(canvas, camera, font); };
    view_.onGraphicsLost = [this] {
        test_.reset();
        picture_.forgetGraphics();
    };
}

LevelStage::~LevelStage() {
    endPlay();
    view_.scenery = nullptr;
    view_.overlay = nullptr;
    view_.onGraphicsLost = nullptr;
}

void LevelStage::follow() {
    const bool knew = desk_.checked();
    desk_.follow();
    if (auto session = desk_.takeSession())
        picture_.show(std::move(session));
    else if (!knew && desk_.checked() && !desk_.level())
        picture_.hide();
    if (!isLevel(bench_.document())) picture_.hide();
    if (test_ && !view_.hasGuest()) test_.reset();
    if (!test_) return;
    if (firstPicture_ == 0 && test_->frames() > 0)
        firstPicture_ = static_cast<double>(atlax::monotonicNs() - playedAtNs_) * 1e-9;
}

void LevelStage::opened() {
    endPlay();
    picture_.hide();
    desk_.opened();
    nextProblem_ = 0;
}

// --- drawing ---------------------------------------------------------------------------------

bool LevelStage::drawScenery(atlax::Canvas& canvas, const atlax::Camera& camera) {
    const Document& document = bench_.document();
    if (!pictured_ || !picture_.shows() || !isLevel(document) || document.canReset()) return false;
    picture_.draw(canvas, camera);
    return true;
}

void LevelStage::drawOverlay(atlax::Canvas& canvas, const atlax::Camera& camera,
                             const atlax::Font& font) {
    canvas.setCamera(camera);
    const float pixel = canvas.pixel() * canvas.scaleFactor();
    if (wayShown_) drawSearch(canvas, pixel);
    drawProblems(canvas, pixel);
    marks_.paint(canvas, camera, font, bench_);
}

void LevelStage::drawSearch(atlax::Canvas& canvas, float pixel) const {
    const SearchJob* job = desk_.job();
    if (job != nullptr && job->progress().stage == SearchProgress::Stage::searching)
        for (const sulfur::Point& place : job->frontier())
            canvas.circle(Vec2(place), std::max(0.07f, 2 * pixel), found.withAlpha(0.35f));
    const auto result = desk_.result();
    if (!result || result->way.size() < 2) return;
    std::vector<Vec2> way;
    for (const sulfur::Point& place : result->way) way.emplace_back(place);
    const bool holds = desk_.proof() == LevelDesk::Proof::holds;
    canvas.polyline(way, 2 * pixel, found.withAlpha(holds ? 0.75f : 0.25f));
}

void LevelStage::drawProblems(atlax::Canvas& canvas, float pixel) const {
    for (const LevelProblem& problem : desk_.problems()) {
        if (!problem.place) continue;
        const Vec2 at(*problem.place);
        const Color color = problem.grave ? wrong : Color::hex(0xFFB347);
        canvas.circleOutline(at, 15 * pixel, 2 * pixel, color);
        canvas.line(at + Vec2{0, 23 * pixel}, at + Vec2{0, 17 * pixel}, 2.4f * pixel, color);
    }
}

// --- playing ---------------------------------------------------------------------------------

void LevelStage::play(const std::optional<sulfur::Point>& from) {
    playedAtNs_ = atlax::monotonicNs();
    firstPicture_ = 0;
    Document& document = bench_.document();
    document.commit();
    auto level = desk_.checked() ? desk_.level() : nullptr;
    if (!level)
        level = std::make_shared<const quaoar::Level>(quaoar::parseLevel(
            document.text(), document.file().empty() ? "new-level.json" : document.file()));
    if (from) level = startingAt(*level, *from);
    endPlay();
    view_.invite([this, level, fromSpawn = !from](
                     atlax::Canvas& canvas) { return makeTest(canvas, level, fromSpawn); },
                 quaoar::Session::tickRate);
}

atlax::Application* LevelStage::makeTest(atlax::Canvas& canvas,
                                         std::shared_ptr<const quaoar::Level> level,
                                         bool fromSpawn) {
    test_ = std::make_unique<PlayTest>(std::move(level), picture_.art(canvas), picture_.view());
    if (fromSpawn)
        test_->onFinish = [this](const quaoar::Recording& recording) { desk_.offer(recording); };
    return test_.get();
}

void LevelStage::endPlay() {
    view_.dismiss();
    test_.reset();
}

// --- going to --------------------------------------------------------------------------------

void LevelStage::goTo(const LevelThing& thing) {
    if (!contains(bench_.document(), thing)) return;
    bench_.selectThings({thing});
    const LevelShape shape = shapeOf(bench_.document(), thing);
    if (shape.form == LevelShape::Form::rectangle)
        view_.lookAt(shape.box.centre());
    else if (shape.form != LevelShape::Form::none)
        view_.lookAt(shape.at);
}

void LevelStage::goTo(std::size_t place) {
    if (place >= desk_.problems().size()) return;
    nextProblem_ = place + 1;
    const LevelProblem problem = desk_.problems()[place];
    if (problem.thing) goTo(*problem.thing);
    if (const auto body = bench_.document().bodyOf(problem.body)) bench_.select({body});
    if (problem.place) view_.lookAt(*problem.place);
}

void LevelStage::goToNext() {
    const std::size_t count = desk_.problems().size();
    if (count > 0) goTo(nextProblem_ % count);
}

}  // namespace sulfurchamber
