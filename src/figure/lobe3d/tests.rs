use super::*;
use crate::brdf::fresnel::Fresnel;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, COMBINED, Params};
use crate::figure::cosine::CosineFactor;
use crate::figure::palette::{Palette, Role};
use crate::figure::scale::RadialScale;
use crate::figure::subject::{Channel, Look, Source, Subject};
use crate::geom::{Rgb, direction, mirror};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, TAU};
use std::sync::Arc;

const SIZE: [f32; 2] = [640.0, 420.0];

fn shape(theta_i_deg: f64) -> Shape {
    Shape {
        theta_i: theta_i_deg.to_radians(),
        scale: RadialScale::CubeRoot,
        cosine: CosineFactor::NONE,
        channel: Channel::Luminance,
        detail: Detail::Fine,
    }
}

fn subject(source: Source) -> Subject {
    Subject {
        label: "grey".to_string(),
        look: Look::Measured,
        series: 0,
        hidden: false,
        source,
    }
}

fn function(f_r: impl Fn(DVec3, DVec3) -> Option<Rgb> + Send + Sync + 'static) -> Subject {
    subject(Source::Function(Arc::new(f_r)))
}

fn lambert() -> Subject {
    function(|_, _| Some([0.5 * FRAC_1_PI; 3]))
}

fn glossy() -> Subject {
    subject(Source::Model(Brdf {
        model: &COMBINED,
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [50.0; 3],
            lobe: lobe_values([800.0, 0.3]),
            eta: 1.5,
        },
    }))
}

fn mesh_of(lobes: &Lobes) -> &LobeMesh {
    lobes.meshes().next().expect("a lobe that is shown")
}

/// Largest angle in radians from a direction of the dome to the nearest of these.
fn farthest_from(all: &[DVec3]) -> f64 {
    let spread = (0..400).map(|k| {
        let (u, v) = (f64::from(k) / 400.0, f64::from(k) * 0.618_034);
        direction(u.acos(), TAU * v.fract())
    });
    spread
        .map(|w| all.iter().map(|knot| knot.dot(w)).fold(-1.0, f64::max))
        .map(|cos| cos.min(1.0).acos())
        .fold(0.0, f64::max)
}

#[test]
fn a_layout_covers_the_dome_and_is_fine_around_the_mirror_direction() {
    for (degrees, detail, farthest, hair) in
        [0.0, 45.0, 80.0, 89.5_f64].into_iter().flat_map(|at| {
            [
                (at, Detail::Fine, 0.09, 2e-4),
                (at, Detail::Coarse, 0.18, 7e-4),
            ]
        })
    {
        let all = layout(degrees.to_radians(), detail);
        let (rings, spokes) = (detail.rings(), detail.spokes());
        assert_eq!(all.len(), 1 + rings * spokes);
        assert!((all[0] - mirror(shape(degrees).wi())).length() < 1e-12);
        assert!(
            all.iter()
                .all(|w| w.z >= 0.0 && (w.length() - 1.0).abs() < 1e-12)
        );
        assert!(all[all.len() - spokes..].iter().all(|w| w.z == 0.0));
        // No direction of the dome is far from a knot, none beside the mirror direction is farther than a hair.
        let far = farthest_from(&all);
        assert!(far < farthest, "{degrees}: {}°", far.to_degrees());
        let planted = farthest_from(&all[..all.len() - rings / 5 * spokes]);
        assert!(planted > farthest, "a bare rim went unnoticed");
        let second = all[1..=spokes].iter().map(|w| w.angle_between(all[0]));
        assert!(second.fold(0.0, f64::max) < hair);
    }
}

/// Largest distance of what a mesh shows from f_r, relative to f_r; `factor` is a planted error.
fn worst_distance(shape: Shape, subject: &Subject, factor: f64) -> f64 {
    let lobes = Lobes::new(shape, std::slice::from_ref(subject), None);
    let mut worst: f64 = 0.0;
    for position in &mesh_of(&lobes).positions {
        // At the floor of a logarithmic axis there is no direction left.
        let Some(wo) = position.try_normalize() else {
            continue;
        };
        let wo = wo.with_z(wo.z.max(0.0));
        let f_r = subject.source.f_r(shape.wi(), wo).expect("a value");
        let mut cosine = 1.0;
        if shape.cosine.theta_i {
            cosine *= shape.theta_i.cos();
        }
        if shape.cosine.theta_o {
            cosine *= wo.z;
        }
        let wanted = factor * cosine * shape.channel.of(f_r);
        let shown = lobes.axis.value(position.length());
        worst = worst.max((shown - wanted).abs() / wanted);
    }
    worst
}

#[test]
fn a_mesh_is_f_r_in_every_direction() {
    for scale in crate::figure::scale::RADIAL_SCALES {
        for (channel, detail) in [
            (Channel::Luminance, Detail::Fine),
            (Channel::G, Detail::Coarse),
        ] {
            let shape = Shape {
                detail,
                scale,
                channel,
                cosine: if channel == Channel::G {
                    CosineFactor::BOTH
                } else {
                    CosineFactor::NONE
                },
                ..shape(60.0)
            };
            let worst = worst_distance(shape, &glossy(), 1.0);
            assert!(worst < 1e-6, "{shape:?}: {worst:e}");
            assert!(worst_distance(shape, &glossy(), 1.001) > 1e-4);
        }
    }
}

