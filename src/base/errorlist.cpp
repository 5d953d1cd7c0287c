#include "base/errorlist.h"

#include "base/limits.h"

#include <fmt/ranges.h>

namespace dsphere {

void ErrorList::add(std::string message) {
    if (messages_.size() < limits::kReportedErrors)
        messages_.push_back(std::move(message));
    else
        more_ = true;
}

void ErrorList::throwIfAny() const {
    if (messages_.empty()) return;
    std::string all = fmt::format("{}", fmt::join(messages_, "\n"));
    if (more_) all += fmt::format("\nmore errors follow; these are the first {}", messages_.size());
    throw Error(ExitCode::InvalidInput, all);
}

}  // namespace dsphere
