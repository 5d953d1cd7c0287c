#pragma once

namespace dsphere {

/// How light becomes what a display shows, channel by channel, before the sRGB curve.
enum class ToneCurve {
    Linear,    ///< x, cut at 1
    Aces,      ///< Narkowicz 2015, "ACES Filmic Tone Mapping Curve": a fit of the Academy's reference transform
    Reinhard,  ///< x / (1 + x): Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", equation 3
};

struct Tone {
    double exposure = 0.0;  ///< stops, before the curve
    ToneCurve curve = ToneCurve::Linear;
};

/// Of light after exposure. Linear: x itself; the others: 0 for NaN and what is not above 0, else in (0, 1].
double toneMapped(ToneCurve curve, double x);

}  // namespace dsphere