/// Area of a mesh, and its volume, which knows the sense of the triangles.
fn area_and_volume(mesh: &LobeMesh) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|index| mesh.positions[index as usize]);
        sums[0] += 0.5 * (b - a).cross(c - a).length();
        sums[1] += a.dot(b.cross(c)) / 6.0;
    }
    sums
}

#[test]
fn the_lobe_of_a_diffuse_surface_is_a_half_sphere() {
    for degrees in [0.0, 50.0, 85.0] {
        let lobes = Lobes::new(shape(degrees), &[lambert()], None);
        let r = lobes.axis.position(0.5 * FRAC_1_PI);
        let [area, volume] = area_and_volume(mesh_of(&lobes));
        let wanted = [TAU * r * r, TAU / 3.0 * r.powi(3)];
        assert!((area / wanted[0] - 1.0).abs() < 0.01, "{area} {wanted:?}");
        assert!(
            (volume / wanted[1] - 1.0).abs() < 0.01,
            "{volume} {wanted:?}"
        );
        let mesh = mesh_of(&lobes);
        for (position, normal) in mesh.positions.iter().zip(&mesh.normals) {
            let w = position.normalize();
            // At the horizon under grazing light the triangles are flatter than the sphere between their corners.
            let least = if w.z < 0.02 { 0.85 } else { 0.97 };
            let cos = normal.dot(w);
            assert!(cos > least, "{degrees}: {position} {cos}");
        }
        let mut planted = mesh.clone();
        planted.positions.iter_mut().for_each(|p| *p *= 1.02);
        let wrong = area_and_volume(&planted);
        assert!((0..2).all(|k| (wrong[k] / wanted[k] - 1.0).abs() > 0.01));
        planted.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        assert!(area_and_volume(&planted)[1] < 0.0, "inside out");
    }
}

#[test]
fn nothing_is_drawn_where_nothing_was_measured() {
    let limit = 60_f64.to_radians().cos();
    let gap = function(move |_, wo| (wo.z > limit).then_some([1.0; 3]));
    let lobes = Lobes::new(shape(30.0), &[gap], None);
    let mesh = mesh_of(&lobes);
    assert!(mesh.triangles.len() > 1000);
    let corners = mesh.triangles.iter().flatten();
    let lowest = corners.map(|index| {
        let p = mesh.positions[*index as usize];
        p.z / p.length()
    });
    assert!(lowest.fold(1.0, f64::min) > limit - 1e-9);
    for line in mesh.wire() {
        assert!(line.iter().all(|p| p.length() > 0.5), "a line to zero");
    }
    let none = function(|_, _| None);
    let lobes = Lobes::new(shape(30.0), &[none], None);
    assert!(mesh_of(&lobes).triangles.is_empty() && mesh_of(&lobes).wire().is_empty());
}

#[test]
fn only_what_changed_is_made_again() {
    let subjects = [lambert(), glossy()];
    let first = Lobes::new(shape(40.0), &subjects, None);
    assert!(first.are_of(&shape(40.0), &subjects));
    let scaled = Shape {
        scale: RadialScale::Log,
        ..shape(40.0)
    };
    assert!(!first.are_of(&scaled, &subjects));
    let second = Lobes::new(scaled, &subjects, Some(&first));
    assert!(Arc::ptr_eq(&first.list[0].samples, &second.list[0].samples));
    let turned = Lobes::new(shape(41.0), &subjects, Some(&first));
    assert!(!Arc::ptr_eq(
        &first.list[0].samples,
        &turned.list[0].samples
    ));
    let hidden = Subject {
        hidden: true,
        ..glossy()
    };
    let without = Lobes::new(shape(40.0), &[lambert(), hidden], None);
    assert!(without.list[1].mesh.is_none());
    assert!(
        without.axis.limit < first.axis.limit,
        "the axis follows what is shown"
    );
}

#[test]
fn the_direction_under_a_point_is_the_nearest_one_of_the_surface() {
    let lobes = Lobes::new(shape(45.0), &[glossy()], None);
    let projection = Overlay::new(&lobes, Camera::default(), None, SIZE).projection;
    // The front of the diffuse base, and the peak.
    for wo in [
        direction(1.0, -FRAC_PI_2),
        direction(0.2, -1.2),
        direction(45_f64.to_radians(), 0.0),
    ] {
        let value = lobes.shape.value(&lobes.list[0].subject.source, wo);
        let radius = lobes.axis.position(value.expect("a value"));
        let mut at = projection.point(radius * wo);
        // Just inside the silhouette of the peak.
        let foot = projection.point(DVec3::ZERO);
        at = [0, 1].map(|k| at[k] + 0.01 * (foot[k] - at[k]));
        let found = pick(lobes.meshes(), &projection, at).expect("on the lobe");
        let off = found.angle_between(wo).to_degrees();
        assert!(off < 3.0, "{wo}: {off}°");
        let mirrored = DVec3::new(wo.x, -wo.y, wo.z);
        assert!(wo.y == 0.0 || found.angle_between(mirrored) > 0.1);
    }
    assert_eq!(pick(lobes.meshes(), &projection, [2.0, 2.0]), None);
}

