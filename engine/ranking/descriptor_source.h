#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/ranker.h"

namespace ossuary::ranking {

using SharedDescriptor = std::shared_ptr<const descriptor::ModelDescriptor>;

/// The descriptors of a collection, wherever they are kept; the collection's order is fixed.
class DescriptorSource {
public:
    DescriptorSource() = default;
    DescriptorSource(const DescriptorSource&) = delete;
    DescriptorSource& operator=(const DescriptorSource&) = delete;
    virtual ~DescriptorSource() = default;

    /// Models of the collection.
    [[nodiscard]] virtual std::size_t size() const = 0;
    /// The descriptors of `indices`, in their order; null for a model that is not there any more.
    /// May be called from several threads. Errors: those of the place that they are kept in.
    virtual Result<std::vector<SharedDescriptor>> fetch(std::span<const std::uint32_t> indices) = 0;
};

/// Descriptors that are in memory anyway, and outlive this.
class DescriptorsInMemory : public DescriptorSource {
public:
    explicit DescriptorsInMemory(DescriptorSpan collection) : collection_(collection) {}

    [[nodiscard]] std::size_t size() const override { return collection_.size(); }
    Result<std::vector<SharedDescriptor>> fetch(std::span<const std::uint32_t> indices) override {
        std::vector<SharedDescriptor> found;
        found.reserve(indices.size());
        for (const std::uint32_t index : indices) {
            found.emplace_back(SharedDescriptor(), collection_[index]);  // not owned
        }
        return found;
    }

private:
    DescriptorSpan collection_;
};

}  // namespace ossuary::ranking
