#include "level_desk.hpp"

#include <array>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "../model/words.hpp"

namespace sulfurchamber {
namespace {

// "The Cold Wake!" becomes "the-cold-wake".
std::string fileName(const std::string& levelName) {
    std::string made;
    for (const char c : levelName) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 0x80)
            made += static_cast<char>(std::tolower(byte));
        else if (!made.empty() && made.back() != '-')
            made += '-';
    }
    while (made.ends_with('-')) made.pop_back();
    return made.empty() ? "level" : made;
}

std::string secondsText(double seconds) {
    return fixed(seconds, 1) + " s";
}

std::string resultText(const SearchResult& result) {
    const std::string text = secondsText(quaoar::secondsOf(result.proof.ticks()));
    const quaoar::Survival& survival = result.robust.survival;
    if (survival.games > 0)
        return tr("{}; the robust bot finishes {} % of {} games",
                  {text, std::to_string(std::lround(100 * survival.share())),
                   std::to_string(survival.games)});
    return text;
}

std::string progressText(const SearchProgress& progress) {
    using Stage = SearchProgress::Stage;
    const std::string percent = std::to_string(std::lround(100 * progress.share));
    switch (progress.stage) {
        case Stage::replaying:
            return tr("Trying what is known\xE2\x80\xA6");
        case Stage::searching:
            return tr("Searching for a way: {} %, {} m to go at best",
                      {percent, std::to_string(std::lround(progress.nearest))});
        case Stage::shortening:
            return tr("Making the way quicker: {} %", {percent});
        case Stage::practising:
            return tr("The robust bot practises: {} %", {percent});
        case Stage::playing:
            return tr("The robust bot plays: {} %", {percent});
        case Stage::done:
        case Stage::failed:
        case Stage::stopped:
            break;
    }
    return "";
}

}  // namespace

// --- watching --------------------------------------------------------------------------------

LevelWatch::LevelWatch() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

LevelWatch::~LevelWatch() {
    thread_.request_stop();
    wake_.notify_all();
}

void LevelWatch::ask(std::string text, std::filesystem::path file, std::uint64_t ticket) {
    const std::lock_guard lock(guard_);
    question_ = Question{ticket, std::move(text), std::move(file)};
    wake_.notify_all();
}

std::optional<LevelWatch::Answer> LevelWatch::take() {
    const std::lock_guard lock(guard_);
    return std::exchange(answer_, std::nullopt);
}

void LevelWatch::run(const std::stop_token& stop) {
    std::unique_lock lock(guard_);
    while (wake_.wait(lock, stop, [this] { return question_.has_value(); })) {
        Question question = *std::exchange(question_, std::nullopt);
        lock.unlock();
        Answer answer;
        answer.ticket = question.ticket;
        answer.report = checkLevelText(question.text, question.file);
        answer.text = std::move(question.text);
        lock.lock();
        answer_ = std::move(answer);
    }
}

// --- the desk --------------------------------------------------------------------------------

std::filesystem::path LevelDesk::name() const {
    return document_.file().empty() ? std::filesystem::path("new-level.json") : document_.file();
}

void LevelDesk::follow() {
    if (!isLevel(document_)) {
        problems_.clear();
        level_.reset();
        session_.reset();
        askedState_ = checkedState_ = 0;
        return;
    }
    // While something is dragged the check waits.
    if (askedState_ != document_.state() && !document_.editing()) {
        askedState_ = document_.state();
        watch_.ask(text(), name(), askedState_);
    }
    if (auto answer = watch_.take(); answer && answer->ticket == askedState_) {
        checkedState_ = answer->ticket;
        playable_ = answer->report.playable();
        problems_ = std::move(answer->report.problems);
        level_ = std::move(answer->report.level);
        session_ = std::move(answer->report.session);
    }
    if (!job_) return;
    if (const auto found = job_->result();
        found && found != result_ && (!quiet_ || job_->progress().over())) {
        result_ = found;
        provenState_ = jobState_;
        if (!document_.modified() && proof() == Proof::holds) saved();
    }
    if (quiet_ && job_->progress().over()) job_.reset();
}

// --- proofs ----------------------------------------------------------------------------------

LevelDesk::Proof LevelDesk::proof() const {
    const bool running = job_ && !job_->progress().over();
    if (result_ && provenState_ == document_.state()) return Proof::holds;
    if (running && jobState_ == document_.state()) return Proof::asked;
    if (result_) return Proof::outdated;
    if (job_ && jobState_ == document_.state() &&
        job_->progress().stage == SearchProgress::Stage::failed)
        return Proof::failed;
    return Proof::none;
}

