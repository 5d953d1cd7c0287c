#pragma once

#include <filesystem>

namespace dsphere::geo {

/// Throws Error (InvalidInput) unless a netCDF file of the classic format (or with 64-bit offsets or data) is as long
/// as its variables say: the library reads zeros where one is cut short. HDF5 files are left to the library, which
/// checks.
void checkClassicNetCdf(const std::filesystem::path& path);

}  // namespace dsphere::geo
