//! stub
use std::path::Path; use std::io::Write; use std::ops::ControlFlow;
use crate::measured::{Table, merl};
pub fn open_table(path: &Path, progress: &mut dyn FnMut(f32) -> ControlFlow<()>) -> Result<Table, String> {
    let f = std::fs::File::open(path).map_err(|e| e.to_string())?; let len = f.metadata().map_err(|e| e.to_string())?.len();
    merl::read(f, len, progress).map_err(|e| format!("{e}: {}", path.display()))
}
pub fn material_name(path: &Path) -> String { path.file_stem().unwrap_or_default().display().to_string() }
pub fn write_atomically(path: &Path, _force: bool, f: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), String> { let mut o = std::fs::File::create(path).map_err(|e| e.to_string())?; f(&mut o).map_err(|e| e.to_string()) }
