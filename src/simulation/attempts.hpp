#pragma once
/// Things to do one after the other, whatever becomes of the others.
#include <string>
#include <vector>

#include "core/error.hpp"

namespace starling {

class Attempts {
public:
    /// Calls `f` and takes note where it fails; a NumericalError is passed on.
    template <class F>
    void operator()(F f)
    {
        try {
            f();
        } catch (const NumericalError&) {
            throw;
        } catch (const std::exception& e) {
            failures_.emplace_back(e.what());
        }
    }

    /// Why things failed, in their order.
    const std::vector<std::string>& failures() const { return failures_; }

private:
    std::vector<std::string> failures_;
};

} // namespace starling
