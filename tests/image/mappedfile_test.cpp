#include "image/mappedfile.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

TEST(MappedFile, WhatIsCutOffReadsAsZeros) {
    const TempFolder folder;
    const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE)), size = 3 * page;
    const auto path = folder.write("map.tif", std::string(size, 'x'));
    const auto file = MappedFile::open(path, size), other = MappedFile::open(path, size);
    ASSERT_TRUE(file && other);
    const auto* bytes = static_cast<const volatile char*>(file->data());
    EXPECT_EQ(bytes[2 * page], 'x');
    EXPECT_FALSE(file->isCut());
    std::filesystem::resize_file(path, page);
    EXPECT_EQ(bytes[0], 'x');
    EXPECT_FALSE(file->isCut());
    EXPECT_EQ(bytes[2 * page + 5], '\0');
    EXPECT_TRUE(file->isCut());
    EXPECT_FALSE(other->isCut());
    file->forget();
    EXPECT_EQ(bytes[2 * page + 5], '\0');
}

TEST(MappedFile, OneThatIsMissingIsNull) {
    const TempFolder folder;
    EXPECT_EQ(MappedFile::open(folder.path() / "missing.tif", 1), nullptr);
}

}  // namespace
}  // namespace dsphere::test
