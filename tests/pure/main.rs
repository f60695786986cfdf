//! What needs neither a window nor an adapter nor the built program: the laws of the fit, the state and its messages,
//! the layout of uniforms.

mod fit_laws;
mod fit_steps;
mod layout;
