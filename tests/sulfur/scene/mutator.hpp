// Changes texts of JSON so that many of them stay JSON.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace sulfur::scene::testing {

class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::string mutate(std::string text) {
        const auto changes = 1 + below(4);
        for (std::size_t i = 0; i < changes && !text.empty(); ++i) change(text);
        return text;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void change(std::string& text) {
        static const std::vector<std::string> tokens{"null",        "true",
                                                     "-1",          "0",
                                                     "1e308",       "1e-320",
                                                     "4294967296",  "\"\"",
                                                     "{}",          "[]",
                                                     "[[]]",        "\"rigid\"",
                                                     "\"box\"",     "NaN",
                                                     ",",           "}",
                                                     "]",           "\"a\":",
                                                     "-0",          "0.5",
                                                     "\"\\ud800\"", "99999999999999999999"};
        const auto at = below(text.size());
        switch (below(12)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), below(40)));
                break;
            case 3:
                text.resize(at);
                break;
            case 4:
            case 5:
            case 6:
                replaceValue(text, at, tokens[below(tokens.size())]);
                break;
            default:
                changeDigit(text, at);
        }
    }

    void changeDigit(std::string& text, std::size_t at) {
        const auto digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
    }

    /// Puts a token in the place of what is there up to the next separator, so that most texts
    /// stay JSON.
    static void replaceValue(std::string& text, std::size_t at, const std::string& token) {
        const auto begin = text.find_first_of(":[,", at);
        if (begin == std::string::npos) return;
        const auto end = text.find_first_of(",]}", begin + 1);
        if (end == std::string::npos) return;
        text.replace(begin + 1, end - begin - 1, token);
    }

    std::mt19937_64 random_;
};

}  // namespace sulfur::scene::testing
