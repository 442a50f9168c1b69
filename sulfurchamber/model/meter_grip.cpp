#include "meter_grip.hpp"
#include "words.hpp"

namespace sulfurchamber {

using sulfur::Point;

std::optional<MeterGrip> MeterGrip::take(Workbench& bench, const Pointer& pointer) {
    const auto pick = meterAt(bench.meters(), pointer.position, pointer.reach);
    if (!pick) return std::nullopt;
    const Meter* meter = bench.meters().find(pick->id);
    Meter taken = *meter;
    // Where the whole is carried, its ends let go of what they hold.
    if (!pick->end)
        for (std::size_t i = 0; i < taken.ends.size(); ++i)
            if (const auto place = bench.meters().place(*meter, i))
                taken.ends[i] = {*place, {}, {}};
    if (pointer.shift || pointer.control) {
        auto ids = bench.selectedMeters();
        if (std::erase(ids, pick->id) == 0) ids.push_back(pick->id);
        bench.selectMeters(std::move(ids), true);
    } else if (!bench.meterSelected(pick->id)) {
        bench.selectMeters({pick->id});
    }
    return MeterGrip(std::move(taken), pick->end, pointer.position);
}

void MeterGrip::moveTo(Workbench& bench, const Pointer& pointer) {
    const Point by = pointer.position - from_;
    if (!moved_ && by.norm() < pointer.reach / 3) return;
    Meter next = meter_;
    if (!end_) {
        for (MeterEnd& end : next.ends) end.at += by;
    } else if (next.kind == MeterKind::gauge) {
        auto ends = gaugeAt(bench.document(), pointer.position, pointer.reach);
        if (ends.empty()) return;
        next.ends = std::move(ends);
    } else {
        MeterEnd end = endAt(bench.document(), pointer.position, pointer.reach);
        if (next.kind == MeterKind::gun) end = {pointer.position, {}, {}};
        if (next.kind == MeterKind::tracer && end.body.empty()) return;
        if (end.body.empty() && end.at == pointer.position) end.at = bench.snapped(end.at);
        next.ends[*end_] = std::move(end);
    }
    if (!moved_) bench.document().begin(tr("Move {}", {meter_.id}));
    moved_ = true;
    changeMeter(bench.document().planForEditing(), next);
}

void MeterGrip::release(Workbench& bench) {
    if (moved_) bench.document().commit();
    moved_ = false;
}

void MeterGrip::cancel(Workbench& bench) {
    if (moved_) bench.document().rollback();
    moved_ = false;
}

}  // namespace sulfurchamber
