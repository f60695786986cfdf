//! One panel: the drawing that the window shows, and the numbers in it.

use super::fit_output::FitOutput;
use super::panel_io::{PanelDrawing, PanelInput};
use super::spec::{ErrorMapSpec, LandscapePanel, Lobe3dSpec, ViewSpec};
use super::sphere::sphere;
use crate::figure::albedo::{AlbedoCurve, AlbedoPlot, AlbedoSpec, curve};
use crate::figure::drawing::Drawing;
use crate::figure::error_map::ErrorSpec;
use crate::figure::heatmap::{ColorScale, HeatMap};
use crate::figure::image_slice::{ImageSpec, Shown};
use crate::figure::landscape::LandscapeSpec;
use crate::figure::lobe3d::{Detail, Lobes, Overlay, Shape, picture};
use crate::figure::lobes::{LobePlot, LobeSpec};
use crate::figure::palette::Role;
use crate::figure::scatter::{ScatterDot, ScatterPlot};
use crate::figure::slices::{SlicePlot, SliceSpec};
use crate::figure::subject::Source;
use crate::figure::table::Table;
use std::ops::ControlFlow;

pub(super) fn draw(view: &ViewSpec, input: &PanelInput) -> PanelDrawing {
    match view {
        ViewSpec::Sphere(spec) => sphere(spec, input),
        ViewSpec::Lobes(spec) => lobes(spec, input),
        ViewSpec::Slices(spec) => slices(spec, input),
        ViewSpec::ImageSlice(spec) => image_slice(spec, input),
        ViewSpec::Albedo(spec) => albedo(spec, input),
        ViewSpec::Lobe3d(spec) => lobe3d(spec, input),
        ViewSpec::ErrorMap(spec) => error_map(spec, input),
        ViewSpec::Landscape(spec) => landscape(spec, input),
        ViewSpec::Scatter => scatter(input),
    }
}

fn lobes(spec: &LobeSpec, input: &PanelInput) -> PanelDrawing {
    let spec = LobeSpec {
        still: true,
        ..spec.clone()
    };
    let plot = LobePlot::new(&spec, input.subjects, input.size);
    PanelDrawing {
        table: Table::of_lobes(&plot, &spec, input.named),
        axis: Some(plot.frame.axis),
        drawing: plot.drawing,
    }
}

fn slices(spec: &SliceSpec, input: &PanelInput) -> PanelDrawing {
    let plot = SlicePlot::new(spec, input.subjects, input.size);
    PanelDrawing {
        table: Table::of_slices(&plot, spec, input.named),
        axis: Some(plot.frame.y),
        drawing: plot.drawing,
    }
}

fn image_slice(spec: &ImageSpec, input: &PanelInput) -> PanelDrawing {
    let (measured, model) = (input.source(true), input.source(false));
    let field = spec.field(measured, model);
    let of_data = ImageSpec {
        shown: Shown::Measured,
        ..spec.clone()
    };
    // Data and model have the colours of the data, where there are some.
    let reference = match (spec.shown, measured) {
        (Shown::Model, Some(_)) => of_data.field(measured, None),
        _ => field.clone(),
    };
    let heat = spec.heat_spec(input.name, &field, &reference);
    let axis = match heat.colors {
        ColorScale::Amount(axis) => Some(axis),
        _ => None,
    };
    PanelDrawing {
        table: Table::of_image(spec, &field),
        axis,
        drawing: HeatMap::new(&heat, &field, input.size).drawing,
    }
}

fn albedo(spec: &AlbedoSpec, input: &PanelInput) -> PanelDrawing {
    let curves: Vec<_> = input
        .subjects
        .iter()
        .map(|subject| curve(&subject.source, || ControlFlow::Continue(())).unwrap_or_default())
        .collect();
    let seen: Vec<AlbedoCurve> = curves
        .iter()
        .map(|points| AlbedoCurve { points, old: false })
        .collect();
    let plot = AlbedoPlot::new(spec, input.subjects, &seen, input.size);
    PanelDrawing {
        table: Table::of_albedos(spec.channel, input.named, &curves),
        axis: Some(plot.frame.y),
        drawing: plot.drawing,
    }
}

fn lobe3d(spec: &Lobe3dSpec, input: &PanelInput) -> PanelDrawing {
    let shape = Shape {
        theta_i: spec.theta_i,
        scale: spec.scale,
        with_cosine: spec.with_cosine,
        channel: spec.channel,
        detail: Detail::Fine,
    };
    let lobes = Lobes::new(shape, input.subjects, None);
    let overlay = Overlay::new(&lobes, spec.camera, None, input.size);
    let space = picture(
        &lobes,
        &overlay.projection,
        input.palette,
        input.size,
        input.density,
    );
    let mut drawing = Drawing::new(input.size);
    drawing.items.push(space);
    drawing.items.extend(overlay.drawing.items);
    PanelDrawing {
        drawing,
        ..PanelDrawing::default()
    }
}

fn error_map(spec: &ErrorMapSpec, input: &PanelInput) -> PanelDrawing {
    let Some(FitOutput::ErrorMap {
        parts,
        columns,
        total,
        channels,
    }) = input.made
    else {
        return PanelDrawing::default();
    };
    let shown = ErrorSpec {
        plane: spec.plane,
        scale: spec.scale,
        view: spec.view,
        total: *total,
        channels: *channels,
        spots: Vec::new(),
    };
    let field = shown.field(parts, *columns);
    let heat = shown.heat_spec(input.name, &field);
    let names = match spec.plane {
        crate::figure::error_map::Plane::Directions => ["theta_i", "theta_o", "percent_of_e"],
        crate::figure::error_map::Plane::HalfDiff => ["theta_h", "theta_d", "percent_of_e"],
    };
    PanelDrawing {
        table: Table::of_cells(names, &field),
        axis: None,
        drawing: HeatMap::new(&heat, &field, input.size).drawing,
    }
}

fn landscape(spec: &LandscapePanel, input: &PanelInput) -> PanelDrawing {
    let Some(FitOutput::Landscape { terrain, best }) = input.made else {
        return PanelDrawing::default();
    };
    let eta = match (spec.fresnel.as_str(), spec.eta) {
        ("none", _) => "no Fresnel".to_string(),
        (_, Some(eta)) => format!("η = {}", crate::figure::scale::number(eta)),
        (_, None) => "η solved".to_string(),
    };
    let shown = LandscapeSpec {
        eta,
        view: spec.view,
        path: spec.path.clone(),
        here: spec.here,
        best: *best,
    };
    let field = terrain.field();
    let heat = shown.heat_spec(input.name, terrain);
    PanelDrawing {
        table: Table::of_terrain(terrain),
        axis: None,
        drawing: HeatMap::new(&heat, &field, input.size).drawing,
    }
}

/// The models by s and α of the combined model, in the colours of their series.
fn scatter(input: &PanelInput) -> PanelDrawing {
    let dots: Vec<ScatterDot> = input
        .subjects
        .iter()
        .filter_map(|subject| {
            let Source::Model(brdf) = &subject.source else {
                return None;
            };
            Some(ScatterDot {
                name: subject.label.clone(),
                s: brdf.params.s,
                alpha: brdf.params.alpha,
                fill: Role::Series(subject.series),
                ring: None,
                shown: false,
            })
        })
        .collect();
    PanelDrawing {
        table: Table::of_dots(&dots),
        axis: None,
        drawing: ScatterPlot::new(&dots, None, input.size).drawing,
    }
}
