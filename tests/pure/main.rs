//! What needs neither a window nor an adapter nor the built program: the laws of the fit, the state and its messages,
//! the layout of uniforms.

#[path = "../common"]
mod common {
    pub mod tables;
}

mod fit_laws;
mod fit_steps;
mod layout;
mod opening_fit;
