// What is not saved yet, kept for the case that the program ends without asking.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// Keeps unsaved edits of one running program in a file of its own, beside those of other windows.
///
/// One thread. What cannot be written is not kept; keep() says why.
class Recovery {
public:
    /// The folder is made when something is kept.
    explicit Recovery(std::filesystem::path folder);
    /// Removes the file: the program has ended as it should.
    ~Recovery();
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;

    /// Writes the plan if there are edits that are neither saved nor kept; removes it when all is
    /// saved. Returns "", or one sentence that says why that was not possible.
    std::string keep(const Document& document);

    /// What a program left that ended without asking.
    struct Left {
        std::filesystem::path kept;  ///< a scene file
        std::filesystem::path of;    ///< the file that was open; empty: none
    };
    /// Of programs that no longer run; the latest first. Never what a running one keeps.
    static std::vector<Left> left(const std::filesystem::path& folder);
    /// Removes what was left.
    static void discard(const Left& left);

private:
    void forget();

    std::filesystem::path folder_;
    std::filesystem::path file_;
    int lock_ = -1;
    std::uint64_t kept_ = 0;
};

}  // namespace sulfurchamber
