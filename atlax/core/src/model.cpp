#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/model.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>

#include "gltf_check.hpp"

namespace atlax {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

[[noreturn]] void refuseModel(const std::string& name, const std::string& reason) {
    throw Error(name + ": " + reason);
}

/// Files that a model may read: itself, and what lies in its folder or below.
class Files {
public:
    Files(fs::path folder, std::string self, std::span<const std::byte> bytes)
        : folder_(std::move(folder)), self_(std::move(self)), bytes_(bytes) {}

    /// The bytes of a file as the model names it; nothing when it may not be read.
    std::optional<std::span<const std::byte>> read(const std::string& name) {
        if (name == self_) return bytes_;
        if (const auto known = read_.find(name); known != read_.end()) return known->second;
        const fs::path path = fs::path(name).lexically_normal();
        const bool inside =
            !folder_.empty() && !path.empty() && path.is_relative() && *path.begin() != "..";
        if (!inside || read_.size() >= Model::mostParts) return {};
        try {
            const fs::path real = fs::weakly_canonical(folder_ / path);
            const fs::path root = fs::canonical(folder_);
            // A link may lead out.
            if (std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first !=
                root.end())
                return {};
            return read_.emplace(name, readBytes(real, Model::mostBytes)).first->second;
        } catch (const std::exception&) {
            return {};
        }
    }

private:
    fs::path folder_;
    std::string self_;
    std::span<const std::byte> bytes_;
    std::map<std::string, Bytes> read_;
};

class Stream final : public Assimp::IOStream {
public:
    explicit Stream(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::size_t Read(void* into, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
        if (whole > 0) std::memcpy(into, bytes_.data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        // Offsets from the end and backwards arrive as what unsigned numbers make of them.
        const std::size_t base = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? at_
                                                          : bytes_.size();
        const std::size_t to = base + offset;
        if (to > bytes_.size()) return aiReturn_FAILURE;
        at_ = to;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

class FileSystem final : public Assimp::IOSystem {
public:
    explicit FileSystem(Files& files) : files_(files) {}
    bool Exists(const char* name) const override { return files_.read(name).has_value(); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        const auto bytes = files_.read(name);
        return bytes ? new Stream(*bytes) : nullptr;  // Close deletes it
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    Files& files_;
};

std::array<float, 3> toArray(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

bool finite(const aiVector3D& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Color colorOf(const aiMaterial& material) {
    aiString name;
    // What a file without materials gets is grey there; here it is white, to be tinted.
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
        name == aiString(AI_DEFAULT_MATERIAL_NAME))
        return colors::white;
    aiColor4D color(1, 1, 1, 1);
    if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS)
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    const auto part = [](float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; };
    return {part(color.r), part(color.g), part(color.b), 1};
}

Image pictureOf(const aiScene& scene, const aiMaterial& material, Files& files,
                const std::string& name) {
    aiString path;
    if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &path) != aiReturn_SUCCESS &&
        material.GetTexture(aiTextureType_DIFFUSE, 0, &path) != aiReturn_SUCCESS)
        return {};
    if (const aiTexture* inside = scene.GetEmbeddedTexture(path.C_Str())) {
        if (inside->mHeight != 0) refuseModel(name, "holds a picture that is neither PNG nor JPEG");
        return decodeImage(
            std::as_bytes(std::span(reinterpret_cast<const char*>(inside->pcData), inside->mWidth)),
            name + " (a picture in it)");
    }
    const auto bytes = files.read(path.C_Str());
    if (!bytes)
        refuseModel(name, "names the picture \"" + std::string(path.C_Str()) +
                              "\", which is not in its folder or cannot be read");
    return decodeImage(*bytes, path.C_Str());
}

ModelPart partOf(const aiMesh& mesh, const std::string& name) {
    ModelPart part;
    part.vertices.reserve(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        ModelVertex v;
        if (!finite(mesh.mVertices[i])) refuseModel(name, "has a position that is not finite");
        v.position = toArray(mesh.mVertices[i]);
        if (mesh.HasNormals() && finite(mesh.mNormals[i])) v.normal = toArray(mesh.mNormals[i]);
        if (mesh.HasTextureCoords(0) && finite(mesh.mTextureCoords[0][i]))
            v.uv = {mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y};
        part.vertices.push_back(v);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;
        for (unsigned k = 0; k < 3; ++k) {
            if (face.mIndices[k] >= mesh.mNumVertices)
                refuseModel(name, "has a triangle with a corner that it does not have");
            part.indices.push_back(face.mIndices[k]);
        }
    }
    return part;
}

void checkLimits(const aiScene& scene, const std::string& name) {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        vertices += scene.mMeshes[i]->mNumVertices;
        faces += scene.mMeshes[i]->mNumFaces;
    }
    if (scene.mNumMeshes > Model::mostParts || vertices > Model::mostVertices ||
        faces > Model::mostVertices)
        refuseModel(name, "has more than " + std::to_string(Model::mostParts) + " parts or " +
                              std::to_string(Model::mostVertices) + " vertices or triangles");
}

void measure(Model& model) {
    model.min.fill(std::numeric_limits<float>::max());
    model.max.fill(std::numeric_limits<float>::lowest());
    for (const ModelPart& part : model.parts)
        for (const ModelVertex& v : part.vertices)
            for (std::size_t k = 0; k < 3; ++k) {
                model.min[k] = std::min(model.min[k], v.position[k]);
                model.max[k] = std::max(model.max[k], v.position[k]);
            }
}

Model convert(const aiScene& scene, Files& files, const std::string& name) {
    checkLimits(scene, name);
    Model model;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        ModelPart part = partOf(*scene.mMeshes[i], name);
        if (part.indices.empty()) continue;
        const aiMaterial& material = *scene.mMaterials[scene.mMeshes[i]->mMaterialIndex];
        part.color = colorOf(material);
        part.picture = pictureOf(scene, material, files, name);
        model.parts.push_back(std::move(part));
    }
    if (model.parts.empty()) refuseModel(name, "has no triangles");
    measure(model);
    return model;
}

std::string kindOf(const std::string& name) {
    std::string ending = fs::path(name).extension().string();
    for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (ending != ".gltf" && ending != ".glb" && ending != ".obj")
        refuseModel(name, "is no model that can be read; allowed are .gltf, .glb and .obj");
    return ending;
}

/// Leaves only the readers of OBJ and glTF 2. Otherwise assimp looks at the content and hands it to
/// any of its many readers, whatever the name says.
void keepOurReaders(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string_view name = importer.GetImporterInfo(i)->mName;
        if (name == "glTF2 Importer" || name == "Wavefront Object Importer") continue;
        Assimp::BaseImporter* other = importer.GetImporter(i);
        importer.UnregisterLoader(other);
        delete other;  // ours from here on
    }
}

Model import(std::span<const std::byte> bytes, const fs::path& folder, const std::string& name) {
    const std::string self = "model" + kindOf(name);
    if (bytes.empty()) refuseModel(name, "is empty");
    if (bytes.size() > Model::mostBytes) refuseModel(name, "is larger than 64 MiB");
    if (!self.ends_with(".obj")) detail::checkGltf(bytes, name);
    Files files(folder, self, bytes);
    Assimp::Importer importer;
    keepOurReaders(importer);
    importer.SetIOHandler(new FileSystem(files));  // the importer owns it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    constexpr unsigned steps = aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                               aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices |
                               aiProcess_SortByPType | aiProcess_FlipUVs |
                               aiProcess_ValidateDataStructure;
    const aiScene* scene = nullptr;
    try {
        scene = importer.ReadFile(self, steps);
    } catch (const std::exception& error) {
        refuseModel(name, std::string("cannot be read: ") + error.what());
    }
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
        refuseModel(name, std::string("cannot be read: ") + importer.GetErrorString());
    return convert(*scene, files, name);
}

}  // namespace

Model loadModel(const fs::path& file) {
    kindOf(file.string());
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    return import(readBytes(file, Model::mostBytes), folder, file.string());
}

Model decodeModel(std::span<const std::byte> bytes, const std::string& name) {
    return import(bytes, {}, name);
}

}  // namespace atlax
