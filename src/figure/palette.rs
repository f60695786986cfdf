//! Colours as roles, and the palettes that say what they are.

/// Role of a colour in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Lines and text that matter.
    Foreground,
    /// Text and lines that explain.
    Muted,
    /// Grids and shades, visible and no more.
    Faint,
    /// Behind everything.
    Background,
    /// Things that can be dragged.
    Accent,
    /// One material of several, counted from 0; after the last colour the first comes again.
    Series(usize),
    /// Fixed sRGB colour, the same in every palette.
    Fixed([u8; 3]),
}

/// A role and how much of it covers what is behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// Role, from which the palette has the colour.
    pub role: Role,
    /// Opacity, from 0 to 1.
    pub opacity: f32,
}

impl Ink {
    /// Ink of the same role with its opacity multiplied by `opacity`.
    pub fn faded(self, opacity: f32) -> Self {
        Self {
            opacity: self.opacity * opacity,
            ..self
        }
    }
}

impl From<Role> for Ink {
    fn from(role: Role) -> Self {
        Self { role, opacity: 1.0 }
    }
}

/// The number of colours that tell materials apart.
pub const SERIES_COLORS: usize = 7;

/// Number of series colours that differ clearly from all others; those after them repeat a hue or have none.
const CLEAR_HUES: usize = 5;

/// The series colour of the `k`-th thing that is drawn beside series `series` and is not to be taken for it.
pub fn companion(series: usize, k: usize) -> usize {
    let own = series % SERIES_COLORS;
    // The last but one is a lighter blue.
    let own = if own == CLEAR_HUES { 0 } else { own };
    (own + 1..own + 1 + CLEAR_HUES)
        .map(|hue| hue % CLEAR_HUES)
        .filter(|hue| *hue != own)
        .nth(k % (CLEAR_HUES - 1))
        .unwrap_or(own)
}

/// sRGB colours of the roles.
///
/// The series are the hues of Okabe and Ito, who chose them to be told apart by colour-blind people, made darker
/// on light ground and lighter on dark ground; a material keeps its hue when the theme changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// sRGB of [`Role::Foreground`].
    pub foreground: [u8; 3],
    /// sRGB of [`Role::Muted`].
    pub muted: [u8; 3],
    /// sRGB of [`Role::Faint`].
    pub faint: [u8; 3],
    /// sRGB of [`Role::Background`].
    pub background: [u8; 3],
    /// sRGB of [`Role::Accent`].
    pub accent: [u8; 3],
    /// sRGB of [`Role::Series`], by position.
    pub series: [[u8; 3]; SERIES_COLORS],
}

impl Palette {
    /// Palette for light windows.
    pub const LIGHT: Self = Self {
        foreground: [0x1d, 0x1f, 0x23],
        muted: [0x5c, 0x62, 0x6b],
        faint: [0xd3, 0xd6, 0xdb],
        background: [0xf8, 0xf8, 0xf8],
        accent: [0xb4, 0x5f, 0x00],
        series: [
            [0x00, 0x68, 0xb0],
            [0xc6, 0x4d, 0x00],
            [0x00, 0x80, 0x5c],
            [0xb0, 0x4a, 0x87],
            [0x8f, 0x6b, 0x00],
            [0x2a, 0x82, 0xb8],
            [0x6b, 0x6b, 0x6b],
        ],
    };
    /// Palette for dark windows.
    pub const DARK: Self = Self {
        foreground: [0xec, 0xed, 0xee],
        muted: [0x9e, 0xa4, 0xad],
        faint: [0x41, 0x44, 0x4a],
        background: [0x1b, 0x1b, 0x1b],
        accent: [0xff, 0xb4, 0x54],
        series: [
            [0x4f, 0xa8, 0xf5],
            [0xff, 0x86, 0x4a],
            [0x2f, 0xc4, 0x97],
            [0xe3, 0x8f, 0xc0],
            [0xe8, 0xd2, 0x4a],
            [0x8a, 0xd0, 0xf5],
            [0xb8, 0xb8, 0xb8],
        ],
    };

    /// The palette for a dark or light window.
    pub fn of_theme(dark: bool) -> Self {
        if dark { Self::DARK } else { Self::LIGHT }
    }

    /// sRGB of a role.
    pub fn color(&self, role: Role) -> [u8; 3] {
        match role {
            Role::Foreground => self.foreground,
            Role::Muted => self.muted,
            Role::Faint => self.faint,
            Role::Background => self.background,
            Role::Accent => self.accent,
            Role::Series(index) => self.series[index % SERIES_COLORS],
            Role::Fixed(color) => color,
        }
    }

    /// sRGB and opacity, 255 for opaque.
    pub fn resolve(&self, ink: Ink) -> [u8; 4] {
        let [r, g, b] = self.color(ink.role);
        [r, g, b, (255.0 * ink.opacity.clamp(0.0, 1.0)).round() as u8]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::color::{luminance, srgb_decode};

    /// Contrast of two colours after WCAG 2: from 1 to 21.
    fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
        let of = |c: [u8; 3]| luminance(c.map(|x| srgb_decode(f64::from(x) / 255.0))) + 0.05;
        let (a, b) = (of(a), of(b));
        a.max(b) / a.min(b)
    }

    /// Roles of a palette that are harder to see than they may be: 4.5 for text, 3 for lines.
    fn too_faint(palette: &Palette) -> Vec<Role> {
        let text = [Role::Foreground, Role::Muted].map(|role| (role, 4.5));
        let lines = (0..SERIES_COLORS).map(|k| (Role::Series(k), 3.0));
        text.into_iter()
            .chain(lines)
            .chain([(Role::Accent, 3.0), (Role::Faint, 1.3)])
            .filter(|(role, least)| contrast(palette.color(*role), palette.background) < *least)
            .map(|(role, _)| role)
            .collect()
    }

    #[test]
    fn every_role_stands_out_from_the_background() {
        for palette in [Palette::LIGHT, Palette::DARK] {
            assert_eq!(too_faint(&palette), []);
        }
    }

    #[test]
    fn a_colour_of_the_other_theme_is_caught() {
        let mut wrong = Palette::LIGHT;
        wrong.series[4] = Palette::DARK.series[4];
        assert_eq!(too_faint(&wrong), [Role::Series(4)]);
    }

    #[test]
    fn companions_have_other_colours_than_their_series() {
        for series in 0..2 * SERIES_COLORS {
            let mut hues: Vec<usize> = (0..3).map(|k| companion(series, k)).collect();
            hues.push(series % SERIES_COLORS);
            hues.sort_unstable();
            hues.dedup();
            assert_eq!(hues.len(), 4, "{series}: {hues:?}");
            assert!(!(series % SERIES_COLORS == CLEAR_HUES && hues.contains(&0)));
        }
    }

    #[test]
    fn inks_resolve() {
        assert_eq!(contrast([0; 3], [255; 3]).round(), 21.0);
        let ink = Ink::from(Role::Fixed([1, 2, 3])).faded(0.5);
        assert_eq!(Palette::DARK.resolve(ink), [1, 2, 3, 128]);
        assert_eq!(
            Palette::DARK.color(Role::Series(SERIES_COLORS)),
            Palette::DARK.color(Role::Series(0))
        );
    }
}
