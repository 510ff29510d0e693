// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

// The matchers that tests use most, by their own names in every namespace of ours.
namespace gloam {

using testing::AllOf;
using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;
using testing::StartsWith;
using testing::ThrowsMessage;

}  // namespace gloam

namespace gloam::test {

// EXPECT_THROW with a look at the message.
template <class Error, class Action>
void expect_error(Action action, std::initializer_list<const char*> parts) {
    try {
        action();
        ADD_FAILURE() << "nothing thrown";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        for (const char* part : parts)
            EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
    }
}

}  // namespace gloam::test
