#include "textbook.hpp"

#include <algorithm>

#include "laws.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;

constexpr std::size_t mostNotes = 60'000;  // two minutes at the usual rate

}  // namespace

std::optional<double> Finding::difference() const {
    if (!measured) return std::nullopt;
    return *measured - expected;
}

// What is wrong is told, and the scene is then as any other.
void Textbook::follow() const {
    const auto* member = sulfur::scene::findExtra(document_.scene().extra, "textbook");
    const std::string& text = member == nullptr ? std::string() : member->json;
    if (text == text_) return;
    text_ = text;
    subject_.reset();
    problem_.clear();
    if (text.empty()) return;
    try {
        const auto section = document_.scene().section("textbook");
        const auto root = section->root();
        const auto name = root.at("law").string(1, 40);
        Subject subject;
        const auto books = lawBooks();
        const auto book = std::find_if(books.begin(), books.end(),
                                       [&](const LawBook& one) { return one.name == name; });
        if (book == books.end())
            root.at("law").fail(
                tr("is \"{}\"; allowed are pendulum, fall, throwing, slope, spring, collision and "
                   "rolling",
                   {name}));
        subject.law = static_cast<Law>(book - books.begin());
        for (const auto& id : root.at("bodies").array(book->bodies, book->bodies))
            subject.bodies.push_back(id.string(1, sulfur::scene::Limits::nameBytes));
        subject_ = std::move(subject);
    } catch (const sulfur::scene::ReadError& error) {
        problem_ = error.what();
    }
}

// All of them, or none when one is missing.
std::vector<BodyId> Textbook::bodies() const {
    follow();
    std::vector<BodyId> found;
    if (!subject_) return found;
    for (const std::string& id : subject_->bodies) {
        const BodyId body = document_.bodyOf(id);
        if (!body) return {};
        found.push_back(body);
    }
    return found;
}

bool Textbook::applies() const {
    return !bodies().empty() && problem().empty();
}

std::string Textbook::problem() const {
    follow();
    if (!problem_.empty() || !subject_) return problem_;
    const auto found = bodies();
    if (found.empty()) return "A body that the formula needs is not there or has broken.";
    return lawBook(subject_->law).lacks(document_.world(), found);
}

std::string_view Textbook::title() const {
    return applies() ? lawBook(subject_->law).title : std::string_view();
}

std::vector<Finding> Textbook::findings() const {
    if (!applies()) return {};
    const LawBook& book = lawBook(subject_->law);
    const auto numbers = book.numbers(document_.world(), bodies());
    const double now = document_.world().time();
    // Without a past the start is what one sees.
    std::vector<Note> start;
    std::span<const Note> past = notes_;
    while (!past.empty() && past.back().time > now + 1e-9) past = past.first(past.size() - 1);
    if (past.empty() || numbers != basis_) {
        start.push_back({now, book.look(document_.world(), bodies())});
        past = start;
    }
    return book.find(numbers, past);
}

void Textbook::beforeTick() {
    if (!applies()) {
        notes_.clear();
        return;
    }
    const auto numbers = lawBook(subject_->law).numbers(document_.world(), bodies());
    if (numbers != basis_) notes_.clear();
    basis_ = numbers;
    if (notes_.empty() || notes_.front().time > document_.world().time() - 1e-9) note();
}

void Textbook::sample() {
    if (applies() && !notes_.empty()) note();
}

void Textbook::note() {
    const double now = document_.world().time();
    while (!notes_.empty() && notes_.back().time > now - 1e-9) notes_.pop_back();
    if (notes_.size() < mostNotes)
        notes_.push_back({now, lawBook(subject_->law).look(document_.world(), bodies())});
}

}  // namespace sulfurchamber
