#include <gtest/gtest.h>

#include <random>

#include "case_text.hpp"
#include "config/case_keys.hpp"
#include "config/read_case.hpp"
#include "config/shipped_cases.hpp"
#include "core/error.hpp"

namespace starling {
namespace {

/// Reads anything; a case or an InputError with at least one complete problem are both fine.
void expect_case_or_problems(std::string_view text, const std::vector<std::string>& overrides = {})
{
    try {
        const Case c = read_case_text(text, "fuzz", overrides);
        EXPECT_GT(c.grid.spacing, 0);
        EXPECT_GT(c.tube.length, 0);
    } catch (const InputError& e) {
        EXPECT_FALSE(e.problems().empty());
        for (const Problem& p : e.problems()) EXPECT_FALSE(p.message.empty());
    }
}

std::vector<std::string> seeds()
{
    std::vector<std::string> texts = {std::string(test::good_case),
                                      std::string(test::good_si_case)};
    for (const ShippedCase& c : shipped_cases()) texts.emplace_back(c.text);
    return texts;
}

TEST(Fuzz, TruncationAtAnyByteIsACaseOrAnInputError)
{
    for (const std::string& text : seeds())
        for (std::size_t length = 0; length <= text.size(); ++length)
            expect_case_or_problems(std::string_view(text).substr(0, length));
}

TEST(Fuzz, RandomBytesAreACaseOrAnInputError)
{
    std::mt19937_64 random(20240607);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const std::vector<std::string> texts = seeds();
    for (int n = 0; n < 6000; ++n) {
        std::string text = texts[below(texts.size())];
        for (std::size_t edits = 1 + below(8); edits > 0; --edits) {
            const std::size_t at = below(text.size() - 1);
            if (below(4) == 0)
                text.erase(at, 1 + below(6));
            else if (below(3) == 0)
                text.insert(at, text.substr(below(text.size()), below(20)));
            else
                text[at] = static_cast<char>(below(256));
        }
        expect_case_or_problems(text);
    }
}

TEST(Fuzz, HostileValuesOfEveryKeyAreACaseOrAnInputError)
{
    const char* values[] = {"nan",
                            "-inf",
                            "inf",
                            "0",
                            "-0.0",
                            "-1",
                            "1e308",
                            "-1e308",
                            "5e-324",
                            "9223372036854775807",
                            "-9223372036854775808",
                            "true",
                            "\"\"",
                            "\"1e4000 m\"",
                            "1e-4000 Pa",
                            "1e19 m",
                            "1e-19 m",
                            "1e19 kg/m^3",
                            "1e-19 Pa s",
                            "1e19 Pa",
                            "1e-19 m/s",
                            "1e-19 N/m",
                            "5 furlongs",
                            "[]",
                            "[[[]]]",
                            "[1,1,1]",
                            "[1000000,1000000,1000000]",
                            "[9223372036854775807,1,1]",
                            "{}",
                            "1979-05-27",
                            "07:32:00",
                            "'''",
                            "\"",
                            "=",
                            "#",
                            "[",
                            "auto",
                            "si",
                            "m^9^9",
                            "1 m^9*m^9*m^9"};
    for (std::string_view seed : {test::good_case, test::good_si_case})
        for (const KeyRule& rule : case_keys())
            for (const char* value : values)
                expect_case_or_problems(seed, {rule.name() + "=" + value});
}

TEST(Fuzz, DeepNestingIsAnInputError)
{
    for (const char* open : {"[", "{a="})
        for (int depth : {10, 1000, 100000}) {
            std::string text = "[fluid]\nreynolds = ";
            for (int n = 0; n < depth; ++n) text += open;
            EXPECT_THROW(read_case_text(text, "fuzz"), InputError);
        }
}

} // namespace
} // namespace starling
