#pragma once

// A smaller map of a large one, made in the pass that surveys it, and how far off its surface is.

#include "surface/survey.h"

namespace dsphere {

/// By how much a map is reduced so that it is held in memory at no more than kReducedWidth columns: a power of two that
/// divides its columns and its rows (gridline: rows of cells); 0: there is none, or too little is left.
int reductionOf(int width, int height, Registration registration);

inline constexpr int kReducedWidth = 8192;

/// Takes the rows of a map from the north on, in bands of whole multiples of the reduction, unknown texels filled. T:
/// the type of its samples.
template <typename T>
class Reducer {
  public:
    Reducer(Survey& survey, int width, int height, Registration registration, int reduction);

    /// Rows [y, y + count), `width` samples each; the survey's north pole is known, and its south pole when these are
    /// the last.
    void add(const T* rows, int y, int count);

  private:
    const T* row(int y) const;
    void reduceRows(int y, int count);
    void measure(int from, int to);
    double differenceAlong(const float* level, const T* above, const T* below) const;
    std::vector<float> levelRow(double y) const;

    Survey& survey_;
    int width_, height_, reduction_, level_width_, level_height_;
    bool texel_;
    const T* rows_ = nullptr;
    int first_ = 0, count_ = 0, measured_ = 0;
    std::vector<T> tail_;  ///< the band before's last rows: those that its successors' lines still need
    int tail_first_ = 0;
};

}  // namespace dsphere
