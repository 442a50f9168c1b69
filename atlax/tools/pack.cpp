// atlax_pack: makes, lists and unpacks packs, the compressed folders that atlax::FileSystem mounts.
#include <CLI/CLI.hpp>
#include <atlax/pack.hpp>
#include <cstdio>
#include <exception>

namespace {

int list(const std::string& file) {
    const atlax::Pack pack = atlax::Pack::open(file);
    pack.verify();
    std::uint64_t size = 0, packed = 0;
    for (const atlax::PackEntry& entry : pack.entries()) {
        std::printf("%12llu  %12llu  %s\n", static_cast<unsigned long long>(entry.size),
                    static_cast<unsigned long long>(entry.packedSize), entry.name.c_str());
        size += entry.size;
        packed += entry.packedSize;
    }
    std::printf("%12llu  %12llu  %zu files\n", static_cast<unsigned long long>(size),
                static_cast<unsigned long long>(packed), pack.entries().size());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Makes, lists and unpacks packs: compressed folders for programs on atlax.");
    app.set_version_flag("--version", ATLAX_VERSION);
    app.require_subcommand(1);
    std::string folder, file;
    CLI::App* pack = app.add_subcommand("pack", "Pack every file below a folder");
    pack->add_option("folder", folder, "what is packed")->required();
    pack->add_option("pack", file, "the pack that is written")->required();
    CLI::App* unpack = app.add_subcommand("unpack", "Unpack a pack, once it was verified");
    unpack->add_option("pack", file, "the pack that is read")->required();
    unpack->add_option("folder", folder, "where its files go")->required();
    CLI::App* show = app.add_subcommand("list", "Verify a pack and print size, packed size, name");
    show->add_option("pack", file, "the pack that is read")->required();
    CLI11_PARSE(app, argc, argv);
    try {
        if (*show) return list(file);
        const std::size_t files =
            *pack ? atlax::makePack(folder, file) : atlax::unpack(atlax::Pack::open(file), folder);
        std::printf("%s %zu files\n", *pack ? "packed" : "unpacked", files);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "atlax_pack: %s\n", error.what());
        return 1;
    }
}
