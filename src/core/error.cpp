#include "core/error.hpp"

namespace starling {

namespace {

std::string describe(const Problem& p)
{
    std::string where = p.file;
    if (p.line > 0) where += ":" + std::to_string(p.line);
    if (!p.key.empty()) where += (where.empty() ? "" : ": ") + p.key;
    return where.empty() ? p.message : where + ": " + p.message;
}

std::string describe(const std::vector<Problem>& problems)
{
    std::string text;
    for (const Problem& p : problems) text += (text.empty() ? "" : "\n") + describe(p);
    return text;
}

} // namespace

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(describe(problems)), problems_(std::move(problems))
{
}

InputError::InputError(const std::string& message)
    : InputError(std::vector<Problem>{{"", 0, "", message}})
{
}

NumericalError::NumericalError(const std::string& what_when_and_where, const std::string& remedy,
                               const Breakdown& breakdown)
    : std::runtime_error(what_when_and_where + "\n  try: " + remedy), breakdown_(breakdown)
{
}

NumericalError::NumericalError(const NumericalError& e, const std::string& line)
    : std::runtime_error(std::string(e.what()) + "\n  " + line), breakdown_(e.breakdown_)
{
}

} // namespace starling
