#include <gtest/gtest.h>

#include <atlax/arguments.hpp>

namespace {

TEST(Arguments, numbersAreWholeFiniteAndInTheirRange) {
    const auto check = atlax::between(0, 3600);
    for (const char* text : {"0", "1", "3600", "2.5", "1e3", "0.0001"})
        EXPECT_EQ(check(text), "") << text;
    for (const char* text : {"nan", "NaN", "-nan", "inf", "-1", "3600.1", "1e99", "1e999", "", " ",
                             "1x", "0x10", "-0.1"})
        EXPECT_NE(check(text), "") << text;
    EXPECT_EQ(check("nan"), "\"nan\" is no number from 0 to 3600");
}

}  // namespace