#[test]
fn the_camera_turns_under_the_hand_and_zooms_around_the_pointer() {
    let start = SpaceProjection::new(Camera::default(), [0.0, 20.0], SIZE);
    let light = start.point(-DVec3::X);
    let mirror_side = start.point(DVec3::X);
    assert!(light[0] < mirror_side[0], "light comes from the left");
    assert!(start.point(DVec3::Z)[1] < start.point(DVec3::ZERO)[1]);

    let at = [420.0, 180.0];
    let near = start.unproject(at);
    let zoomed = SpaceProjection::new(start.zoomed(1.7, at), [0.0, 20.0], SIZE);
    let same = zoomed.unproject(at);
    assert!((near[0] - same[0]).hypot(near[1] - same[1]) < 1e-9);
    assert!((zoomed.scale / start.scale - 1.7).abs() < 1e-9);

    // What is in front goes where the hand goes.
    let [x, y] = start.middle;
    let turned = SpaceProjection::new(start.dragged([x, y], [x + 60.0, y]), [0.0, 20.0], SIZE);
    let in_front = start.camera.rotation.inverse() * DVec3::Z;
    assert!(turned.view(in_front).x > 0.1);
    assert!((turned.camera.rotation.length() - 1.0).abs() < 1e-12);
    let far = start.dragged([x, y], [x + 1e5, y - 1e5]);
    assert!(far.rotation.is_finite());
}

#[test]
fn vectors_and_the_probe_are_named_and_marked() {
    let lobes = Lobes::new(shape(45.0), &[lambert(), glossy()], None);
    let wo = direction(0.6, -0.8);
    let texts = |overlay: &Overlay| -> Vec<String> {
        let label = |label: &crate::figure::Label| {
            let runs = label.text.runs.iter();
            runs.map(|run| run.text.as_str()).collect()
        };
        overlay.drawing.labels().map(label).collect()
    };
    let without = Overlay::new(&lobes, Camera::default(), None, SIZE);
    let with = Overlay::new(&lobes, Camera::default(), Some(wo), SIZE);
    assert!(texts(&without).contains(&"ωr".to_string()));
    assert!(!texts(&without).contains(&"ωo".to_string()));
    assert!(texts(&with).contains(&"ωo".to_string()));
    assert_eq!(with.legend.len(), 2);
    let dots = |overlay: &Overlay| {
        let items = overlay.drawing.items.iter();
        items
            .filter(|item| matches!(item, crate::figure::Item::Dot { .. }))
            .count()
    };
    assert_eq!((dots(&without), dots(&with)), (0, 2));
    let (fills, lines) = ground(&lobes, Some(wo));
    assert_eq!(fills.len(), 2);
    assert!(lines.iter().all(|line| line.points.len() > 1));
    assert!(lines.iter().any(|line| line.ink.role == Role::Foreground));
    // Small and large: texts stay inside.
    for size in [[300.0, 200.0], [1900.0, 1000.0]] {
        let overlay = Overlay::new(&lobes, Camera::default(), Some(wo), size);
        assert!(overlay.projection.scale > 40.0);
    }
}

#[test]
fn a_picture_in_bands_is_the_whole_one() {
    let mut model = glossy();
    model.look = Look::Model;
    let lobes = Lobes::new(shape(45.0), &[lambert(), model], None);
    let size = [90.0, 60.0];
    let projection = SpaceProjection::new(Camera::default(), [0.0; 2], size);
    let drawn =
        |most| raster::picture_of(&lobes, &projection, &Palette::LIGHT, (size, 2.0), most).rgba;
    let (whole, bands) = (drawn(1 << 20), drawn(1));
    assert_eq!(whole.len(), bands.len());
    let far = |(a, b): &(&[u8], &[u8])| {
        (0..4).any(|k| {
            let seen = |pixel: &[u8]| i32::from(pixel[k]) * i32::from(pixel[3]) / 255;
            (seen(a) - seen(b)).abs() > 1
        })
    };
    let pairs = whole.chunks_exact(4).zip(bands.chunks_exact(4));
    assert_eq!(pairs.filter(far).count(), 0);
    // Planted: another picture.
    let turned = SpaceProjection::new(Camera::default(), [0.0; 2], [90.0, 58.0]);
    let other = raster::picture_of(&lobes, &turned, &Palette::LIGHT, (size, 2.0), 1).rgba;
    let pairs = whole.chunks_exact(4).zip(other.chunks_exact(4));
    assert!(pairs.filter(far).count() > 100);
}
