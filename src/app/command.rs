//! The commands: one list behind menus, shortcuts, tooltips and the palette.

use super::state::{SHOWS, Show, State, Theme};
use crate::brdf::MODELS;
use crate::brdf::fresnel::{FRESNELS, Fresnel};
use crate::figure::scale::{RADIAL_SCALES, RadialScale};
use crate::gpu::sphere::LIGHT_PRESETS;
use crate::measured::lookup::Lookup;
use crate::measured::samples::SAMPLES;
use egui::{Key, KeyboardShortcut, Modifiers};
use std::sync::LazyLock;

/// Something a person can ask for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the rows below say what each one does")]
pub enum Command {
    Open,
    OpenPath,
    OpenSample(usize),
    OpenRecent(usize),
    ClearRecent,
    Close,
    SavePicture,
    Quit,
    Undo,
    Redo,
    CopyParams,
    GuessParams,
    ResetParams,
    UseModel(usize),
    UseFresnel(Fresnel),
    NextMaterial,
    PreviousMaterial,
    UseShow(Show),
    UseLights(usize),
    UseScale(RadialScale),
    ToggleCosine,
    ToggleRaw,
    UseTheme(Theme),
    ResetLayout,
    Palette,
    Conventions,
    About,
}

/// Where a command stands in the menu bar. A second word is a submenu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The menu.
    pub menu: &'static str,
    /// The submenu, empty for none.
    pub submenu: &'static str,
}

/// The menus from left to right.
pub const MENUS: [&str; 5] = ["File", "Edit", "Model", "View", "Help"];

/// A row of the list.
#[derive(Debug)]
pub struct Entry {
    /// What it does.
    pub command: Command,
    /// Where it stands.
    pub place: Place,
    /// Its words.
    pub name: String,
    /// Its keys.
    pub keys: Option<KeyboardShortcut>,
    /// One sentence.
    pub help: String,
}

/// All commands in menu order.
pub static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(entries);

impl Command {
    /// The row of this command; `None` for those that depend on the state (recent files).
    pub fn entry(self) -> Option<&'static Entry> {
        ENTRIES.iter().find(|entry| entry.command == self)
    }

    /// The name with the keys, for tooltips.
    pub fn hint(self, ctx: &egui::Context) -> String {
        let Some(entry) = self.entry() else {
            return String::new();
        };
        match &entry.keys {
            Some(keys) => format!("{} ({})", entry.help, ctx.format_shortcut(keys)),
            None => entry.help.clone(),
        }
    }

    /// Whether it can be done now.
    pub fn is_enabled(self, state: &State) -> bool {
        match self {
            Self::Undo => state.history.can_undo(),
            Self::Redo => state.history.can_redo(),
            Self::Close
            | Self::CopyParams
            | Self::GuessParams
            | Self::ResetParams
            | Self::UseModel(_)
            | Self::UseFresnel(_) => state.current().is_some(),
            Self::NextMaterial | Self::PreviousMaterial => state.scene.opened.len() > 1,
            _ => true,
        }
    }

    /// Whether it is what is shown now, for commands that choose.
    pub fn is_checked(self, state: &State) -> Option<bool> {
        let scene = &state.scene;
        let brdf = state.current().map(|(_, opened)| opened.brdf);
        Some(match self {
            Self::UseModel(index) => brdf.is_some_and(|brdf| brdf.model.index() == index),
            Self::UseFresnel(fresnel) => brdf.is_some_and(|brdf| brdf.fresnel == fresnel),
            Self::UseShow(show) => scene.sphere.show == show,
            Self::UseLights(index) => LIGHT_PRESETS
                .get(index)
                .is_some_and(|preset| (preset.lights)() == scene.sphere.view.lights),
            Self::UseScale(scale) => scene.lobes.scale == scale,
            Self::ToggleCosine => scene.lobes.with_cosine,
            Self::ToggleRaw => scene.lookup == Lookup::Nearest,
            Self::UseTheme(theme) => state.prefs.theme == theme,
            _ => return None,
        })
    }
}

