#pragma once

#include "base/image.h"

#include <functional>
#include <vector>

namespace dsphere {

/// Samples are summed in blocks of as many: within a block one after the other, as the device adds them up.
inline constexpr int kSumBlock = 16;

/// The sum of samples first to last - 1: of a block's first ones; of blocks 2^k j to 2^k (j + 1) - 1, which is that of
/// the first half of them plus that of the second; or of one sample alone.
struct SumPart {
    int first = 0, last = 0;
    Image sums;  ///< R, G, B, and A where it is wanted

    int count() const { return last - first; }
};

/// What the samples first() to last() - 1 of a picture add up to. How floats are added up decides their sum's last bit,
/// so the order is the same however a picture is cut into ranges of samples: parts are added as soon as they are the
/// two halves of another part, or a block's first samples and its next one, and never else.
class SampleSums {
  public:
    SampleSums() = default;

    int first() const { return parts_.empty() ? 0 : parts_.front().first; }
    int last() const { return parts_.empty() ? 0 : parts_.back().last; }
    int samples() const { return last() - first(); }
    /// From left to right, without gaps: as few as there can be.
    const std::vector<SumPart>& parts() const { return parts_; }
    /// Whether the next sample is added to the last part.
    bool isOpen() const;

    /// Samples that follow the last one.
    void append(SumPart part);
    void append(SampleSums sums);
    /// The last part, which is taken away.
    SumPart takeLast();
    /// All parts added up from left to right.
    Image total() const;

  private:
    std::vector<SumPart> parts_;
};

/// Where samples are added up one after the other.
struct SampleFilm {
    std::function<void(const Image* sums)> begin;  ///< with these sums; null: with none
    /// Adds a sample, and tells the share of it that is done.
    std::function<void(int sample, const std::function<bool(double)>& progress)> add;
    std::function<Image()> read;
};

/// The sums of samples `from` to `to` - 1, of which `start` has some of the first already. `progress` is told the share
/// that is done; when it returns false the sample in progress is completed, and the sums are of fewer. The same sums
/// whatever `start`.
SampleSums addSamples(const SampleFilm& film, SampleSums start, int from, int to,
                      const std::function<bool(double)>& progress);

/// Adds the channels of one image to those of another, of the same pixels.
void addSums(Image& sums, const Image& more);

/// The picture: its channels are the means of the samples. A mean times its number gives the sum back where there is
/// one part and the number is a power of two; else the parts' sums come with it, as "sum.0-16.R" of samples 0 to 15.
Image pictureOf(SampleSums sums);

/// Of a picture of samples first to last - 1, bit for bit; other channels are left out. Error (InvalidInput) without
/// the channels that it takes.
SampleSums sumsOf(const Image& picture, int first, int last);

/// How many pixels hold a sum that is not finite: a sample of theirs was not.
std::size_t nonFinitePixels(const SampleSums& sums);

}  // namespace dsphere
