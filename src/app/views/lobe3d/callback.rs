//! The lobes in space inside egui's picture: a paint callback, and what it keeps on the GPU between frames.

use crate::figure::lobe3d::{Lobes, SpaceProjection, ground, wires};
use crate::figure::palette::{Ink, Palette, Role};
use crate::gpu::lobe3d_pass::{
    FlatVertex, LinePiece, SolidVertex, SpacePass, SpacePicture, SpaceScene, SpaceView,
};
use eframe::egui_wgpu::{
    Callback, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor,
};
use eframe::wgpu;
use egui::{PaintCallbackInfo, Rect};
use glam::DVec3;
use std::sync::Arc;

/// Prepares the renderer, once. Pipelines are compiled when the tile is first seen.
pub fn install(render_state: &RenderState) {
    let kept = Lobe3dResources {
        format: render_state.target_format,
        pass: None,
        picture: None,
    };
    render_state
        .renderer
        .write()
        .callback_resources
        .insert(kept);
}

/// Adds the lobes to the picture.
pub fn paint(
    ui: &egui::Ui,
    rect: Rect,
    lobes: &Arc<Lobes>,
    wo: Option<DVec3>,
    projection: &SpaceProjection,
    palette: &Palette,
) {
    let density = ui.ctx().pixels_per_point();
    let [width, height] = [rect.width(), rect.height()];
    let pixels = |points: f32| (points * density).round().max(1.0) as u32;
    let in_px = |points: f32| f64::from(points * density);
    let view = SpaceView {
        rotation: projection.camera.rotation,
        center: projection.camera.center,
        offset_px: [
            in_px(projection.middle[0] - 0.5 * width),
            in_px(projection.middle[1] - 0.5 * height),
        ],
        scale_px: projection.scale * f64::from(density),
        size_px: [pixels(width), pixels(height)],
        density,
    };
    let scene = scene_of(ui, lobes, wo, palette);
    let callback = Lobe3dCallback { scene, view };
    ui.painter()
        .add(Callback::new_paint_callback(rect, callback));
}

/// Inputs of a scene, and the scene.
#[derive(Clone)]
struct MadeScene {
    lobes: Arc<Lobes>,
    wo: Option<DVec3>,
    palette: Palette,
    scene: Arc<SpaceScene>,
}

/// The scene, made again where an input has changed.
fn scene_of(
    ui: &egui::Ui,
    lobes: &Arc<Lobes>,
    wo: Option<DVec3>,
    palette: &Palette,
) -> Arc<SpaceScene> {
    let id = ui.scope_id().with("scene");
    let made: Option<MadeScene> = ui.data(|data| data.get_temp(id));
    if let Some(made) = made
        && Arc::ptr_eq(&made.lobes, lobes)
        && made.wo == wo
        && made.palette == *palette
    {
        return made.scene;
    }
    let scene = Arc::new(scene(lobes, wo, palette));
    let made = MadeScene {
        lobes: Arc::clone(lobes),
        wo,
        palette: *palette,
        scene: Arc::clone(&scene),
    };
    ui.data_mut(|data| data.insert_temp(id, made));
    scene
}

fn scene(lobes: &Lobes, wo: Option<DVec3>, palette: &Palette) -> SpaceScene {
    let mut scene = SpaceScene::default();
    let (fills, mut lines) = ground(lobes, wo);
    lines.extend(wires(lobes, palette));
    for fill in &fills {
        let color = palette.resolve(fill.ink);
        let corner = |p: DVec3| FlatVertex {
            position: p.as_vec3().to_array(),
            color,
        };
        for pair in fill.points.windows(2).skip(1) {
            scene
                .flat
                .extend([fill.points[0], pair[0], pair[1]].map(corner));
        }
    }
    for line in &lines {
        let color = palette.resolve(line.ink);
        add_line(&mut scene, &line.points, line.width, line.behind, color);
    }
    for lobe in lobes.list.iter().filter(|lobe| lobe.is_solid()) {
        let Some(mesh) = &lobe.mesh else {
            continue;
        };
        let color = palette.resolve(Ink::from(Role::Series(lobe.subject.series)));
        let first = scene.solid.len() as u32;
        let corners = mesh.positions.iter().zip(&mesh.normals);
        scene
            .solid
            .extend(corners.map(|(position, normal)| SolidVertex {
                position: position.as_vec3().to_array(),
                normal: normal.as_vec3().to_array(),
                color,
            }));
        let corners = mesh.triangles.iter().flatten();
        scene.triangles.extend(corners.map(|index| first + index));
    }
    scene
}

fn add_line(scene: &mut SpaceScene, points: &[DVec3], width: f32, behind: f32, color: [u8; 4]) {
    scene.lines.extend(points.windows(2).map(|pair| LinePiece {
        start: pair[0].as_vec3().to_array(),
        width,
        end: pair[1].as_vec3().to_array(),
        behind,
        color,
    }));
}

/// Resources that stay on the GPU.
struct Lobe3dResources {
    format: wgpu::TextureFormat,
    pass: Option<SpacePass>,
    picture: Option<(Arc<SpaceScene>, SpacePicture)>,
}

struct Lobe3dCallback {
    scene: Arc<SpaceScene>,
    view: SpaceView,
}

impl CallbackTrait for Lobe3dCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let Some(kept) = resources.get_mut::<Lobe3dResources>() else {
            return Vec::new();
        };
        let pass = kept
            .pass
            .get_or_insert_with(|| SpacePass::new(device, kept.format));
        let mut picture = match kept.picture.take() {
            Some((scene, picture)) if Arc::ptr_eq(&scene, &self.scene) => picture,
            before => {
                let mut picture = pass.picture(device, &self.scene);
                if let Some((_, before)) = before {
                    picture.inherit(before);
                }
                picture
            }
        };
        pass.render(device, queue, encoder, &mut picture, &self.view);
        kept.picture = Some((Arc::clone(&self.scene), picture));
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(Lobe3dResources {
            pass: Some(space),
            picture: Some((_, picture)),
            ..
        }) = resources.get::<Lobe3dResources>()
        {
            space.blit(pass, picture);
        }
    }
}
