//! What a package has beside the program, made from the program itself: manual pages, shell completions and icons, under
//! a folder that is laid out like /usr/share.
//!
//! A program of its own, so that Grazing neither carries nor builds what only a package needs.

use clap_complete::Shell;
use image::imageops::FilterType;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const NAME: &str = "grazing";
/// Sides of the icons in pixels; the picture itself has the largest.
const ICON_SIDES: [u32; 7] = [16, 24, 32, 48, 64, 128, 256];
/// Where each shell looks for completions.
const COMPLETIONS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions/grazing"),
    (Shell::Zsh, "zsh/vendor-completions/_grazing"),
    (Shell::Fish, "fish/vendor_completions.d/grazing.fish"),
];

fn main() -> ExitCode {
    let Some(share) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("grazing-packaging: no folder; expected the share folder of a package");
        return ExitCode::from(2);
    };
    match write_all(&share) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("grazing-packaging: {error}: {}", share.display());
            ExitCode::FAILURE
        }
    }
}

fn write_all(share: &Path) -> Result<(), Box<dyn Error>> {
    let man = share.join("man/man1");
    fs::create_dir_all(&man)?;
    clap_mangen::generate_to(grazing::cli::command(), &man)?;
    for (shell, place) in COMPLETIONS {
        let mut text = Vec::new();
        clap_complete::generate(shell, &mut grazing::cli::command(), NAME, &mut text);
        write(&share.join(place), &text)?;
    }
    let icon = image::load_from_memory(include_bytes!("../../assets/icon.png"))?;
    for side in ICON_SIDES {
        let place = format!("icons/hicolor/{side}x{side}/apps/grazing.png");
        let place = share.join(place);
        create_folder_of(&place)?;
        icon.resize_exact(side, side, FilterType::Lanczos3)
            .save(&place)?;
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    create_folder_of(path)?;
    Ok(fs::write(path, bytes)?)
}

fn create_folder_of(path: &Path) -> Result<(), Box<dyn Error>> {
    match path.parent() {
        Some(folder) => Ok(fs::create_dir_all(folder)?),
        None => Ok(()),
    }
}
