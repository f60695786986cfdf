//! The pictures of a drawing as textures, which stay as long as they are painted.

use egui::cache::FramePublisher;
use egui::{Color32, ColorImage, Painter, Rect, TextureHandle, TextureOptions, pos2};

/// Textures by what is in them: a picture that is built anew each frame and is the same is not uploaded again. One that
/// was not painted for a frame is freed.
type KeptTextures = FramePublisher<(u64, [usize; 2], bool), TextureHandle>;

/// Paints rows of sRGB pixels with straight opacity.
pub(crate) fn paint_picture(
    painter: &Painter,
    rect: Rect,
    [width, height]: [usize; 2],
    rgba: &[u8],
    smooth: bool,
) {
    if width == 0 || height == 0 || rgba.len() != 4 * width * height {
        return;
    }
    let ctx = painter.ctx();
    let key = (egui::util::hash(rgba), [width, height], smooth);
    let kept = ctx.memory_mut(|memory| memory.caches.cache::<KeptTextures>().get(&key).cloned());
    let texture = kept.unwrap_or_else(|| {
        let options = if smooth {
            TextureOptions::LINEAR
        } else {
            TextureOptions::NEAREST
        };
        let image = ColorImage::from_rgba_unmultiplied([width, height], rgba);
        ctx.load_texture("picture", image, options)
    });
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.image(texture.id(), rect, whole, Color32::WHITE);
    ctx.memory_mut(|memory| memory.caches.cache::<KeptTextures>().set(key, texture));
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::RawInput;

    /// The number of textures after each of some frames, every one of which paints the given pictures.
    fn textures(frames: &[&[[u8; 4]]]) -> Vec<usize> {
        let ctx = egui::Context::default();
        let count = |ctx: &egui::Context| ctx.tex_manager().read().num_allocated();
        let run = |pictures: &[[u8; 4]]| {
            let mut output = ctx.run_ui(RawInput::default(), |ui| {
                for rgba in pictures {
                    paint_picture(ui.painter(), Rect::EVERYTHING, [1, 1], rgba, false);
                }
            });
            output.textures_delta.clear();
            count(&ctx)
        };
        let before = run(&[]);
        frames
            .iter()
            .map(|pictures| run(pictures) - before)
            .collect()
    }

    #[test]
    fn the_same_picture_is_one_texture_and_an_old_one_is_freed() {
        let (a, b) = ([1, 2, 3, 255], [4, 5, 6, 255]);
        assert_eq!(textures(&[&[a], &[a, a], &[a]]), [1, 1, 1]);
        assert_eq!(textures(&[&[a, b], &[b], &[b], &[]])[2..], [1, 0]);
        assert_eq!(textures(&[&[a], &[]])[1], 0);
    }
}
