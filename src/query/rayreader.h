#pragma once

#include "query/engine.h"
#include "query/geography.h"
#include "query/inputstream.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsphere::query {

enum class FileFormat { Npy, Csv };

/// Rays from a file, in order.
class RayReader {
  public:
    virtual ~RayReader() = default;

    /// The next rays, at most `most`, none at the end; they lie in `room`. Error (InvalidInput) where the file is not
    /// as it should be.
    virtual RayRows read(std::vector<double>& room, std::size_t most) = 0;
    /// How many rays there are in all, where the file says it.
    virtual std::optional<std::uint64_t> count() const = 0;
    /// The share of the file that has been read, where its length is known.
    virtual std::optional<double> share() const = 0;
};

/// A NumPy array or a CSV file; its content decides unless a format is given. Errors name what was found and expected.
std::unique_ptr<RayReader> openRays(const std::string& name, std::optional<FileFormat> format,
                                    const Geography& geography);

std::unique_ptr<RayReader> openNpy(InputStream stream);
std::unique_ptr<RayReader> openCsv(InputStream stream, const Geography& geography);

}  // namespace dsphere::query
