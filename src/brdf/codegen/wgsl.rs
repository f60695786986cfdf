//! Export of a model as a WGSL function to paste.

use super::items::WgslItems;
use super::parts::{USE, ascii, entry, head, library};
use crate::brdf::Brdf;

/// WGSL text that defines `fn brdf(wi: vec3f, wo: vec3f) -> vec3f`, the twin of [`Brdf::f_r`] with 0 below the horizon.
///
/// `material` is named in the head of the text. Every other name that it defines begins with `brdf_` or `Brdf`.
pub fn wgsl(brdf: &Brdf, material: Option<&str>) -> String {
    let items = WgslItems::new(&[&library(brdf), &entry(brdf)]);
    ascii(&(head(brdf, material, "//") + USE + &items.needed_by("brdf")))
}
