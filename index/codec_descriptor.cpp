// The blob of a skeleton's descriptor.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"

namespace ossuary::index {

namespace {

using Branch = matching::SkeletonDescriptor::Branch;

/// How a branch is written: small numbers and rounded samples take 16 bits each. Rounded samples
/// take 1.4 kB of the 10 kB that a model of the shape benchmark has on disk.
enum Layout : std::uint8_t { kWide = 1, kRounded = 2, kAllLayouts = 3 };

constexpr std::size_t kDigitsOfByte = 3;
constexpr unsigned kDirectionDigits = 5;
constexpr std::size_t kSmallestBranch = 13;

/// Whether all values are whole multiples of a unit that fit into a T, so that get_multiples gives
/// them back bit by bit.
template <typename T>
bool are_multiples(std::span<const float> values, float unit) {
    return std::all_of(values.begin(), values.end(), [=](float value) {
        const float multiple = value / unit;
        if (!(multiple >= static_cast<float>(std::numeric_limits<T>::min()) &&
              multiple <= static_cast<float>(std::numeric_limits<T>::max()))) {
            return false;
        }
        const float back = static_cast<float>(static_cast<T>(multiple)) * unit;
        return std::bit_cast<std::uint32_t>(back) == std::bit_cast<std::uint32_t>(value);
    });
}

template <typename T>
void put_multiples(ByteWriter& writer, std::span<const float> values, float unit) {
    for (const float value : values) writer.put(static_cast<T>(value / unit));
}

template <typename T>
std::vector<float> get_multiples(ByteReader& reader, std::size_t count, float unit) {
    std::vector<float> values;
    for (const T multiple : reader.get_all<T>(count)) {
        values.push_back(static_cast<float>(multiple) * unit);
    }
    return values;
}

std::uint8_t layout_of(const Branch& branch) {
    constexpr std::size_t kNarrow = 0xFFFF;
    std::uint8_t layout = 0;
    if (std::max({std::size_t{branch.a}, std::size_t{branch.b}, branch.chain_code.size(),
                  branch.radii.size()}) > kNarrow) {
        layout |= kWide;
    }
    if (are_multiples<std::int16_t>(branch.points, matching::kPointUnit) &&
        are_multiples<std::uint16_t>(branch.radii, matching::kRadiusUnit)) {
        layout |= kRounded;
    }
    return layout;
}

void put_number(ByteWriter& writer, std::uint8_t layout, std::size_t number) {
    if ((layout & kWide) != 0) {
        writer.put(static_cast<std::uint32_t>(number));
    } else {
        writer.put(static_cast<std::uint16_t>(number));
    }
}

std::uint32_t get_number(ByteReader& reader, std::uint8_t layout) {
    return (layout & kWide) != 0 ? reader.get<std::uint32_t>() : reader.get<std::uint16_t>();
}

/// Three digits a byte, the first counting most; what is missing in the last byte is 0.
void put_digits(ByteWriter& writer, std::string_view digits) {
    for (std::size_t at = 0; at < digits.size(); at += kDigitsOfByte) {
        unsigned byte = 0;
        for (std::size_t i = at; i < at + kDigitsOfByte; ++i) {
            const char digit = i < digits.size() ? digits[i] : '0';
            byte = kDirectionDigits * byte + static_cast<unsigned>(digit - '0');
        }
        writer.put(static_cast<std::uint8_t>(byte));
    }
}

/// False where a byte stands for no three digits.
bool get_digits(ByteReader& reader, std::size_t count, std::string& digits) {
    const std::string_view packed = reader.get_raw((count + kDigitsOfByte - 1) / kDigitsOfByte);
    for (const char c : packed) {
        const auto byte = static_cast<unsigned>(static_cast<unsigned char>(c));
        if (byte >= kDirectionDigits * kDirectionDigits * kDirectionDigits) return false;
        for (const unsigned unit : {kDirectionDigits * kDirectionDigits, kDirectionDigits, 1U}) {
            digits += static_cast<char>('0' + byte / unit % kDirectionDigits);
        }
    }
    if (digits.size() < count) return reader.ok();
    const bool padded = digits.find_first_not_of('0', count) == std::string::npos;
    digits.resize(count);
    return padded;
}

void put_branch(ByteWriter& writer, const Branch& branch) {
    const std::uint8_t layout = layout_of(branch);
    writer.put(layout);
    put_number(writer, layout, branch.a);
    put_number(writer, layout, branch.b);
    writer.put(branch.length);
    put_number(writer, layout, branch.chain_code.size());
    put_digits(writer, branch.chain_code);
    put_number(writer, layout, branch.radii.size());
    if ((layout & kRounded) != 0) {
        put_multiples<std::int16_t>(writer, branch.points, matching::kPointUnit);
        put_multiples<std::uint16_t>(writer, branch.radii, matching::kRadiusUnit);
    } else {
        writer.put_all<float>(branch.points);
        writer.put_all<float>(branch.radii);
    }
}

void get_samples(ByteReader& reader, std::uint8_t layout, std::size_t count, Branch& branch) {
    if ((layout & kRounded) != 0) {
        branch.points = get_multiples<std::int16_t>(reader, 3 * count, matching::kPointUnit);
        branch.radii = get_multiples<std::uint16_t>(reader, count, matching::kRadiusUnit);
    } else {
        branch.points = reader.get_all<float>(3 * count);
        branch.radii = reader.get_all<float>(count);
    }
}

/// Versions 1 and 2: everything in full.
Result<void> get_full_branch(ByteReader& reader, const matching::SkeletonDescriptor& descriptor,
                             Branch& branch) {
    branch.a = reader.get<std::uint32_t>();
    branch.b = reader.get<std::uint32_t>();
    branch.length = reader.get<float>();
    branch.chain_code = reader.get_text();
    const std::uint32_t samples = reader.get_count(16);
    branch.points = reader.get_all<float>(std::size_t{3} * samples);
    branch.radii = reader.get_all<float>(samples);
    if (!reader.ok()) return corrupt_blob(kDescriptorBlob, "wrong length");
    if (samples < 2) return corrupt_blob(kDescriptorBlob, "a branch of fewer than two points");
    if (std::max(branch.a, branch.b) >= descriptor.nodes.size()) {
        return corrupt_blob(kDescriptorBlob, "a branch ends at a node that is not there");
    }
    if (branch.chain_code.find_first_not_of("01234") != std::string::npos) {
        return corrupt_blob(kDescriptorBlob, "a chain code with other digits than 0 to 4");
    }
    return {};
}

Result<void> get_branch(ByteReader& reader, const matching::SkeletonDescriptor& descriptor,
                        Branch& branch) {
    const auto layout = reader.get<std::uint8_t>();
    branch.a = get_number(reader, layout);
    branch.b = get_number(reader, layout);
    branch.length = reader.get<float>();
    if (!get_digits(reader, get_number(reader, layout), branch.chain_code)) {
        return corrupt_blob(kDescriptorBlob, "a chain code with other digits than 0 to 4");
    }
    const std::uint32_t samples = get_number(reader, layout);
    if (!reader.ok()) return corrupt_blob(kDescriptorBlob, "wrong length");
    if (layout > kAllLayouts) return corrupt_blob(kDescriptorBlob, "a branch of unknown layout");
    if (samples < 2) return corrupt_blob(kDescriptorBlob, "a branch of fewer than two points");
    if (std::max(branch.a, branch.b) >= descriptor.nodes.size()) {
        return corrupt_blob(kDescriptorBlob, "a branch ends at a node that is not there");
    }
    get_samples(reader, layout, samples, branch);
    if (!reader.ok()) return corrupt_blob(kDescriptorBlob, "wrong length");
    return {};
}

template <typename T>
bool all_finite(const T& values) {
    return std::all_of(values.begin(), values.end(),
                       [](float value) { return std::isfinite(value); });
}

}  // namespace

std::string encode_descriptor(const matching::SkeletonDescriptor& descriptor) {
    ByteWriter writer;
    writer.put(descriptor.solid_volume);
    writer.put(descriptor.limb_volume);
    writer.put(static_cast<std::uint32_t>(descriptor.nodes.size()));
    for (const matching::SkeletonDescriptor::Node& node : descriptor.nodes) {
        for (const float coordinate : node.position) writer.put(coordinate);
        writer.put(node.radius);
        writer.put(node.significance);
    }
    writer.put(static_cast<std::uint32_t>(descriptor.branches.size()));
    for (const Branch& branch : descriptor.branches) put_branch(writer, branch);
    return seal_blob(kDescriptorBlob, writer.bytes());
}

Result<matching::SkeletonDescriptor> decode_descriptor(std::string_view blob) {
    const auto payload = open_blob(kDescriptorBlob, blob);
    if (!payload) return payload.error();
    const std::uint8_t version = blob_version(blob);
    ByteReader reader(*payload);
    matching::SkeletonDescriptor descriptor;
    if (version >= 2) descriptor.solid_volume = reader.get<float>();
    if (version >= 3) descriptor.limb_volume = reader.get<float>();
    descriptor.nodes.resize(reader.get_count(20));
    bool finite = std::isfinite(descriptor.solid_volume) && std::isfinite(descriptor.limb_volume);
    for (matching::SkeletonDescriptor::Node& node : descriptor.nodes) {
        for (float& coordinate : node.position) coordinate = reader.get<float>();
        node.radius = reader.get<float>();
        node.significance = reader.get<float>();
        finite = finite && all_finite(node.position) && std::isfinite(node.radius) &&
                 std::isfinite(node.significance);
    }
    descriptor.branches.resize(reader.get_count(version >= 3 ? kSmallestBranch : 20 + 2 * 16));
    for (Branch& branch : descriptor.branches) {
        const auto read = version >= 3 ? get_branch(reader, descriptor, branch)
                                       : get_full_branch(reader, descriptor, branch);
        if (!read) return read.error();
        finite = finite && std::isfinite(branch.length) && all_finite(branch.points) &&
                 all_finite(branch.radii);
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kDescriptorBlob, "wrong length");
    if (!finite) return corrupt_blob(kDescriptorBlob, "a number that is not finite");
    return descriptor;
}

}  // namespace ossuary::index
