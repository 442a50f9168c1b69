// Recordings as short texts, for the clipboard.
#pragma once

#include <cstddef>
#include <quaoar/recording.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quaoar {

/// The recording as one line of letters and digits, some 1 to 3 kB for a run of half a minute:
/// "quaoar-replay:" and, in base64, a zstd frame of version 1 of a binary format, in which times,
/// buttons and changes of the aim stand each in a column of their own.
std::string shareText(const Recording& recording);

/// The opposite. What stands before "quaoar-replay:", and spaces and line ends within, are skipped.
/// Throws RecordingError with one sentence.
Recording parseShareText(std::string_view text);

/// The binary format within, before it is compressed, and back. The latter throws RecordingError.
std::vector<std::byte> shareBytes(const Recording& recording);
Recording parseShareBytes(std::span<const std::byte> bytes);

}  // namespace quaoar
