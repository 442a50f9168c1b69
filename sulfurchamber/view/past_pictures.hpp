// Small pictures of the recorded past, as the time bar shows them.
#pragma once

#include <atlax/image.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "../model/document.hpp"
#include "time_bar_layout.hpp"

namespace sulfurchamber {

/// Pictures of moments that were seen, while they are recorded: what the timeline forgets is
/// forgotten here too, and a line has those of the branches that it came from. They are so few and
/// so small that, with the timeline's own bytes, 64 MiB hold all.
///
/// Who draws asks in each frame whether one is due: some a second at most, and so seldom that
/// drawing them costs a twentieth of the time. One thread.
class PastPictures {
public:
    static constexpr atlax::PixelSize size{160, 90};
    static constexpr std::size_t most = 60;
    static constexpr std::int64_t restNs = 250'000'000;  ///< between two at least

    struct Picture {
        std::uint64_t serial = 0;    ///< another one for each picture
        Moment moment;               ///< of the branch whose own tick it is
        std::uint64_t revision = 0;  ///< of the document
        atlax::Image image;
    };

    /// Forgets what the timeline has forgotten, and how a moment was before an edit. Whether what
    /// the world shows now is worth a picture: it is a recorded moment, none of the line is near,
    /// and the last one was taken long enough ago.
    bool due(const Document& document, std::int64_t nowNs);
    /// Of the present moment. Precondition: due(). `costNs` is what drawing has taken.
    void add(const Document& document, atlax::Image image, std::int64_t nowNs, std::int64_t costNs);

    /// The picture of the shown line that is nearest to a moment of it, or null where none is near.
    const Picture* near(const Document& document, const Moment& moment) const;
    /// The same for each of the places of a strip along the time bar, from the left. Null also
    /// where nothing is recorded.
    std::vector<const Picture*> strip(const Document& document, const TimeBarLayout& layout,
                                      double width, int places) const;
    std::size_t count() const { return pictures_.size(); }

private:
    std::vector<const Picture*> ofLine(const Timeline& timeline) const;
    void thin();

    std::vector<Picture> pictures_;  ///< by branch, then by tick
    std::uint64_t lastSerial_ = 0;
    std::int64_t nextNs_ = 0;
};

}  // namespace sulfurchamber
