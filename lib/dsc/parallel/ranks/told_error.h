// SPDX-License-Identifier: MIT
// Errors as bytes, so that what is thrown on one rank can be thrown on all.
#pragma once

#include "dsc/parallel/ranks/message.h"

#include <exception>

namespace dsc {

/// Writes the type and the text of an error; types that are not of the library count as
/// std::runtime_error.
void write_error(MessageWriter& message, const std::exception_ptr& error);

/// The error that was written, of its type and with its text.
[[nodiscard]] std::exception_ptr read_error(std::span<const std::byte> bytes);

} // namespace dsc