fn entries() -> Vec<Entry> {
    const CTRL: Modifiers = Modifiers::COMMAND;
    const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
    let mut list = Vec::new();
    let mut add =
        |menu, submenu, command, name: &str, keys: Option<(Modifiers, Key)>, help: &str| {
            list.push(Entry {
                command,
                place: Place { menu, submenu },
                name: name.to_string(),
                keys: keys.map(|(modifiers, key)| KeyboardShortcut::new(modifiers, key)),
                help: help.to_string(),
            });
        };
    add(
        "File",
        "",
        Command::Open,
        "Open…",
        Some((CTRL, Key::O)),
        "Open MERL files",
    );
    add(
        "File",
        "",
        Command::OpenPath,
        "Open path…",
        Some((CTRL_SHIFT, Key::O)),
        "Type the path of a file to open",
    );
    for (index, sample) in SAMPLES.iter().enumerate() {
        add(
            "File",
            "Samples",
            Command::OpenSample(index),
            sample.name,
            None,
            sample.about,
        );
    }
    add(
        "File",
        "",
        Command::Close,
        "Close material",
        Some((CTRL, Key::W)),
        "Close the shown material",
    );
    add(
        "File",
        "",
        Command::SavePicture,
        "Save picture…",
        Some((CTRL_SHIFT, Key::S)),
        "Save the window as a PNG picture",
    );
    add(
        "File",
        "",
        Command::Quit,
        "Quit",
        Some((CTRL, Key::Q)),
        "Close the program",
    );

    add(
        "Edit",
        "",
        Command::Undo,
        "Undo",
        Some((CTRL, Key::Z)),
        "Take the last change back",
    );
    add(
        "Edit",
        "",
        Command::Redo,
        "Redo",
        Some((CTRL_SHIFT, Key::Z)),
        "Make the change again",
    );
    add(
        "Edit",
        "",
        Command::CopyParams,
        "Copy parameters",
        Some((CTRL_SHIFT, Key::C)),
        "Copy model and numbers as JSON",
    );
    add(
        "Edit",
        "",
        Command::GuessParams,
        "Guess from data",
        Some((CTRL, Key::G)),
        "Read a first guess of the parameters off the data",
    );
    add(
        "Edit",
        "",
        Command::ResetParams,
        "Reset parameters",
        Some((CTRL, Key::R)),
        "Put all parameters back to their defaults",
    );

    let digits = [
        Key::Num1,
        Key::Num2,
        Key::Num3,
        Key::Num4,
        Key::Num5,
        Key::Num6,
        Key::Num7,
        Key::Num8,
        Key::Num9,
    ];
    for (index, model) in MODELS.iter().enumerate() {
        let keys = digits.get(index).map(|key| (CTRL, *key));
        add(
            "Model",
            "",
            Command::UseModel(index),
            model.name,
            keys,
            &format!("Use the {} model", model.name),
        );
    }
    for fresnel in FRESNELS {
        add(
            "Model",
            "Fresnel",
            Command::UseFresnel(fresnel),
            fresnel.name(),
            None,
            fresnel_help(fresnel),
        );
    }

    for show in SHOWS {
        add(
            "View",
            "Sphere",
            Command::UseShow(show),
            show.name(),
            None,
            show_help(show),
        );
    }
    for (index, preset) in LIGHT_PRESETS.iter().enumerate() {
        add(
            "View",
            "Lights",
            Command::UseLights(index),
            preset.name,
            None,
            preset.help,
        );
    }
    for scale in RADIAL_SCALES {
        add(
            "View",
            "Lobe scale",
            Command::UseScale(scale),
            scale.name(),
            None,
            "Radius of the polar lobes per f_r",
        );
    }
    add(
        "View",
        "",
        Command::ToggleCosine,
        "Lobes × cos θi",
        None,
        "Multiply the lobes by the cosine of the angle of incidence",
    );
    add(
        "View",
        "",
        Command::ToggleRaw,
        "Raw cells",
        None,
        "Show the cells as stored, without interpolation",
    );
    add(
        "View",
        "",
        Command::NextMaterial,
        "Next material",
        Some((CTRL, Key::PageDown)),
        "Show the next open material",
    );
    add(
        "View",
        "",
        Command::PreviousMaterial,
        "Previous material",
        Some((CTRL, Key::PageUp)),
        "Show the previous open material",
    );
    for (theme, name) in [
        (Theme::System, "As the system"),
        (Theme::Light, "Light"),
        (Theme::Dark, "Dark"),
    ] {
        add(
            "View",
            "Theme",
            Command::UseTheme(theme),
            name,
            None,
            "Colours of the window",
        );
    }
    add(
        "View",
        "",
        Command::ResetLayout,
        "Reset layout",
        None,
        "Put the tiles back to where they were",
    );

    add(
        "Help",
        "",
        Command::Palette,
        "All commands…",
        Some((CTRL, Key::P)),
        "Search all commands",
    );
    add(
        "Help",
        "",
        Command::Conventions,
        "Conventions",
        Some((Modifiers::NONE, Key::F1)),
        "Angles, vectors and units",
    );
    add(
        "Help",
        "",
        Command::About,
        "About",
        None,
        "Version and graphics adapter",
    );
    list
}

fn fresnel_help(fresnel: Fresnel) -> &'static str {
    match fresnel {
        Fresnel::None => "No Fresnel factor on the specular term",
        Fresnel::Exact => "The Fresnel equations for unpolarised light on a dielectric",
        Fresnel::Schlick => "Schlick's approximation",
    }
}

fn show_help(show: Show) -> &'static str {
    match show {
        Show::Measured => "Show the data on the sphere",
        Show::Model => "Show the model on the sphere",
        Show::Split => "Show the data left of a line and the model right of it",
        Show::SideBySide => "Show two spheres",
    }
}
