#include "skins.hpp"
#include "words.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <cctype>
#include <cmath>
#include <quaoar/skin/body_shape.hpp>
#include <set>
#include <stdexcept>

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;
using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Prefab;

constexpr const char* skinFolder = "skins";  // beside a scene, and in the user's folder
constexpr std::size_t mostBytes = std::size_t{64} << 20;

bool isDisc(const Prefab& prefab) {
    return prefab.blueprint.particles.size() == 1 && prefab.blueprint.particles[0].radius > 0;
}

void requireName(const std::string& texture) {
    if (!sulfur::scene::safeAssetName(texture))
        throw std::runtime_error(
            tr("\"{}\" is no name of a picture; allowed is a relative path of at most 200 bytes "
               "without \"..\"",
               {texture}));
}

// u and v as linear functions of the place: rows of coefficients for x, y and 1.
std::optional<Eigen::Matrix<double, 2, 3>> affineOf(const sulfur::Blueprint& blueprint) {
    const auto& uv = blueprint.skin->uv;
    if (uv.size() != blueprint.particles.size() || uv.size() < 3) return std::nullopt;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    for (std::size_t i = 0; i < uv.size(); ++i) {
        const Eigen::Vector3d at(static_cast<double>(blueprint.particles[i].position.x()),
                                 static_cast<double>(blueprint.particles[i].position.y()), 1);
        normal += at * at.transpose();
        right += at * uv[i].cast<double>().transpose();
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
    if (!solver.isInvertible()) return std::nullopt;
    return solver.solve(right).transpose();
}

std::string loweredEnding(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

}  // namespace

std::array<Point, 4> SkinMapping::corners() const {
    const Eigen::Rotation2Dd turned(angle);
    const Point half = size / 2;
    return {
        centre + turned * Point(-half.x(), -half.y()), centre + turned * Point(half.x(), -half.y()),
        centre + turned * Point(half.x(), half.y()), centre + turned * Point(-half.x(), half.y())};
}

std::string skinOf(const Prefab& prefab) {
    return prefab.blueprint.skin ? prefab.blueprint.skin->texture : "";
}

// The gradients of u and v tell size and turn of the picture.
std::optional<SkinMapping> mappingOf(const Prefab& prefab) {
    if (!prefab.blueprint.skin) return std::nullopt;
    const auto affine = affineOf(prefab.blueprint);
    if (!affine) return std::nullopt;
    const Point u = affine->row(0).head<2>().transpose();
    const Point v = affine->row(1).head<2>().transpose();
    if (u.norm() < 1e-9 || v.norm() < 1e-9) return std::nullopt;
    SkinMapping mapping;
    mapping.size = {1 / u.norm(), 1 / v.norm()};
    mapping.angle = std::atan2(u.y(), u.x());
    // v points down: upright it falls from the lower to the upper edge.
    if (sulfur::cross(u, v) > 0) mapping.size.y() = -mapping.size.y();
    Eigen::Matrix2d linear;
    linear << u.x(), u.y(), v.x(), v.y();
    const Eigen::FullPivLU<Eigen::Matrix2d> solver(linear);
    if (!solver.isInvertible()) return std::nullopt;
    mapping.centre = solver.solve(Point(0.5, 0.5) - Point(affine->col(2)));
    return mapping;
}

bool canWear(const Prefab& prefab) {
    return isDisc(prefab) || !quaoar::trianglesOf(prefab.blueprint).empty();
}

void wear(Prefab& prefab, const std::string& texture) {
    requireName(texture);
    if (!canWear(prefab))
        throw std::runtime_error(
            tr("\"{}\" has no inside on which a picture could lie", {prefab.blueprint.name}));
    sulfur::Skin skin = sulfur::scene::fitSkin(prefab.generator, prefab.blueprint, texture);
    // Shapes with a fitted skin say no more than its name in files.
    prefab.skinFitted = !skin.triangles.empty() || isDisc(prefab);
    if (prefab.generator.index() == 0) prefab.skinFitted = false;
    if (!prefab.skinFitted) skin.triangles = quaoar::trianglesOf(prefab.blueprint);
    prefab.blueprint.skin = std::move(skin);
}

void setMapping(Prefab& prefab, const SkinMapping& mapping) {
    if (!prefab.blueprint.skin) throw std::runtime_error("the body wears no skin");
    for (const double side : {mapping.size.x(), mapping.size.y()})
        if (!(std::abs(side) >= SkinLimits::leastSize && std::abs(side) <= SkinLimits::mostSize))
            throw std::runtime_error(
                tr("a picture is {} m large; allowed is 0.02 to 500", {fixed(std::abs(side), 3)}));
    sulfur::Skin& skin = *prefab.blueprint.skin;
    const Eigen::Rotation2Dd back(-mapping.angle);
    std::vector<Vec2> uv;
    for (const auto& particle : prefab.blueprint.particles) {
        const Point local = back * (particle.position.cast<double>() - mapping.centre);
        const Vec2 at(static_cast<Real>(local.x() / mapping.size.x() + 0.5),
                      static_cast<Real>(0.5 - local.y() / mapping.size.y()));
        if (!(at.cwiseAbs().maxCoeff() <= 100))
            throw std::runtime_error("the picture lies too far from the body for its size");
        uv.push_back(at);
    }
    skin.uv = std::move(uv);
    if (skin.triangles.empty()) skin.triangles = quaoar::trianglesOf(prefab.blueprint);
    prefab.skinFitted = false;
}

void undress(Prefab& prefab) {
    prefab.blueprint.skin.reset();
    prefab.skinFitted = false;
}

bool canWear(const Document& document, BodyId body) {
    const std::string id = document.idOf(body);
    return !id.empty() && canWear(document.plan().prefab(document.plan().body(id).blueprint));
}

void wearAll(Document& document, std::span<const BodyId> bodies, const std::string& texture) {
    requireName(texture);
    std::vector<BodyId> able;
    for (const BodyId body : bodies)
        if (canWear(document, body)) able.push_back(body);
    if (able.empty())
        throw std::runtime_error(
            "nothing that is selected has an inside on which a picture could "
            "lie; choose a solid or a soft body");
    document.change(able, [&](Prefab& prefab) { wear(prefab, texture); });
}

void undressAll(Document& document, std::span<const BodyId> bodies) {
    document.change(bodies, [](Prefab& prefab) { undress(prefab); });
}

// --- files -----------------------------------------------------------------------------------

bool isPicture(const fs::path& file) {
    const std::string ending = loweredEnding(file);
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".svg";
}

SkinStore::SkinStore(fs::path own, std::vector<fs::path> programs)
    : own_(std::move(own)), programs_(std::move(programs)) {}

fs::path SkinStore::find(const std::string& texture, const fs::path& sceneFolder) const {
    if (!sulfur::scene::safeAssetName(texture)) return {};
    std::vector<fs::path> folders;
    if (!sceneFolder.empty()) folders.push_back(sceneFolder);
    folders.push_back(own_);
    folders.insert(folders.end(), programs_.begin(), programs_.end());
    std::error_code error;
    for (const fs::path& folder : folders)
        if (fs::is_regular_file(folder / texture, error)) return folder / texture;
    return {};
}

std::string SkinStore::adopt(const fs::path& picture, const fs::path& sceneFolder) const {
    if (!isPicture(picture))
        throw std::runtime_error(
            tr("{} is no picture; allowed are PNG, JPEG and SVG", {picture.filename().string()}));
    std::vector<std::byte> bytes;
    try {
        // What cannot be drawn is refused here.
        if (loweredEnding(picture) == ".svg")
            atlax::loadSvg(picture, {64, 64});
        else
            atlax::loadImage(picture);
        bytes = atlax::readBytes(picture, mostBytes);
    } catch (const atlax::Error& problem) {
        throw std::runtime_error(problem.what());
    }
    std::error_code error;
    if (!sceneFolder.empty()) {
        const std::string below = fs::relative(picture, sceneFolder, error).generic_string();
        if (!error && sulfur::scene::safeAssetName(below)) return below;
    }
    // One name for one content: another picture of this name gets a number.
    const std::string stem = picture.stem().string(), ending = loweredEnding(picture);
    for (int n = 1;; ++n) {
        const std::string name =
            std::string(skinFolder) + "/" + stem + (n > 1 ? "-" + std::to_string(n) : "") + ending;
        requireName(name);
        const fs::path file = own_ / name;
        try {
            if (!fs::exists(file, error))
                atlax::writeFileAtomic(file, bytes);
            else if (atlax::readBytes(file, mostBytes) != bytes)
                continue;
        } catch (const atlax::Error& problem) {
            throw std::runtime_error(problem.what());
        }
        return name;
    }
}

std::vector<std::string> SkinStore::copyBeside(const sulfur::scene::Scene& scene,
                                               const fs::path& sceneFolder) const {
    std::vector<std::string> problems;
    std::set<std::string> textures;
    for (const Prefab& prefab : scene.blueprints)
        if (const std::string texture = skinOf(prefab); !texture.empty()) textures.insert(texture);
    std::error_code error;
    for (const std::string& texture : textures) {
        if (!sulfur::scene::safeAssetName(texture)) continue;
        const fs::path to = sceneFolder / texture, from = own_ / texture;
        if (fs::exists(to, error) || !fs::is_regular_file(from, error)) continue;
        try {
            atlax::writeFileAtomic(to, atlax::readBytes(from, mostBytes));
        } catch (const atlax::Error& problem) {
            problems.emplace_back(problem.what());
        }
    }
    return problems;
}

}  // namespace sulfurchamber
