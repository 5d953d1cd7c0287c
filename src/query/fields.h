#pragma once

#include "query/certify.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dsphere::query {

/// One answer as bytes: the fields that were chosen, one after the other, little-endian, in NumPy's types.
class Record {
  public:
    /// Words of status, t, P, N, u, v, lat, lon, height, metres, id, lit, t_low, t_high, tangent. Error (Usage) for
    /// another or one that stands twice.
    explicit Record(const std::vector<std::string>& names);

    static std::vector<std::string> everyName(bool certified);

    std::size_t bytes() const { return bytes_; }
    bool has(const std::string& name) const;
    /// One record after the other; `truths`, one an answer, may be empty if none of the fields is of --certify.
    void put(std::byte* target, std::span<const Answer> answers, std::span<const Truth> truths) const;

    /// NumPy's description: [('status', '|u1'), ('P', '<f8', (3,))].
    std::string numpyType() const;
    /// "status,t,P_x,P_y,P_z"
    std::string csvHeader() const;
    /// The line of a record, with its end.
    void appendCsv(std::string& text, const std::byte* record) const;

  private:
    std::vector<int> fields_;  ///< indices in the table of all
    std::size_t bytes_ = 0;
};

}  // namespace dsphere::query
