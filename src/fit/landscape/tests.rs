use super::*;
use crate::brdf::COMBINED;
use crate::brdf::params::lobe_values;
use crate::brdf::{BLINN_PHONG, PHONG, Params};
use crate::fit::options::{NO_LIMIT, Weight};
use crate::measured::{Grid, Table, tabulate};

/// Model whose s and α are a node of every grid.
fn truth() -> Brdf {
    Brdf {
        model: model(),
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [2.0, 3.0, 4.0],
            lobe: lobe_values([100.0, 0.25]),
            eta: 1.6,
        },
    }
}

fn problem(brdf: &Brdf) -> Problem {
    Problem::new(&tabulate(brdf, Grid::FOLDED), Weight::Cosine, NO_LIMIT).expect("cells")
}

fn made(problem: &Problem, fresnel: Fresnel, eta: Eta) -> Landscape {
    let go_on = &mut |_: LandscapeUpdate| ControlFlow::Continue(());
    landscape(problem, fresnel, eta, go_on).expect("not stopped")
}

#[test]
fn the_bottom_is_where_the_data_were_made() {
    let problem = problem(&truth());
    let found = made(&problem, Fresnel::Exact, Eta::Fixed(1.6));
    let lowest = found.lowest().expect("nodes");
    assert!((lowest.brdf.params.lobe[0] / 100.0 - 1.0).abs() < 1e-9);
    assert_eq!(lowest.brdf.params.lobe[1], 0.25);
    assert!(lowest.error < 1e-4, "{}", lowest.error);
    let (best, error) = found.best.expect("measured");
    assert!(error < 1e-5, "{error}");
    for k in 0..3 {
        assert!((best.params.k_s[k] / truth().params.k_s[k] - 1.0).abs() < 1e-3);
    }
    // Elsewhere it is worse, and with another η everywhere.
    assert_eq!(
        found.nodes.iter().filter(|node| node.error < 3e-4).count(),
        1
    );
    let planted = made(&problem, Fresnel::Exact, Eta::Fixed(1.3));
    assert!(planted.nodes.iter().all(|node| node.error > 1e-3));
}

#[test]
fn the_edges_are_phong_and_blinn_phong() {
    let problem = problem(&truth());
    let found = made(&problem, Fresnel::None, Eta::Optimised);
    for (model, alpha, ratio) in [(&PHONG, 0.0, 1.0), (&BLINN_PHONG, 1.0, 4.0)] {
        let mut others_differ = 0;
        for column in [12, 16, 20] {
            let s = found.s[column];
            let of = |s: f64| {
                let brdf = Brdf {
                    model,
                    fresnel: Fresnel::None,
                    params: Params {
                        lobe: lobe_values([s, 0.5]),
                        ..COMBINED.default_params()
                    },
                };
                problem.errors(&problem.with_best_amplitudes(&brdf)).total
            };
            let here = found.error_at(s, alpha).expect("a node");
            let near = |error: f64| (here / error - 1.0).abs() < 0.06;
            assert!(
                near(of(ratio * s)),
                "{} {here} {}",
                model.key,
                of(ratio * s)
            );
            // Planted: the exponent of the other one.
            others_differ += usize::from(!near(of((5.0 - ratio) * s)));
        }
        assert!(others_differ >= 2, "{}", model.key);
    }
}

#[test]
fn a_solved_eta_is_at_least_as_good_as_any_fixed_one() {
    let problem = problem(&truth());
    let solved = made(&problem, Fresnel::Exact, Eta::Optimised);
    // On the same sample.
    let survey = |eta| Survey {
        cells: &problem.coarse,
        space: SearchSpace::new(
            Variant::from(&truth()),
            &FitOptions::default(),
            problem.units(),
        ),
        eta: Eta::Fixed(eta),
    };
    let fixed = |eta: f64, node: &Node| {
        let params = node.brdf.params;
        survey(eta).node(params.lobe[0], params.lobe[1]).error
    };
    for node in solved.nodes.iter().step_by(37) {
        for eta in [1.05, 1.3, 1.6, 2.5] {
            let fixed = fixed(eta, node);
            assert!(node.error <= 1.003 * fixed + 1e-3, "{node:?} {eta} {fixed}");
        }
    }
    let lowest = solved.lowest().expect("nodes");
    assert!((lowest.brdf.params.eta - 1.6).abs() < 0.05, "{lowest:?}");
    assert!(lowest.error < 2e-3);
}

