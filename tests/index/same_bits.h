#pragma once

#include <gtest/gtest.h>

#include "index/codec.h"

namespace ossuary::test {

/// That the index would keep the same bytes of both.
inline void expect_same_bits(const descriptor::ModelDescriptor& actual,
                             const descriptor::ModelDescriptor& expected) {
    EXPECT_EQ(index::encode_descriptor(actual.skeleton),
              index::encode_descriptor(expected.skeleton));
    EXPECT_EQ(index::encode_globals(actual.globals), index::encode_globals(expected.globals));
    EXPECT_EQ(index::encode_signature(actual.signature),
              index::encode_signature(expected.signature));
}

}  // namespace ossuary::test
