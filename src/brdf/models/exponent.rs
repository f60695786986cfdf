//! The specular exponent, a parameter of several models.

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
