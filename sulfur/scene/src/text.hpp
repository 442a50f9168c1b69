// How a Document stores its values: one flat list, children linked by index.
#pragma once

#include <cstdint>
#include <string>
#include <sulfur/scene/document.hpp>
#include <vector>

namespace sulfur::scene {

struct Node::Text {
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Value {
        ValueType type = ValueType::null;
        bool truth = false;       ///< of a boolean
        std::uint32_t begin = 0;  ///< bytes of `source`, first
        std::uint32_t end = 0;    ///< and one behind the last
        std::uint32_t line = 0;   ///< counted from 0 within `source`
        std::uint32_t parent = none;
        std::uint32_t next = none;   ///< the parent's next child
        std::uint32_t first = none;  ///< first child
        std::uint32_t count = 0;     ///< of children
        std::uint32_t place = 0;     ///< among the parent's children
        std::uint32_t key = 0;       ///< index into `strings` when the parent is an object
        std::uint32_t string = 0;    ///< index into `strings` of a string's content
    };

    std::string source;
    Origin origin;
    std::vector<Value> values;
    std::vector<std::string> strings{std::string()};  ///< decoded; the first is empty
};

}  // namespace sulfur::scene
