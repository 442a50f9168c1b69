#include "text_change.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <unordered_map>

namespace sulfurchamber {
namespace {

using Lines = std::vector<std::string_view>;

Lines linesOf(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

std::size_t length(const Lines& lines, std::size_t from, std::size_t to) {
    std::size_t bytes = 0;
    for (std::size_t i = from; i < to; ++i) bytes += lines[i].size();
    return bytes;
}

std::string joined(const Lines& lines, std::size_t from, std::size_t to) {
    std::string text;
    text.reserve(length(lines, from, to));
    for (std::size_t i = from; i < to; ++i) text += lines[i];
    return text;
}

// Lines that are there once, with their places: where both texts have such a line, they meet.
std::unordered_map<std::string_view, std::size_t> uniqueLines(const Lines& lines) {
    constexpr std::size_t several = static_cast<std::size_t>(-1);
    std::unordered_map<std::string_view, std::size_t> places;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto [found, isNew] = places.emplace(lines[i], i);
        if (!isNew) found->second = several;
    }
    std::erase_if(places, [](const auto& entry) { return entry.second == several; });
    return places;
}

void putNumber(std::string& bytes, std::size_t number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof number);
}

std::size_t takeNumber(std::string_view& bytes) {
    std::size_t number = 0;
    if (bytes.size() < sizeof number) throw std::runtime_error("the history is damaged");
    std::memcpy(&number, bytes.data(), sizeof number);
    bytes.remove_prefix(sizeof number);
    return number;
}

std::string takeText(std::string_view& bytes) {
    const std::size_t size = takeNumber(bytes);
    if (bytes.size() < size) throw std::runtime_error("the history is damaged");
    std::string text(bytes.substr(0, size));
    bytes.remove_prefix(size);
    return text;
}

}  // namespace

TextChange TextChange::between(std::string_view before, std::string_view after) {
    TextChange change;
    if (before == after) return change;
    const Lines a = linesOf(before);
    const Lines b = linesOf(after);
    const auto unique = uniqueLines(a);
    std::size_t i = 0;
    std::size_t j = 0;
    std::size_t at = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            at += a[i].size();
            ++i, ++j;
            continue;
        }
        std::size_t nextI = a.size();
        std::size_t nextJ = j;
        for (; nextJ < b.size(); ++nextJ) {
            const auto meeting = unique.find(b[nextJ]);
            if (meeting == unique.end() || meeting->second < i) continue;
            nextI = meeting->second;
            break;
        }
        change.pieces_.push_back({at, joined(a, i, nextI), joined(b, j, nextJ)});
        at += length(a, i, nextI);
        i = nextI;
        j = nextJ;
    }
    return change;
}

std::string TextChange::apply(std::string_view before) const {
    std::string after;
    std::size_t done = 0;
    for (const Piece& piece : pieces_) {
        after += before.substr(done, piece.at - done);
        after += piece.after;
        done = piece.at + piece.before.size();
    }
    after += before.substr(done);
    return after;
}

std::string TextChange::revert(std::string_view after) const {
    std::string before;
    std::size_t done = 0;
    for (const Piece& piece : pieces_) {
        const std::size_t same = piece.at - before.size();
        before += after.substr(done, same);
        before += piece.before;
        done += same + piece.after.size();
    }
    before += after.substr(done);
    return before;
}

std::string TextChange::bytes() const {
    std::string all;
    for (const Piece& piece : pieces_) {
        putNumber(all, piece.at);
        for (const std::string* text : {&piece.before, &piece.after}) {
            putNumber(all, text->size());
            all += *text;
        }
    }
    return all;
}

TextChange TextChange::fromBytes(std::string_view bytes) {
    TextChange change;
    while (!bytes.empty()) {
        Piece piece;
        piece.at = takeNumber(bytes);
        piece.before = takeText(bytes);
        piece.after = takeText(bytes);
        change.pieces_.push_back(std::move(piece));
    }
    return change;
}

}  // namespace sulfurchamber
