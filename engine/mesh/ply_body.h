#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/mesh/load_number.h"
#include "engine/mesh/ply_header.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {

enum class PlyStatus {
    kOk,
    kEnds,       ///< the file ends before the number does
    kNotNumber,  ///< text that is none
    kNonFinite,  ///< text that says nan or inf, or is beyond doubles
};

// The data of a PLY file as a sequence of numbers. Text and binary data have the same functions:
// the reader (read_ply.cpp) is a template over them.

/// Numbers as bytes.
class PlyBinaryBody {
public:
    PlyBinaryBody(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes),
          start_(header.bytes),
          at_(header.bytes),
          order_(header.encoding == PlyEncoding::kLittleEndian ? std::endian::little
                                                               : std::endian::big) {}

    void rewind() { at_ = start_; }
    PlyStatus read(PlyType type, double& value) {
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size) return PlyStatus::kEnds;
        value = load(type, bytes_.data() + at_);
        at_ += size;
        return PlyStatus::kOk;
    }
    /// Reads `count` indices below `limit` at once; false, with nothing read, where something else
    /// follows or the type is a rare one. Three times as fast as one by one.
    bool read_indices(PlyType type, std::uint64_t count, std::uint32_t limit,
                      std::vector<std::uint32_t>& indices) {
        if (type != PlyType::kInt32 && type != PlyType::kUint32) return false;
        if (count > most_left(type)) return false;
        indices.resize(count);
        const char* number = bytes_.data() + at_;
        bool in_range = true;
        for (std::uint32_t& index : indices) {
            index = load_number<std::uint32_t>(number, order_);  // negative ones are large then
            in_range = in_range && index < limit;
            number += sizeof(std::uint32_t);
        }
        if (in_range) at_ += count * sizeof(std::uint32_t);
        return in_range;
    }
    PlyStatus skip(PlyType type, std::uint64_t count) {
        if (count > most_left(type)) return PlyStatus::kEnds;
        at_ += count * size_of(type);
        return PlyStatus::kOk;
    }
    /// How many such numbers may follow.
    [[nodiscard]] std::uint64_t most_left(PlyType type) const {
        return (bytes_.size() - at_) / size_of(type);
    }
    /// "byte 128: ", for messages.
    [[nodiscard]] std::string place() const { return "byte " + std::to_string(at_) + ": "; }
    [[nodiscard]] std::string_view found() const { return {}; }
    /// Bytes or lines after the current position, none left afterwards.
    std::size_t trailing() { return bytes_.size() - std::exchange(at_, bytes_.size()); }
    static constexpr bool kIsText = false;

private:
    [[nodiscard]] double load(PlyType type, const char* number) const {
        switch (type) {
            case PlyType::kInt8:
                return static_cast<signed char>(*number);
            case PlyType::kUint8:
                return static_cast<unsigned char>(*number);
            case PlyType::kInt16:
                return load_number<std::int16_t>(number, order_);
            case PlyType::kUint16:
                return load_number<std::uint16_t>(number, order_);
            case PlyType::kInt32:
                return load_number<std::int32_t>(number, order_);
            case PlyType::kUint32:
                return load_number<std::uint32_t>(number, order_);
            case PlyType::kFloat32:
                return double{load_number<float>(number, order_)};
            case PlyType::kFloat64:
                return load_number<double>(number, order_);
        }
        assert(false);
        return 0;
    }

    std::string_view bytes_;
    std::size_t start_;
    std::size_t at_;
    std::endian order_;
};

/// Numbers as words; lines mean nothing.
class PlyTextBody {
public:
    PlyTextBody(std::string_view bytes, const PlyHeader& header)
        : start_(bytes.substr(header.bytes)), scanner_(start_), header_lines_(header.lines) {}

    void rewind() { scanner_ = TextScanner(start_); }
    PlyStatus read(PlyType, double& value) {
        if (!scanner_.find_token()) return PlyStatus::kEnds;
        switch (scanner_.read_double(value)) {
            case NumberStatus::kOk:
                return PlyStatus::kOk;
            case NumberStatus::kNonFinite:
                return PlyStatus::kNonFinite;
            default:
                return PlyStatus::kNotNumber;
        }
    }
    bool read_indices(PlyType, std::uint64_t count, std::uint32_t limit,
                      std::vector<std::uint32_t>& indices) {
        indices.clear();
        TextScanner ahead = scanner_;
        for (std::uint64_t i = 0; i < count; ++i) {
            std::uint64_t index = 0;
            if (!ahead.find_token() || ahead.read_count(index) != NumberStatus::kOk) return false;
            if (index >= limit) return false;
            indices.push_back(static_cast<std::uint32_t>(index));
        }
        scanner_ = ahead;
        return true;
    }
    PlyStatus skip(PlyType, std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!scanner_.find_token()) return PlyStatus::kEnds;
            scanner_.advance(scanner_.peek_token().size());
        }
        return PlyStatus::kOk;
    }
    [[nodiscard]] std::uint64_t most_left(PlyType) const { return scanner_.bytes_left() / 2 + 1; }
    [[nodiscard]] std::string place() const {
        return "line " + std::to_string(header_lines_ + scanner_.line()) + ": ";
    }
    /// The word that is no number.
    [[nodiscard]] std::string_view found() const { return scanner_.peek_token(); }
    std::size_t trailing() {
        std::size_t lines = 0;
        for (; scanner_.find_token(); ++lines) scanner_.skip_rest_of_line();
        return lines;
    }
    static constexpr bool kIsText = true;

private:
    std::string_view start_;
    TextScanner scanner_;
    std::size_t header_lines_;
};

}  // namespace ossuary::mesh
