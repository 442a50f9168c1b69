#include <sulfur/scene/file.hpp>

#include "whole_file.hpp"

namespace sulfur::scene {

void writeFile(const std::string& text, const std::filesystem::path& file) {
    try {
        files::writeWhole(file, text, files::Backup::one);
    } catch (const files::NotWritten& problem) {
        throw WriteError(std::string(problem.what()) +
                         "; nothing was changed, choose another place or make room");
    }
}

void write(const Scene& scene, const std::filesystem::path& file) {
    const std::string text = format(scene);
    parse(text, file.string());
    writeFile(text, file);
}

void writeBlueprint(const Prefab& prefab, const std::filesystem::path& file) {
    const std::string text = format(prefab);
    parseBlueprint(text, file.string());
    writeFile(text, file);
}

}  // namespace sulfur::scene