std::string LevelDesk::proofText() const {
    std::string going;
    if (job_ && !job_->progress().over()) {
        going = progressText(job_->progress());
        if (jobState_ != document_.state()) going = tr("{} (of the level as it was)", {going});
    }
    switch (proof()) {
        case Proof::holds:
            return tr("It can be finished in {}.", {resultText(*result_)}) +
                   (going.empty() ? "" : " " + going);
        case Proof::outdated:
            if (!going.empty()) return going;
            return tr("The proof is void: the level has changed since it was finished in {}.",
                      {resultText(*result_)});
        case Proof::failed:
            return tr("No proof: {}.", {tr(job_->progress().problem)});
        case Proof::asked:
            return going;
        case Proof::none:
            break;
    }
    return going.empty() ? tr("It is not known whether it can be finished.") : going;
}

void LevelDesk::start(SearchJobOptions options) {
    auto level = std::make_shared<const quaoar::Level>(quaoar::parseLevel(text(), name()));
    job_ = std::make_unique<SearchJob>(std::move(level), std::move(options));
    jobState_ = document_.state();
}

void LevelDesk::search(SearchJobOptions options) {
    if (!isLevel(document_)) throw std::runtime_error("this scene is no level yet");
    document_.commit();
    if (checked())
        for (const LevelProblem& problem : problems_)
            if (problem.grave)
                throw std::runtime_error(tr("it cannot be finished as it is: {}", {problem.text}));
    if (result_ && !options.known) options.known = result_->proof;
    quiet_ = false;
    start(std::move(options));
}

void LevelDesk::stopSearch() {
    if (job_) job_->stop();
}

void LevelDesk::offer(const quaoar::Recording& recording) {
    if (!isLevel(document_)) return;
    if (proof() == Proof::holds && result_->proof.ticks() <= recording.ticks()) return;
    SearchJobOptions options;
    options.known = recording;
    options.search = false;
    quiet_ = true;
    start(std::move(options));
}

void LevelDesk::takeMedals() {
    if (!result_) throw std::runtime_error("medals are suggested once the level was finished");
    const quaoar::MedalTimes medals = result_->medals;
    const quaoar::Recording known = result_->proof;
    document_.edit("Medals by the proof", [&] {
        JsonText text(document_.levelText());
        text.set({"medals", "gold"}, jsonOf(medals.gold));
        text.set({"medals", "silver"}, jsonOf(medals.silver));
        text.set({"medals", "bronze"}, jsonOf(medals.bronze));
        document_.setLevelText(text.text());
    });
    offer(known);
}

// --- files -----------------------------------------------------------------------------------

void LevelDesk::opened() {
    job_.reset();
    result_.reset();
    provenState_ = jobState_ = 0;
    quiet_ = false;
    std::error_code ignored;
    const auto file = quaoar::proofOf(document_.file());
    if (!isLevel(document_) || document_.file().empty() || !std::filesystem::exists(file, ignored))
        return;
    try {
        offer(quaoar::Recording::read(file));
    } catch (const std::exception& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

void LevelDesk::writeProof(const std::filesystem::path& levelFile,
                           const SearchResult& result) const {
    const auto level = quaoar::parseLevel(text(), levelFile);
    recordingFor(level, result.proof).write(quaoar::proofOf(levelFile));
    if (result.robust.survival.games == 0) return;
    quaoar::WayFile way = result.robust;
    way.levelId = level.id;
    way.levelHash = level.contentHash;
    way.write(quaoar::wayOf(levelFile));
}

void LevelDesk::saved() {
    if (proof() != Proof::holds || document_.modified() || document_.file().empty()) return;
    const auto& file = document_.file();
    // A file that was written by others may hold the same level in other bytes: then its own proof
    // is not touched.
    try {
        if (atlax::readFile(file, sulfur::scene::DocumentLimits{}.bytes) != text()) return;
    } catch (const std::exception&) {
        return;
    }
    const auto beside = quaoar::proofOf(file);
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored)) {
        // One that fits and is as quick stays.
        try {
            const auto known = quaoar::Recording::read(beside);
            if (known.levelHash == quaoar::contentHash(text()) &&
                known.ticks() <= result_->proof.ticks() && result_->robust.survival.games == 0)
                return;
        } catch (const std::exception&) {
            // It is damaged, and replaced.
        }
    }
    writeProof(file, *result_);
}

std::filesystem::path LevelDesk::gameFolder() {
    return atlax::dataFolder("quaoar") / "levels";
}

std::filesystem::path LevelDesk::publish(const std::filesystem::path& folder) {
    if (!isLevel(document_)) throw std::runtime_error("this scene is no level yet");
    document_.commit();
    const auto report = checkLevelText(text(), name());
    for (const LevelProblem& problem : report.problems)
        if (problem.grave)
            throw std::runtime_error(tr("this level cannot be published: {}", {problem.text}));
    const auto file = folder / (fileName(report.level->name) + ".json");
    atlax::writeFileAtomic(file, text(), atlax::Backup::None);
    std::error_code ignored;
    std::filesystem::remove(quaoar::proofOf(file), ignored);
    std::filesystem::remove(quaoar::wayOf(file), ignored);
    if (proof() == Proof::holds) writeProof(file, *result_);
    return file;
}

}  // namespace sulfurchamber
