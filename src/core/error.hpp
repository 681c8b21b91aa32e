#pragma once
/// The kinds of failure a user can meet; `app` maps them to exit codes.
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace starling {

/// One thing wrong with an input: where it stands, what it is, what is allowed.
struct Problem {
    std::string file;    ///< file name, or "--set" for a command-line override
    int line = 0;        ///< 1-based; 0 when the problem has no line (missing key, whole file)
    std::string key;     ///< dotted key such as "wall.law"; may be empty
    std::string message; ///< what is wrong, what is allowed, the nearest valid name
};

/// Bad input, all problems of it at once (exit code 2; nothing has been written).
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Problem> problems);
    explicit InputError(const std::string& message);

    const std::vector<Problem>& problems() const { return problems_; }

private:
    std::vector<Problem> problems_;
};

/// What a program can use of a breakdown; the message is for people.
struct Breakdown {
    std::optional<Vec3> place;       ///< where it began (solver units)
    bool shorter_step_helps = false; ///< false: of the geometry, which a shorter step meets again
};

/// The computation cannot go on (exit code 3): what happened, with when and where in the units of
/// the case where it has a time and a place, and what to try.
class NumericalError : public std::runtime_error {
public:
    NumericalError(const std::string& what_when_and_where, const std::string& remedy,
                   const Breakdown& breakdown = {});

    /// The same with a line more.
    NumericalError(const NumericalError& e, const std::string& line);

    const Breakdown& breakdown() const { return breakdown_; }

private:
    Breakdown breakdown_;
};

} // namespace starling
