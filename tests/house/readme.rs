//! The README holds what it promises: its pictures are there, and those of the gallery have their commands.

use std::fs;
use std::path::Path;

fn readme() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    fs::read_to_string(path).expect("the README")
}

/// The paths of the pictures in a text.
fn pictures(text: &str) -> Vec<&str> {
    let marks = text.split("](").skip(1);
    marks
        .filter_map(|rest| rest.split(')').next())
        .filter(|path| path.ends_with(".png"))
        .collect()
}

/// Pictures of the gallery without a command right below that writes them.
fn without_command(gallery: &str) -> Vec<&str> {
    let parts: Vec<&str> = gallery.split("![").skip(1).collect();
    let names = parts.iter().map(|part| pictures(part)[0]);
    names
        .zip(&parts)
        .filter(|(path, part)| {
            let name = path.rsplit('/').next().unwrap_or_default();
            let mut commands = part.lines().filter(|line| line.starts_with("grazing "));
            !commands.any(|line| line.contains(&format!("-o {name}")))
        })
        .map(|(path, _)| path)
        .collect()
}

fn gallery(readme: &str) -> &str {
    let (_, rest) = readme.split_once("## Gallery").expect("a gallery");
    rest.split_once("\n## ")
        .map_or(rest, |(gallery, _)| gallery)
}

#[test]
fn every_picture_is_there() {
    let readme = readme();
    let all = pictures(&readme);
    assert!(all.len() > 8, "{all:?}");
    for path in all {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
        let picture = image::open(&file).unwrap_or_else(|error| panic!("{path}: {error}"));
        assert!(picture.width() >= 300, "{path}");
    }
}

#[test]
fn every_picture_of_the_gallery_has_its_command() {
    let readme = readme();
    assert_eq!(without_command(gallery(&readme)), Vec::<&str>::new());
    // Planted: a command that writes something else.
    let planted = readme.replace("-o lobes.png", "-o lobe.png");
    assert_eq!(
        without_command(gallery(&planted)),
        ["assets/gallery/lobes.png"]
    );
}
