// Writing, reading and hashing state by one list of its fields.
//
// Each part of the state has a member `archive(Archive&)` that names its fields in order; what
// happens to them is the archive's business, so that a snapshot cannot forget what the hash knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <sulfur/error.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/bend.hpp"

namespace sulfur::detail {

/// Types that name their fields themselves.
template <class T>
concept Archivable = requires(T value, int& archive) {
    value.archive(archive);
};

/// Types whose bytes may be copied as they are: they have no padding, whose bytes would be chance.
/// Eigen's small unaligned vectors are such, although their user-provided constructors hide it.
template <class T>
struct IsPlain : std::bool_constant<std::is_trivially_copyable_v<T> && !Archivable<T>> {};
template <class S, int R, int C, int O>
struct IsPlain<Eigen::Matrix<S, R, C, O>> : std::bool_constant<(R > 0 && C > 0)> {};

template <>
struct IsPlain<std::pair<std::uint32_t, std::uint32_t>> : std::true_type {};

template <class Archive, class T>
void archiveEach(Archive& a, std::vector<T>& list) {
    for (T& item : list) item.archive(a);
}

class Writer {
public:
    template <class T>
    void operator()(T& value) {
        if constexpr (IsPlain<T>::value)
            bytes(&value, sizeof(T));
        else
            value.archive(*this);
    }
    template <class T>
    void operator()(std::vector<T>& list) {
        std::uint64_t size = list.size();
        (*this)(size);
        if constexpr (IsPlain<T>::value)
            bytes(list.data(), list.size() * sizeof(T));
        else
            archiveEach(*this, list);
    }
    void operator()(std::string& text) {
        std::uint64_t size = text.size();
        (*this)(size);
        bytes(text.data(), text.size());
    }
    template <class T>
    void operator()(std::optional<T>& value) {
        bool present = value.has_value();
        (*this)(present);
        if (present) (*this)(*value);
    }

    std::vector<std::byte> result;

private:
    void bytes(const void* from, std::size_t count) {
        const auto* begin = static_cast<const std::byte*>(from);
        result.insert(result.end(), begin, begin + count);
    }
};

class Reader {
public:
    explicit Reader(const std::vector<std::byte>& source) : source_(source) {}

    /// A byte that is neither 0 nor 1 is no bool, and must not become one.
    void operator()(bool& value) {
        std::uint8_t byte = 0;
        bytes(&byte, sizeof byte);
        if (byte > 1)
            throw Error(ErrorCode::badSnapshot,
                        "the snapshot is damaged; allowed is one that World::snapshot made");
        value = byte != 0;
    }
    template <class T>
    void operator()(T& value) {
        if constexpr (IsPlain<T>::value)
            bytes(&value, sizeof(T));
        else
            value.archive(*this);
    }
    template <class T>
    void operator()(std::vector<T>& list) {
        const std::size_t size = count(IsPlain<T>::value ? sizeof(T) : 1);
        list.clear();
        list.resize(size);
        if constexpr (IsPlain<T>::value)
            bytes(list.data(), list.size() * sizeof(T));
        else
            archiveEach(*this, list);
    }
    void operator()(std::string& text) {
        text.resize(count(1));
        bytes(text.data(), text.size());
    }
    template <class T>
    void operator()(std::optional<T>& value) {
        bool present = false;
        (*this)(present);
        value.reset();
        if (present) (*this)(value.emplace());
    }

    bool finished() const { return at_ == source_.size(); }

private:
    /// Reads a count and refuses one that the remaining bytes cannot hold.
    std::size_t count(std::size_t itemSize) {
        std::uint64_t size = 0;
        (*this)(size);
        if (size > (source_.size() - at_) / itemSize) truncated();
        return static_cast<std::size_t>(size);
    }
    void bytes(void* to, std::size_t count) {
        if (count > source_.size() - at_) truncated();
        if (count > 0) std::memcpy(to, source_.data() + at_, count);
        at_ += count;
    }
    [[noreturn]] static void truncated() {
        throw Error(ErrorCode::badSnapshot,
                    "the snapshot ends too early; allowed is one that "
                    "World::snapshot made");
    }

    const std::vector<std::byte>& source_;
    std::size_t at_ = 0;
};

/// Mixes 64-bit words into a hash (multiply and shift, after the finaliser of MurmurHash3).
class Hasher {
public:
    template <class T>
    void operator()(T& value) {
        if constexpr (IsPlain<T>::value)
            bytes(&value, sizeof(T));
        else
            value.archive(*this);
    }
    template <class T>
    void operator()(std::vector<T>& list) {
        mix(list.size());
        if constexpr (IsPlain<T>::value)
            bytes(list.data(), list.size() * sizeof(T));
        else
            archiveEach(*this, list);
    }
    /// What is not there has no bits.
    template <class T>
    void operator()(std::optional<T>& value) {
        bool present = value.has_value();
        (*this)(present);
        if (present) (*this)(*value);
    }

    /// Rolling resistance only where there is some, so that worlds without it hash as they did.
    void operator()(Material& m) {
        const Real common[] = {m.staticFriction, m.kineticFriction, m.restitution, m.surfaceSpeed};
        bytes(common, sizeof common);
        if (m.rollingResistance != 0) (*this)(m.rollingResistance);
    }
    void operator()(std::vector<Material>& list) {
        mix(list.size());
        for (Material& material : list) (*this)(material);
    }
    /// Only those that are bent, for the same reason.
    void operator()(std::vector<Bend>& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].angle == 0) continue;
            mix(i);
            (*this)(list[i].angle);
        }
    }

    std::uint64_t result = 0x9e3779b97f4a7c15u;

    void bytes(const void* from, std::size_t count) {
        const auto* at = static_cast<const unsigned char*>(from);
        for (; count >= 8; count -= 8, at += 8) {
            std::uint64_t word;
            std::memcpy(&word, at, 8);
            mix(word);
        }
        std::uint64_t rest = count;
        for (std::size_t i = 0; i < count; ++i) rest = rest << 8 | at[i];
        if (count > 0) mix(rest);
    }

private:
    void mix(std::uint64_t word) {
        result ^= word;
        result ^= result >> 33;
        result *= 0xff51afd7ed558ccdu;
        result ^= result >> 33;
    }
};

}  // namespace sulfur::detail
