// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/told_error.h"

namespace dsc {

namespace {

enum class Kind : std::uint8_t { input, file, invariant, other };

} // namespace

void write_error(MessageWriter& message, const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const InputError& input) {
        message.raw(Kind::input);
        message.text(input.problem());
        message.text(input.where());
        message.text(input.value());
        message.text(input.allowed());
    } catch (const FileError& file) {
        message.raw(Kind::file);
        message.text(file.path());
        message.text(std::string(file.what()).substr(file.path().size() + 2)); // less "path: "
    } catch (const InvariantError& invariant) {
        message.raw(Kind::invariant);
        message.text(invariant.what());
    } catch (const std::exception& other) {
        message.raw(Kind::other);
        message.text(other.what());
    } catch (...) {
        message.raw(Kind::other);
        message.text("an error that is no std::exception");
    }
}

std::exception_ptr read_error(std::span<const std::byte> bytes) {
    MessageReader message(bytes);
    const Kind kind = message.one<Kind>();
    const std::string first = message.text();
    switch (kind) {
    case Kind::input: {
        const std::string where = message.text();
        const std::string value = message.text();
        return std::make_exception_ptr(
            InputError({.what = first, .where = where, .value = value, .allowed = message.text()}));
    }
    case Kind::file: return std::make_exception_ptr(FileError(message.text(), first));
    case Kind::invariant: return std::make_exception_ptr(InvariantError(first));
    case Kind::other: break;
    }
    return std::make_exception_ptr(std::runtime_error(first));
}

} // namespace dsc
