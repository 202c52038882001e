// SPDX-License-Identifier: MIT
// Layout (little endian): magic "SHKNCKP1", length of the body (u64), XXH3-128 of the body (16 bytes), body.
// Body: number of sections (u64), then for each: length of the name, name, item size, length in bytes, bytes.
#include "files/checkpoint.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>
#include <fstream>
#include <memory>

#include "files/checkpoint_file.hpp"
#include "files/checkpoint_layout.hpp"
#include "files/errors.hpp"

namespace shaken::files {

namespace {

using checkpoint_layout::header_size;
using checkpoint_layout::magic;

XXH128_canonical_t checksum(const void* bytes, std::size_t size) {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes, size));
    return canonical;
}

/// Walks the body; every length is checked against what is left, although the checksum has already passed.
class Cursor {
  public:
    Cursor(std::span<const std::byte> body, const std::string& path) : rest_(body), path_(path) {}
    std::uint64_t number() {
        const std::span<const std::byte> raw = bytes(sizeof(std::uint64_t));
        std::uint64_t value;
        std::memcpy(&value, raw.data(), sizeof value);
        return value;
    }
    std::span<const std::byte> bytes(std::uint64_t size) {
        if (size > rest_.size())
            throw Damaged(fmt::format("{}: damaged checkpoint: a section runs past the end", path_));
        const auto taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }

  private:
    std::span<const std::byte> rest_;
    const std::string& path_;
};

}  // namespace

void CheckpointWriter::put_bytes(std::string_view name, std::span<const std::byte> bytes, std::size_t item_size) {
    Section section{item_size, std::vector<std::byte>(bytes.begin(), bytes.end())};
    if (!sections_.emplace(std::string(name), std::move(section)).second) {
        throw std::logic_error(fmt::format("checkpoint section '{}' is written twice", name));
    }
}

void CheckpointWriter::put_text(std::string_view name, std::string_view text) {
    put(name, std::span<const char>(text.data(), text.size()));
}

void CheckpointWriter::commit(const std::filesystem::path& path) const {
    CheckpointFile file(path);
    for (const auto& [name, section] : sections_) file.put_bytes(name, section.bytes, section.item_size);
    file.commit();
}

std::uint64_t CheckpointWriter::hash() const {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    XXH3_64bits_reset(state.get());
    const auto add = [&](const void* bytes, std::size_t size) { XXH3_64bits_update(state.get(), bytes, size); };
    const auto add_number = [&](std::uint64_t value) { add(&value, sizeof value); };
    add_number(sections_.size());
    for (const auto& [name, section] : sections_) {
        add_number(name.size());
        add(name.data(), name.size());
        add_number(section.item_size);
        add_number(section.bytes.size());
        add(section.bytes.data(), section.bytes.size());
    }
    return XXH3_64bits_digest(state.get());
}

CheckpointReader::CheckpointReader(const std::filesystem::path& path) : path_(path.string()) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw NoInput(fmt::format("{}: no such checkpoint, or not readable", path_));
    const std::streamoff size = file.tellg();
    if (size < static_cast<std::streamoff>(header_size)) {
        throw Damaged(
            fmt::format("{}: damaged checkpoint: {} bytes, the header alone has {}", path_, size, header_size));
    }
    content_.resize(static_cast<std::size_t>(size));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(content_.data()), size);
    if (!file) throw NoInput(fmt::format("{}: cannot be read to its end", path_));

    if (std::memcmp(content_.data(), magic.data(), magic.size()) != 0) {
        throw Damaged(fmt::format("{}: not a checkpoint of this program (its first bytes differ)", path_));
    }
    std::uint64_t body_size;
    std::memcpy(&body_size, content_.data() + magic.size(), sizeof body_size);
    if (body_size != content_.size() - header_size) {
        throw Damaged(fmt::format("{}: damaged checkpoint: {} bytes of {} are there", path_,
                                  content_.size() - header_size, body_size));
    }
    const std::span<const std::byte> body = std::span(content_).subspan(header_size);
    const XXH128_canonical_t sum = checksum(body.data(), body.size());
    if (std::memcmp(&sum, content_.data() + magic.size() + sizeof body_size, sizeof sum) != 0) {
        throw Damaged(fmt::format("{}: damaged checkpoint: its checksum does not match its content", path_));
    }
    Cursor cursor(body, path_);
    const std::uint64_t count = cursor.number();
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto name = cursor.bytes(cursor.number());
        const std::uint64_t item_size = cursor.number();
        const auto bytes = cursor.bytes(cursor.number());
        sections_[std::string(reinterpret_cast<const char*>(name.data()), name.size())] = {item_size, bytes};
    }
}

std::string CheckpointReader::take_text(std::string_view name) const {
    const std::vector<char> characters = take<char>(name);
    return {characters.begin(), characters.end()};
}

std::span<const std::byte> CheckpointReader::take_bytes(std::string_view name, std::size_t item_size) const {
    const auto found = sections_.find(name);
    if (found == sections_.end()) throw Damaged(fmt::format("{}: the checkpoint has no section '{}'", path_, name));
    if (found->second.item_size != item_size) {
        throw Damaged(fmt::format("{}: section '{}' holds items of {} bytes, not {}: written by another version?",
                                  path_, name, found->second.item_size, item_size));
    }
    return found->second.bytes;
}

void CheckpointReader::expect_length(std::string_view name, std::size_t stored, std::size_t wanted) const {
    if (stored != wanted) {
        throw Damaged(fmt::format("{}: section '{}' holds {} items, not {}", path_, name, stored, wanted));
    }
}

void CheckpointReader::copy(std::span<const std::byte> from, void* to) { std::memcpy(to, from.data(), from.size()); }

}  // namespace shaken::files
