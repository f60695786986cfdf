//! The largest window that the graphics adapter can draw.

use egui::{Context, Vec2, ViewportCommand};

/// Keeps the window within what can be drawn.
pub(super) struct Largest {
    /// Longest side in pixels.
    limit_px: u32,
    /// Scale for which the desktop was told the limit.
    told: Option<f32>,
    /// Whether a window beyond it was met, which is said once.
    said: bool,
}

impl Largest {
    /// Largest window with this longest side in pixels.
    pub fn of(limit_px: u32) -> Self {
        Self {
            limit_px,
            told: None,
            said: false,
        }
    }

    /// Tells the desktop, and shrinks a window that has become larger all the same. Returns a sentence the first time it
    /// does. To be called once a frame.
    pub fn keep(&mut self, ctx: &Context) -> Option<String> {
        let density = ctx.pixels_per_point();
        let limit = self.limit_px as f32 / density;
        if self.told != Some(density) {
            self.told = Some(density);
            ctx.send_viewport_cmd(ViewportCommand::MaxInnerSize(Vec2::splat(limit)));
        }
        let size = ctx.content_rect().size();
        if size.max_elem() <= limit {
            return None;
        }
        // A maximised window keeps its size.
        for command in [
            ViewportCommand::Fullscreen(false),
            ViewportCommand::Maximized(false),
            ViewportCommand::InnerSize(size.min(Vec2::splat(limit))),
        ] {
            ctx.send_viewport_cmd(command);
        }
        let text = format!(
            "The window is as large as this graphics adapter can draw it: {} pixels a side.",
            self.limit_px
        );
        (!std::mem::replace(&mut self.said, true)).then_some(text)
    }
}
