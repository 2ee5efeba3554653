// SPDX-License-Identifier: MIT
#include "replay/sealed_file.h"

#include "dsc/base/error.h"
#include "dsc/io/part_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace dsc {

namespace {

constexpr std::size_t header_size = 32;

struct Header {
    std::array<char, 8> name{};
    std::uint32_t version = 0;
    std::uint32_t reserved = 0;
    std::uint64_t size = 0;
    std::uint64_t sum = 0;
};
static_assert(sizeof(Header) == header_size);

std::array<char, 8> padded(const SealedKind& kind) {
    std::array<char, 8> name{};
    if (kind.name.empty() || kind.name.size() > name.size()) {
        throw InputError({.what = "the name of a file kind has the wrong length",
                          .where = "SealedKind",
                          .value = "'" + kind.name + "'",
                          .allowed = "1 to 8 bytes"});
    }
    kind.name.copy(name.data(), name.size());
    return name;
}

std::string read_all(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw FileError("cannot be read", path, error ? error.value() : EINVAL);
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string bytes(error ? 0 : size, '\0');
    if (error || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        throw FileError("cannot be read", path, errno);
    }
    return bytes;
}

// FNV-1a over words of eight bytes and what remains.
std::uint64_t checksum(const std::string& bytes) {
    constexpr std::uint64_t prime = 0x100000001b3U;
    std::uint64_t sum = 0xcbf29ce484222325U;
    std::size_t at = 0;
    for (; at + 8 <= bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, 8);
        sum = (sum ^ word) * prime;
        sum ^= sum >> 32U; // the product alone carries no bit downwards
    }
    for (; at < bytes.size(); ++at) {
        sum = (sum ^ static_cast<unsigned char>(bytes[at])) * prime;
    }
    return sum;
}

} // namespace

std::string sealed(const SealedKind& kind, const std::string& bytes) {
    const Header header{.name = padded(kind),
                        .version = kind.version,
                        .size = bytes.size(),
                        .sum = checksum(bytes)};
    std::string whole(header_size, '\0');
    std::memcpy(whole.data(), &header, header_size);
    return whole += bytes;
}

std::string unsealed(std::string bytes, const SealedKind& kind, const std::string& name) {
    Header header;
    if (bytes.size() < header_size) {
        throw FileError("too short for a file of kind '" + kind.name + "'", name);
    }
    std::memcpy(&header, bytes.data(), header_size);
    if (header.name != padded(kind)) {
        throw FileError("not a file of kind '" + kind.name + "'", name);
    }
    if (header.version != kind.version) {
        throw FileError("version " + std::to_string(header.version) + " of its layout, not " +
                            std::to_string(kind.version) +
                            ": read it with the program that wrote it, or run again",
                        name);
    }
    bytes.erase(0, header_size);
    if (bytes.size() != header.size) {
        throw FileError("incomplete: " + std::to_string(bytes.size()) + " bytes of " +
                            std::to_string(header.size),
                        name);
    }
    if (header.reserved != 0 || checksum(bytes) != header.sum) {
        throw FileError("damaged: the checksum does not match", name);
    }
    return bytes;
}

void write_sealed(const std::string& path, const SealedKind& kind, const std::string& bytes) {
    const std::string whole = sealed(kind, bytes);
    PartFile file(path);
    file << whole;
    file.commit(PartFile::Until::on_disk);
}

std::string read_sealed(const std::string& path, const SealedKind& kind) {
    return unsealed(read_all(path), kind, path);
}

} // namespace dsc
