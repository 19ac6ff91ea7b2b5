#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ossuary::index {

/// Appends numbers to a string of bytes, little-endian on every machine, floats by their bits.
class ByteWriter {
public:
    template <typename T>
    void put(T value) {
        static_assert(std::is_arithmetic_v<T>);
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if constexpr (std::endian::native == std::endian::big) {
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
                std::swap(raw[i], raw[sizeof(T) - 1 - i]);
            }
        }
        bytes_.append(raw, sizeof(T));
    }
    template <typename T>
    void put_all(std::span<const T> values) {
        bytes_.reserve(bytes_.size() + values.size_bytes());
        for (const T value : values) put(value);
    }
    /// A 32-bit length, then the bytes.
    void put_text(std::string_view text) {
        put(static_cast<std::uint32_t>(text.size()));
        bytes_.append(text);
    }
    void put_raw(std::string_view bytes) { bytes_.append(bytes); }
    /// Seven bits a byte, the lowest first; all but the last byte have the eighth bit.
    void put_varint(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(0x80 | (value & 0x7F));
        bytes_ += static_cast<char>(value);
    }
    /// A signed number: 0, -1, 1, -2 … as the varints 0, 1, 2, 3 …
    void put_signed(std::int64_t value) {
        put_varint((static_cast<std::uint64_t>(value) << 1) ^
                   static_cast<std::uint64_t>(value >> 63));
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::string take() && { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Takes numbers off the front of a string of bytes. Reading past the end gives zeros and makes
/// `ok` false for good, so that a decoder may check once, after it has read; counts are checked
/// against what is left before anything is allocated.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

    template <typename T>
    T get() {
        static_assert(std::is_arithmetic_v<T>);
        const std::string_view raw = get_raw(sizeof(T));
        if (raw.size() != sizeof(T)) return T{};
        char copy[sizeof(T)];
        std::memcpy(copy, raw.data(), sizeof(T));
        if constexpr (std::endian::native == std::endian::big) {
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
                std::swap(copy[i], copy[sizeof(T) - 1 - i]);
            }
        }
        T value;
        std::memcpy(&value, copy, sizeof(T));
        return value;
    }
    /// A 32-bit count of things that take at least `bytes_each` bytes each; 0 when they cannot all
    /// be there.
    std::uint32_t get_count(std::size_t bytes_each) {
        const auto count = get<std::uint32_t>();
        if (bytes_each > 0 && count > rest_.size() / bytes_each) {
            ok_ = false;
            return 0;
        }
        return count;
    }
    template <typename T>
    std::vector<T> get_all(std::size_t count) {
        std::vector<T> values;
        if (count > rest_.size() / sizeof(T)) {
            ok_ = false;
            return values;
        }
        values.reserve(count);
        for (std::size_t i = 0; i < count; ++i) values.push_back(get<T>());
        return values;
    }
    /// Only as put_varint writes them: at most ten bytes, none too many.
    std::uint64_t get_varint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto byte = get<std::uint8_t>();
            const bool too_much = (shift == 63 && byte > 1) || (shift > 0 && byte == 0);
            if (!ok_ || too_much) break;
            value |= std::uint64_t{byte & 0x7FU} << shift;
            if (byte < 0x80) return value;
        }
        ok_ = false;
        return 0;
    }
    std::int64_t get_signed() {
        const std::uint64_t value = get_varint();
        return static_cast<std::int64_t>((value >> 1) ^ (~(value & 1) + 1));
    }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }
    /// For what a decoder finds wrong: from now on not ok.
    void fail() {
        ok_ = false;
        rest_ = {};
    }
    std::string get_text() { return std::string(get_raw(get_count(1))); }
    /// Exactly `count` bytes, or none.
    std::string_view get_raw(std::size_t count) {
        if (!ok_ || count > rest_.size()) {
            ok_ = false;
            return {};
        }
        const std::string_view raw = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return raw;
    }

private:
    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace ossuary::index
