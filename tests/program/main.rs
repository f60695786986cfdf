//! The built program as a person or a script meets it.

#[path = "../common"]
mod common {
    pub mod folder;
    pub mod font;
    pub mod merl;
    pub mod program;
    pub mod tables;
    pub mod wait;
}

mod cli;
mod cli_export;
mod cli_figure;
mod cli_fit;
mod cli_render;
mod fonts;
mod hostile;
mod odd_names;
mod startup;
mod views;
