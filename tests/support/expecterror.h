#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace dsphere::test {

/// Runs `body`, which must throw an Error of that code, and returns its message ("" and a failed test otherwise).
template <typename Body>
std::string messageOf(ExitCode code, Body&& body) {
    try {
        body();
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(code)) << error.what();
        EXPECT_STRNE(error.what(), "");
        return error.what();
    } catch (const std::exception& other) {
        ADD_FAILURE() << "threw something other than Error: " << other.what();
        return "";
    }
    ADD_FAILURE() << "threw nothing";
    return "";
}

/// Whether `text` holds `part`, with both shown when not.
inline ::testing::AssertionResult holds(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "\"" << text << "\" lacks \"" << part << "\"";
}

/// `body` must throw an Error of that code whose message holds `part`.
template <typename Body>
void expectError(ExitCode code, const std::string& part, Body&& body) {
    EXPECT_TRUE(holds(messageOf(code, body), part));
}

}  // namespace dsphere::test
