//! stub
use super::{Grid, Table};
pub struct Sample { pub key: &'static str, pub name: &'static str, pub about: &'static str }
pub static SAMPLES: [Sample; 1] = [Sample { key: "stub", name: "Red lacquer (synthetic)", about: "stub" }];
impl Sample {
    pub fn synthesize(&self) -> Table {
        let grid = Grid::FOLDED;
        let b = crate::brdf::Brdf { model: crate::brdf::MODELS[1], fresnel: crate::brdf::Fresnel::Exact, params: crate::brdf::Params { rho_d: [0.4,0.1,0.05], k_s: [30.;3], s: 250., alpha: 1., eta: 1.5 } };
        Table::new(grid, (0..grid.len()).map(|i| { let (h,d,p) = grid.bins(i); let c = grid.center(h,d,p).cosines(); if c.cos_theta_i > 0.08 && c.cos_theta_o > 0.08 { b.eval(&c).map(|x| x as f32) } else { [-1.;3] } }).collect())
    }
}