#[test]
fn it_comes_coarse_to_fine_and_stops_when_told() {
    let problem = problem(&truth());
    let mut grids = Vec::new();
    let mut last = 0.0;
    let full = landscape(&problem, Fresnel::Exact, Eta::Fixed(1.6), &mut |word| {
        match word {
            LandscapeUpdate::Progress(share) => {
                assert!(share >= last && share <= 1.0);
                last = share;
            }
            LandscapeUpdate::Grid(grid) => grids.push(grid),
        }
        ControlFlow::Continue(())
    })
    .expect("not stopped");
    let sizes: Vec<(usize, usize)> = grids.iter().map(|g| (g.s.len(), g.alpha.len())).collect();
    assert_eq!(sizes, GRIDS[..2]);
    assert_eq!(last, 1.0);
    for grid in &grids {
        for node in &grid.nodes {
            let params = node.brdf.params;
            let again = full
                .error_at(params.lobe[0], params.lobe[1])
                .expect("a node");
            assert!((again - node.error).abs() < 1e-9);
        }
    }
    let mut words = 0;
    let stopped = landscape(&problem, Fresnel::Exact, Eta::Fixed(1.6), &mut |_| {
        words += 1;
        ControlFlow::Break(())
    });
    assert_eq!((stopped, words), (None, 1));
}

#[test]
fn threads_change_nothing() {
    let problem = problem(&truth());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("a pool")
            .install(|| made(&problem, Fresnel::Schlick, Eta::Fixed(1.4)))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn a_place_between_nodes_takes_its_own_shape() {
    let found = Landscape {
        s: vec![1.0, 10.0, 100.0],
        alpha: vec![0.0, 1.0],
        nodes: (0..6)
            .map(|k| Node {
                brdf: truth(),
                error: f64::from(k),
            })
            .collect(),
        best: None,
    };
    let error = found.error_at(10f64.sqrt(), 0.5).expect("inside");
    assert!((error - 2.0).abs() < 1e-12);
    assert_eq!(found.error_at(1e9, 7.0), Some(5.0));
    let brdf = found.model_at(31.0, 0.3).expect("inside");
    assert_eq!((brdf.params.lobe[0], brdf.params.lobe[1]), (31.0, 0.3));
    let none = Landscape {
        nodes: Vec::new(),
        s: Vec::new(),
        ..found
    };
    assert_eq!(none.error_at(1.0, 0.5), None);
}

#[test]
fn the_best_is_never_above_a_fit_though_it_lies_between_the_nodes() {
    let brdf = Brdf {
        params: Params {
            // Half way between two nodes either way.
            lobe: lobe_values([178.0, 0.28]),
            ..truth().params
        },
        ..truth()
    };
    // Data that no model meets: two lobes.
    let wide = Brdf {
        params: Params {
            lobe: lobe_values([12.0, 0.9]),
            ..brdf.params
        },
        ..brdf
    };
    let (narrow, wide) = (tabulate(&brdf, Grid::FOLDED), tabulate(&wide, Grid::FOLDED));
    let cells = narrow.cells().iter().zip(wide.cells());
    let both = cells.map(|(a, b)| std::array::from_fn(|k| a[k] + b[k]));
    let both = Table::new(Grid::FOLDED, both.collect());
    let problem = Problem::new(&both, Weight::Cosine, NO_LIMIT).expect("cells");
    let variant = Variant::from(&brdf);
    let fitted = fit(&problem, variant, &FitOptions::default(), &mut |_| {
        ControlFlow::Continue(())
    });
    for eta in [Eta::Fixed(fitted.brdf.params.eta), Eta::Optimised] {
        let found = made(&problem, Fresnel::Exact, eta);
        let (_, best) = found.best.expect("measured");
        assert!(
            best <= 1.001 * fitted.errors.total,
            "{best} {}",
            fitted.errors.total
        );
        // Planted: the best node is above it.
        let node = problem.with_best_amplitudes(&found.lowest().expect("nodes").brdf);
        let node = problem.errors(&node).total;
        assert!(node > 1.002 * fitted.errors.total, "{node}");
    }
}
