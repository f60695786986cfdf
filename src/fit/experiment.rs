use super::options::*;
use super::passes::*;
use super::regression::*;
use super::shape::*;
use super::*;
use crate::brdf::*;
use std::time::Instant;
#[test]
fn experiment() {
    let file = std::env::var("FILE").unwrap_or("/tmp/merl/teflon.binary".into());
    let table = crate::files::open_table(std::path::Path::new(&file), &mut |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let t = Instant::now();
    let problem = Problem::new(&table, Weight::Cosine, NO_LIMIT).unwrap();
    println!(
        "arrange {:.1} ms; {} rows {} blocks, {:.1} MB; medium {} coarse {}",
        1e3 * t.elapsed().as_secs_f64(),
        problem.all.rows.len(),
        problem.all.blocks,
        problem.bytes() as f64 / 1e6,
        problem.medium.blocks,
        problem.coarse.blocks
    );
    let shape = Shape {
        s: 50.0,
        alpha: 0.5,
        eta: 1.5,
    };
    let lobe = Lobe::new(shape, Fresnel::Exact);
    let limits = Limits {
        diffuse: [(0.0, 1e6); 3],
        specular: [(0.0, 1e12); 3],
    };
    for (name, sites, threads) in [
        ("all 2", &problem.all, Threads::Many),
        ("all 1", &problem.all, Threads::One),
        ("medium", &problem.medium, Threads::One),
        ("coarse", &problem.coarse, Threads::One),
    ] {
        let mut shapes = Vec::new();
        let at = cold(sites, &limits);
        let time = |name: &str, f: &mut dyn FnMut()| {
            f();
            let mut best = f64::INFINITY;
            for _ in 0..9 {
                let t = Instant::now();
                f();
                best = best.min(t.elapsed().as_secs_f64());
            }
            println!("  {name} {:.3} ms", 1e3 * best);
        };
        println!("{name}");
        let values = &sites.values;
        time("stream", &mut || {
            use rayon::prelude::*;
            let sum: f64 = values
                .par_chunks(1 << 16)
                .map(|chunk| {
                    let mut acc = [0f32; 32];
                    for b in chunk.chunks_exact(32) {
                        for k in 0..32 {
                            acc[k] += (b[k] - 0.3).abs();
                        }
                    }
                    acc.iter().map(|x| f64::from(*x)).sum::<f64>()
                })
                .sum();
            std::hint::black_box(sum);
        });
        time("fill", &mut || lobe.fill(sites, &mut shapes, threads));
        time("error", &mut || {
            std::hint::black_box(passes::error(&lobe, sites, &at, threads));
        });
        time("slopes", &mut || {
            std::hint::black_box(slopes(&lobe, sites, &at, 0.01, threads));
        });
        for _ in 0..200 {
            std::hint::black_box(passes::error(&lobe, sites, &at, threads));
        }
        time("regression", &mut || {
            std::hint::black_box(passes::regression(
                sites, &shapes, &at, [0.1; 3], [1e-4; 3], threads,
            ));
        });
    }
    for s in [0.3, 3.0, 30.0, 300.0, 3000.0, 30000.0] {
        let sites = &problem.coarse;
        let lobe = Lobe::new(
            Shape {
                s,
                alpha: 0.5,
                eta: 1.5,
            },
            Fresnel::Exact,
        );
        let mut shapes = Vec::new();
        lobe.fill(sites, &mut shapes, Threads::One);
        let at = cold(sites, &limits);
        print!("s {s}:");
        for passes in [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 60] {
            let (a, e) = solve(
                sites,
                &shapes,
                &at,
                &limits,
                Effort {
                    passes,
                    tolerance: 1e-7,
                    ..Effort::COLD
                },
                Threads::One,
            );
            print!(" {:.6}", e.iter().sum::<f64>());
            if passes == 60 {
                println!(" {a:?}");
            }
        }
    }
}
