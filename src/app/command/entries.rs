//! The rows of the command list, in menu order.

use crate::app::command::{Command, Entry, Place};
use crate::app::lessons::rows::LESSONS;
use crate::app::state::prefs::Theme;
use crate::app::state::views::VIEWS;
use crate::app::views::sphere::settings::{SHOWS, Show};
use crate::brdf::MODELS;
use crate::brdf::fresnel::{FRESNELS, Fresnel};
use crate::figure::scale::RADIAL_SCALES;
use crate::files::MODEL_FORMATS;
use crate::fit::WEIGHTS;
use crate::geom::sphere::LIGHT_PRESETS;
use crate::geom::sphere_error::SphereError;
use crate::measured::samples::SAMPLES;
use egui::{Key, KeyboardShortcut, Modifiers};

pub(crate) fn entries() -> Vec<Entry> {
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
        "Open MERL files, fit files, models or a session",
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
    for format in MODEL_FORMATS {
        add(
            "File",
            "Export model",
            Command::ExportModel(format),
            &format!("{}…", format.name()),
            None,
            format.help(),
        );
    }
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
        Command::CopyProbe,
        "Copy values",
        None,
        "Copy the probe's angles and values as a row for a spreadsheet",
    );
    add(
        "Edit",
        "",
        Command::Unpin,
        "Unpin",
        Some((Modifiers::NONE, Key::Escape)),
        "Let the probe follow the pointer again",
    );
    add(
        "Edit",
        "",
        Command::CopyParams,
        "Copy parameters",
        None,
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

    add(
        "Fit",
        "",
        Command::Fit,
        "Fit",
        Some((CTRL, Key::F)),
        "Fit the shown model to the shown material",
    );
    add(
        "Fit",
        "",
        Command::FitAll,
        "Fit all six",
        Some((CTRL_SHIFT, Key::F)),
        "Fit every model without and with the Fresnel factor, and compare them in a table",
    );
    add(
        "Fit",
        "",
        Command::CancelFit,
        "Cancel fit",
        Some((Modifiers::NONE, Key::Escape)),
        "Stop the fit and keep the best so far",
    );
    for weight in WEIGHTS {
        add(
            "Fit",
            "Weight",
            Command::UseWeight(weight),
            weight.name(),
            None,
            weight.help(),
        );
    }
    add(
        "Fit",
        "",
        Command::ToggleFromSliders,
        "Start from sliders",
        None,
        "Begin the fit at the present s, α and η instead of at what the data say",
    );
    add(
        "Fit",
        "",
        Command::ToggleKeepOptimal,
        "Keep ρd, ks optimal",
        Some((CTRL, Key::K)),
        "Find the best ρd and ks again whenever s, α, η or the model change",
    );

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
    for row in VIEWS {
        add(
            "View",
            "Tiles",
            Command::ToggleTile(row.id),
            row.name,
            None,
            row.help[0],
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
    for (index, lesson) in LESSONS.iter().enumerate() {
        add(
            "Help",
            "Lessons",
            Command::Lesson(index),
            lesson.title,
            None,
            lesson.about,
        );
    }
    add(
        "Help",
        "",
        Command::Guide,
        "Guide",
        None,
        "How to work in the window and without one, figures, formats and theory",
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
    crate::app::command::paper_entries::insert(&mut list);
    crate::app::command::folder_entries::insert(&mut list);
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
        Show::Error(SphereError::Difference) => {
            "Show |model − measured| in colours beside the split sphere"
        }
        Show::Error(SphereError::Ratio) => {
            "Show model / measured in colours beside the split sphere"
        }
    }
}
