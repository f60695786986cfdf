//! The sphere pass inside egui's picture: a paint callback, and what it keeps on the GPU between frames.

use crate::app::msg::work::Work;
use crate::app::state::State;
use crate::app::state::material::{Material, MaterialId, Opened};
use crate::app::state::memory::on_gpu;
use crate::app::views::sphere::settings::SphereSettings;
use crate::app::views::sphere::{SphereOnScreen, error};
use crate::geom::sight::Sight;
use crate::geom::sphere_error::SphereError;
use crate::gpu::sphere_pass::{SpherePass, SphereSlot, SphereUniform};
use crate::gpu::table_texture::TableTexture;
use crate::measured::Table;
use eframe::egui_wgpu::{
    Callback, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor,
};
use eframe::wgpu;
use egui::PaintCallbackInfo;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock, Weak};

/// Content of a sphere on screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Half {
    /// The data.
    Measured,
    /// The model.
    Model,
    /// Data left of a line at this place in units of the radius, model right of it.
    Split(f64),
    /// Error of the model against the data.
    Error(SphereError),
}

impl Half {
    /// The place of the line, far outside where there is only one.
    fn split(self) -> f64 {
        match self {
            Self::Measured | Self::Error(_) => 2.0,
            Self::Model => -2.0,
            Self::Split(at) => at,
        }
    }
}

/// Prepares the renderer, once. Pipelines take long to compile: that is work for the time in which a material is read. A
/// sphere that is shown sooner compiles them itself.
pub fn install(render_state: &RenderState) -> Work {
    let format = render_state.target_format;
    let pass = Arc::new(OnceLock::new());
    let (making, device) = (Arc::clone(&pass), render_state.device.clone());
    let work = Work::new("preparing the sphere", move |_| {
        making.get_or_init(|| SpherePass::new(&device, format));
    });
    let kept = SphereResources {
        format,
        pass,
        tables: HashMap::new(),
        slots: HashMap::new(),
    };
    render_state
        .renderer
        .write()
        .callback_resources
        .insert(kept);
    work
}

/// Adds a sphere to the picture.
pub fn paint(
    painter: &egui::Painter,
    sphere: &SphereOnScreen,
    state: &State,
    material: &Material,
    opened: &Opened,
) {
    let radius_px = 0.5 * sphere.rect.width() * painter.ctx().pixels_per_point();
    let scene = &state.scene;
    let uniform = SphereUniform::new(
        &scene.views.get::<SphereSettings>().view,
        &opened.brdf,
        scene.lookup,
        sphere.half.split(),
        radius_px,
    );
    let Sight { zoom, center } = scene.views.get::<SphereSettings>().sight;
    let uniform = uniform.in_sight(center, zoom);
    let (uniform, compared) = match sphere.half {
        Half::Error(error) => (uniform.comparing(error, &error::colors(error)), true),
        _ => (uniform, false),
    };
    let callback = SphereCallback {
        // Two spheres are told apart by what they show. Without data all are the same.
        key: (
            (material.table.valid_count() > 0).then_some(opened.id),
            matches!(sphere.half, Half::Model) || compared,
        ),
        compared,
        table: Arc::clone(&material.table),
        kept: kept(state),
        uniform,
    };
    painter.add(Callback::new_paint_callback(sphere.frame, callback));
}

/// The materials whose textures are worth keeping, and the one that stands in where there are no data.
fn kept(state: &State) -> Vec<Option<MaterialId>> {
    let lately = on_gpu(state).into_iter().map(Some);
    lately.chain([None]).collect()
}

/// `None` where there are no data.
type SlotKey = (Option<MaterialId>, bool);

/// Resources that stay on the GPU.
struct SphereResources {
    format: wgpu::TextureFormat,
    pass: Arc<OnceLock<SpherePass>>,
    /// Textures with the tables they are of.
    tables: HashMap<Option<MaterialId>, (Weak<Table>, TableTexture)>,
    slots: HashMap<SlotKey, SphereSlot>,
}

struct SphereCallback {
    key: SlotKey,
    compared: bool,
    table: Arc<Table>,
    kept: Vec<Option<MaterialId>>,
    uniform: SphereUniform,
}

impl CallbackTrait for SphereCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let Some(SphereResources {
            format,
            pass,
            tables,
            slots,
        }) = resources.get_mut::<SphereResources>()
        else {
            return Vec::new();
        };
        let (own, data) = (self.key.0, Arc::downgrade(&self.table));
        // Data that were let go and read again may be others.
        tables.retain(|id, (of, _)| match *id == own {
            true => of.ptr_eq(&data),
            false => self.kept.contains(id),
        });
        slots.retain(|(id, _), _| tables.contains_key(id));
        let pass = pass.get_or_init(|| SpherePass::new(device, *format));
        let (_, table) = tables.entry(own).or_insert_with(|| {
            let texture = if self.table.valid_count() == 0 {
                TableTexture::empty(device, queue)
            } else {
                TableTexture::upload(device, queue, &self.table)
            };
            (data, texture)
        });
        slots
            .entry(self.key)
            .or_insert_with(|| pass.slot(device, table))
            .write(queue, &self.uniform);
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(kept) = resources.get::<SphereResources>()
            && let Some(sphere) = kept.pass.get()
            && let Some(slot) = kept.slots.get(&self.key)
        {
            if self.compared {
                sphere.draw_compared(pass, slot);
            } else {
                sphere.draw(pass, slot);
            }
        }
    }
}
