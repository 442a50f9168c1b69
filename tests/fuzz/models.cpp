// Whatever bytes are handed over as a model, they are read or refused with atlax::Error, and what
// was read has finite positions and triangles of corners that it has. The first byte chooses the
// format.
#include <atlax/error.hpp>
#include <atlax/model.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

constexpr std::string_view samples[] = {
    "0v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\nusemtl a\nf 1/1/1 2/1/1 3/1/1\n",
    R"(1{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":
"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})",
};
constexpr const char* names[] = {"fuzz.obj", "fuzz.gltf", "fuzz.glb"};

void check(const atlax::Model& model) {
    if (model.parts.empty()) std::abort();
    for (const atlax::ModelPart& part : model.parts) {
        for (const std::uint32_t i : part.indices)
            if (i >= part.vertices.size()) std::abort();
        for (const atlax::ModelVertex& v : part.vertices)
            for (const float x : v.position)
                if (!std::isfinite(x)) std::abort();
    }
}

}  // namespace

// assimp 5.2 forgets the mesh that it is making when it refuses an OBJ file in the middle: less than
// the file's own size for each, and nobody can get at it from outside.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT: the sanitizer's name
    return "leak:libassimp";
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    const std::string_view sample = samples[seed % std::size(samples)];
    if (size < 8 && sample.size() <= most) {
        std::memcpy(data, sample.data(), sample.size());
        size = sample.size();
    }
    return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        check(atlax::decodeModel(std::as_bytes(std::span(data + 1, size - 1)), names[data[0] % 3]));
    } catch (const atlax::Error&) {
    }
    return 0;
}
