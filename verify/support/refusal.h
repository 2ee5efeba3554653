// SPDX-License-Identifier: MIT
// What is refused, and in which words.
#pragma once

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace dsc::test {

/// The sentence of the InputError that `act` throws; empty if it throws none.
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

/// `act` throws an InputError of this place, whose sentence has the words.
template <class Act>
void expect_refusal(Act act, const std::string& where, const std::string& words = "") {
    const std::string sentence = refusal(act);
    EXPECT_TRUE(sentence.starts_with(where + ": ") && sentence.find(words) != std::string::npos)
        << "expected: " << where << ": " << words << "\nrefused: " << sentence;
}

} // namespace dsc::test
