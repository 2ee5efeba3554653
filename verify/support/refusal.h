// SPDX-License-Identifier: MIT
// Checks of refusals and their messages.
#pragma once

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace dsc::test {

/// The message of the InputError that `act` throws; empty if it throws none.
template <class Act>
std::string refusal(Act act) {
    try {
        act();
    } catch (const InputError& error) {
        EXPECT_FALSE(error.value().empty() || error.allowed().empty()) << error.what();
        return error.what();
    }
    return "";
}

/// Checks that `act` throws an InputError for this place, whose message contains the words.
template <class Act>
void expect_refusal(Act act, const std::string& where, const std::string& words = "") {
    const std::string sentence = refusal(act);
    EXPECT_TRUE(sentence.starts_with(where + ": ") && sentence.find(words) != std::string::npos)
        << "expected: " << where << ": " << words << "\nrefused: " << sentence;
}

} // namespace dsc::test
