#pragma once

#include "image/picture.h"

#include <gtest/gtest.h>

namespace dsphere::test {

/// The same pixels, in the same channels, bit for bit.
inline void expectSameChannels(const Image& a, const Image& b) {
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (const Channel& channel : a.channels) EXPECT_EQ(channel.pixels, b.at(channel.name).pixels) << channel.name;
}

}  // namespace dsphere::test
