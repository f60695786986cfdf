use super::objective::{Follow, Objective, Space};
use super::passes::{self, Amplitudes};
use super::shape::{Lobe, Shape, Threads};
use super::*;
use crate::brdf::{Fresnel, MODELS};
use crate::measured::SAMPLES;

#[test]
fn slopes_are_those_of_the_error() {
    let problem = Problem::new(&SAMPLES[0].synthesize(), Weight::Cosine, options::NO_LIMIT)
        .expect("is measured");
    let sites = &problem.medium;
    let amplitudes = Amplitudes {
        diffuse: [0.3, 0.2, 0.1],
        specular: [3.0, 2.0, 1.0],
    };
    for (s, alpha, eta) in [
        (0.4, 0.5, 1.5),
        (1.6, 1.0, 1.3),
        (10.0, 0.0, 2.0),
        (300.0, 0.3, 1.1),
        (3000.0, 1.0, 1.5),
    ] {
        let point = Shape { s, alpha, eta }.point();
        let error = |point| {
            passes::error(
                &Lobe::new(Shape::at(point), Fresnel::Exact),
                sites,
                &amplitudes,
                Threads::One,
            )
        };
        let lobe = Lobe::new(Shape::at(point), Fresnel::Exact);
        let slopes = passes::slopes(&lobe, sites, &amplitudes, 0.02, Threads::One);
        for k in 0..3 {
            let mut moved = [point; 2];
            moved[0][k] -= 1e-2;
            moved[1][k] += 1e-2;
            let difference = (error(moved[1]) - error(moved[0])) / 2e-2;
            println!("{s} {alpha} {eta}: {k} {difference} {}", slopes.gradient[k]);
        }
    }
    let _ = MODELS;
}
