//! The built program as a person or a script meets it.

#[path = "../common"]
mod common {
    pub mod display;
    pub mod folder;
    pub mod font;
    pub mod merl;
    pub mod program;
    pub mod real_window;
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
mod inputs;
mod killed;
mod odd_names;
mod recipe;
mod specs;
mod startup;
mod views;
