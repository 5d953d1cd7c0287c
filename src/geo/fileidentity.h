#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dsphere::geo {

/// Tells the content of some files at this time apart from all other content and times: 32 hexadecimal digits, of each
/// file's size, its time of modification, and a sample of its bytes (the first and the last MiB, and 64 blocks of 4 KiB
/// evenly spread between them). Names do not count: moved files stay the same. Throws Error (InvalidInput) when a file
/// cannot be read.
std::string identityOf(const std::vector<std::filesystem::path>& files);

}  // namespace dsphere::geo
