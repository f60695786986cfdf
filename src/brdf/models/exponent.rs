//! The specular exponent, a parameter of several models: of wr·wo, or of wh·n, which turns half as far.

use crate::brdf::params::{AtBound, Param, ParamId, Scale, Starts};

/// Row of the specular exponent s.
pub const S: Param = Param {
    id: ParamId("s"),
    symbol: "s",
    name: "specular exponent",
    unit: "",
    range: (0.01, 1e5),
    domain: (1e-6, 1e7),
    // At 1e-5 a base of 1e-7 to this power is 0.9998.
    bounds: (1e-5, 1e5),
    at_bounds: [
        AtBound::Means(
            "s went to 0: the lobe is 1 wherever it is not 0, so that R_F alone shapes the specular part.",
        ),
        AtBound::Unknown,
    ],
    starts: Starts::PerDecade(2.5),
    default: 50.0,
    scale: Scale::Log {
        smallest_exponent: -2,
    },
    help: "Shininess: the larger, the narrower the highlight.",
};

/// Row of the exponent s of wh·n, with four times the range of that of wr·wo, so that each highlight has its counterpart.
pub const S_OF_WH: Param = Param {
    range: (4.0 * S.range.0, 4.0 * S.range.1),
    domain: (4.0 * S.domain.0, 4.0 * S.domain.1),
    bounds: (4.0 * S.bounds.0, 4.0 * S.bounds.1),
    default: 4.0 * S.default,
    ..S
};
