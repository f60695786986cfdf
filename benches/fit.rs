//! What the fit costs, as ratios taken in one run: `cargo bench --bench fit [FILE]`.
//!
//! - an objective pass over all cells against a plain streaming sum over the same bytes: goal ≤ 2;
//! - the same pass against a plain scalar loop in f64 with `powf` on one thread: goal ≥ 20 on two cores;
//! - fits in units of objective passes: goal ≤ 500 for all six variants of the Phong family, joint;
//! - stages 1-4 of every model with exact Fresnel, against the combined model's: goal ≤ 2 times its passes and ≤ 3 times
//!   its time;
//! - all models with exact Fresnel in one go: goal ≤ 2 s on two cores;
//! - memory beyond the table for arranging it and fitting all six: goal ≤ 64 MiB;
//! - how long a fit goes on after it is told to stop, at many moments: goal < 100 ms.

use grazing::brdf::PHONG_FAMILY;
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, Fresnel, MODELS, Params};
use grazing::fit::options::NO_LIMIT;
use grazing::fit::{FitOptions, Problem, Stage, StageSet, Variant, Weight, fit, fit_all};
use grazing::geom::Rgb;
use grazing::measured::{Grid, SAMPLES, Table};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::Instant;

const RUNS: usize = 41;
/// Moments at which a fit is stopped.
const MOMENTS: u32 = 20;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // cargo passes --bench.
    let named = std::env::args().skip(1).find(|arg| !arg.starts_with("--"));
    let table = match named {
        Some(path) => {
            grazing::files::open_table(path.as_ref(), &mut |_| ControlFlow::Continue(()))?
        }
        None => SAMPLES[0].synthesize(),
    };
    let brdf = Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.2; 3],
            k_s: [10.0; 3],
            lobe: lobe_values([60.0, 0.6]),
            eta: 1.5,
        },
    };
    // First, so that nothing else has taken memory that could be used again.
    let memory = memory_of_fits(&table)?;
    let started = Instant::now();
    let problem = Problem::new(&table, Weight::Cosine, NO_LIMIT)?;
    println!(
        "arrange          {:8.2} ms",
        1e3 * started.elapsed().as_secs_f64()
    );
    let bytes = vec![0.5_f32; problem.bytes() / size_of::<f32>()];
    let plain = Plain::new(&table);
    let (mut pass, mut stream, mut scalar) = (Vec::new(), Vec::new(), Vec::new());
    for run in 0..RUNS {
        pass.push(timed(|| problem.error(black_box(&brdf))));
        stream.push(timed(|| streaming_sum(black_box(&bytes))));
        if run % 8 == 0 {
            scalar.push(timed(|| plain.error(black_box(&brdf))));
        }
    }
    let (fast, slow) = (problem.error(&brdf), plain.error(&brdf));
    assert!(
        (fast / slow - 1.0).abs() < 1e-3,
        "the two loops disagree: {fast} {slow}"
    );
    let [pass, stream, scalar] = [pass, stream, scalar].map(median);
    let threads = rayon::current_num_threads();
    println!(
        "objective pass   {pass:8.2} ms  {threads} threads, {:.1} MB",
        1e-6 * problem.bytes() as f64
    );
    println!(
        "streaming sum    {stream:8.2} ms  ratio {:6.2}",
        pass / stream
    );
    println!(
        "scalar powf      {scalar:8.2} ms  ratio {:6.1}",
        scalar / pass
    );

    let variant = Variant::from(&brdf);
    let all = Variant::of(PHONG_FAMILY, Fresnel::Exact);
    let staged = FitOptions {
        stages: StageSet::POSTER,
        ..FitOptions::default()
    };
    let joint = FitOptions {
        stages: StageSet::from_iter([Stage::Joint]),
        ..FitOptions::default()
    };
    let every = FitOptions::default();
    for (name, options) in [
        ("stages 1-3", staged),
        ("stage 4", joint),
        ("stages 1-4", every),
    ] {
        let one = in_passes(&problem, &brdf, || {
            fit(&problem, variant, &options, &mut |_| {
                ControlFlow::Continue(())
            })
        });
        let six = in_passes(&problem, &brdf, || {
            fit_all(&problem, &all, &options, &mut |_, _| {
                ControlFlow::Continue(())
            })
        });
        println!(
            "{name}: combined {:8.1} ms, {:5.0} passes; all six {:8.1} ms, {:5.0} passes",
            one.0, one.1, six.0, six.1
        );
    }
    every_model(&problem, &brdf);
    match memory {
        Some(bytes) => println!(
            "memory           {:8.1} MiB beyond the table",
            bytes / f64::from(1 << 20)
        ),
        None => println!("memory           not told by this system"),
    }
    let mut delays: Vec<f64> = (0..MOMENTS)
        .map(|k| stop_delay(&problem, 0.95 * f64::from(k) / f64::from(MOMENTS)))
        .collect();
    delays.sort_by(f64::total_cmp);
    println!(
        "stopped after    {:8.1} ms as a rule, {:.1} ms at worst, of {MOMENTS} moments",
        delays[delays.len() / 2],
        delays[delays.len() - 1]
    );
    Ok(())
}

/// Prints what stages 1-4 of every model cost, and those of all models in one go.
fn every_model(problem: &Problem, brdf: &Brdf) {
    let options = FitOptions::default();
    let exact = |model| Variant {
        model,
        fresnel: Fresnel::Exact,
    };
    let cost = |variant: Variant| {
        in_passes(problem, brdf, || {
            fit(problem, variant, &options, &mut |_| {
                ControlFlow::Continue(())
            })
        })
    };
    let combined = cost(exact(brdf.model));
    for model in MODELS {
        let (time, passes) = cost(exact(model));
        println!(
            "{:18} {time:8.1} ms, {passes:5.0} passes; of combined's {:5.2} in time, {:5.2} in passes",
            model.key,
            time / combined.0,
            passes / combined.1
        );
    }
    let variants: Vec<Variant> = MODELS.iter().map(|model| exact(model)).collect();
    let all = in_passes(problem, brdf, || {
        fit_all(problem, &variants, &options, &mut |_, _| {
            ControlFlow::Continue(())
        })
    });
    println!(
        "all {} models {:8.2} s, {:5.0} passes",
        variants.len(),
        1e-3 * all.0,
        all.1
    );
}

/// The most bytes that arranging a table and fitting all six variants need at a time, where the system tells.
fn memory_of_fits(table: &Table) -> Result<Option<f64>, Box<dyn std::error::Error>> {
    let read = |key: &str| {
        let status = std::fs::read_to_string("/proc/self/status").ok()?;
        let line = status.lines().find(|line| line.starts_with(key))?;
        let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
        Some(1024.0 * kib)
    };
    // Threads are no part of it.
    rayon::broadcast(|_| ());
    // 5 sets the peak back to what is used now.
    if std::fs::write("/proc/self/clear_refs", "5").is_err() {
        return Ok(None);
    }
    let before = read("VmRSS:");
    let problem = Problem::new(table, Weight::Cosine, NO_LIMIT)?;
    let variants = Variant::of(PHONG_FAMILY, Fresnel::Exact);
    fit_all(&problem, &variants, &FitOptions::default(), &mut |_, _| {
        ControlFlow::Continue(())
    });
    Ok(read("VmHWM:")
        .zip(before)
        .map(|(peak, before)| peak - before))
}

/// Milliseconds from the moment that a fit of all six is told to stop, at a share of its time, to its return.
fn stop_delay(problem: &Problem, share: f64) -> f64 {
    let variants = Variant::of(PHONG_FAMILY, Fresnel::Exact);
    let options = FitOptions::default();
    let whole = timed(|| {
        fit_all(problem, &variants, &options, &mut |_, _| {
            ControlFlow::Continue(())
        })
    });
    let moment = share * whole;
    let started = Instant::now();
    let elapsed = || 1e3 * started.elapsed().as_secs_f64();
    fit_all(problem, &variants, &options, &mut |_, _| {
        if elapsed() < moment {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    });
    (elapsed() - moment).max(0.0)
}

/// Σ |m − c| over all bytes, on all threads.
fn streaming_sum(values: &[f32]) -> f64 {
    let chunks = values.par_chunks(1 << 16).map(|chunk| {
        let mut sums = [0.0_f32; 32];
        for block in chunk.chunks_exact(32) {
            for (sum, m) in sums.iter_mut().zip(block) {
                *sum += (m - 0.3).abs();
            }
        }
        sums.iter().map(|x| f64::from(*x)).sum::<f64>()
    });
    chunks.sum()
}

/// The loop that one would write first: cosines, weights and Fresnel factors at hand, a `powf` per cell.
struct Plain {
    cells: Vec<(f64, f64, f64, f64, Rgb)>,
    energy: f64,
}

impl Plain {
    fn new(table: &Table) -> Self {
        let grid: Grid = table.grid();
        let mut cells = Vec::new();
        let mut energy = 0.0;
        for index in 0..grid.len() {
            let (h, d, phi) = grid.bins(index);
            let center = grid.center(h, d, phi);
            let c = center.cosines();
            let Some(f_r) = table.cell(index) else {
                continue;
            };
            if c.cos_theta_i <= 0.0 || c.cos_theta_o <= 0.0 {
                continue;
            }
            let edge = |i: usize| (i as f64 / 90.0).powi(2) * 0.5 * PI;
            let weight = (edge(h).cos() - edge(h + 1).cos())
                * center.theta_d.sin()
                * center.theta_d.cos()
                * c.cos_theta_i
                * c.cos_theta_o;
            energy += weight * f_r.iter().sum::<f64>();
            cells.push((c.wr_wo.cos, c.wh_n.cos.powi(4), c.wi_wh.cos, weight, f_r));
        }
        Self { cells, energy }
    }

    fn error(&self, brdf: &Brdf) -> f64 {
        let p = &brdf.params;
        let [s, alpha, ..] = p.lobe;
        let mut sum = 0.0;
        for (wr_wo, wh_n_4, wi_dot_wh, weight, f_r) in &self.cells {
            let base: f64 = (1.0 - alpha) * wr_wo + alpha * wh_n_4;
            let shape = brdf.fresnel.reflectance(*wi_dot_wh, p.eta) * base.powf(s);
            for (k, f_r) in f_r.iter().enumerate() {
                sum += weight * (p.rho_d[k] / PI + p.k_s[k] * shape - f_r).abs();
            }
        }
        sum / self.energy
    }
}

/// Milliseconds that it takes.
fn timed<T>(work: impl FnOnce() -> T) -> f64 {
    let started = Instant::now();
    black_box(work());
    1e3 * started.elapsed().as_secs_f64()
}

/// The medians of milliseconds and of objective passes that it takes; passes are timed right before and after.
fn in_passes<T>(problem: &Problem, brdf: &Brdf, mut work: impl FnMut() -> T) -> (f64, f64) {
    let passes = || (0..8).map(|_| timed(|| problem.error(black_box(brdf))));
    let (mut times, mut ratios) = (Vec::new(), Vec::new());
    for _ in 0..5 {
        let mut pass: Vec<f64> = passes().collect();
        let time = timed(&mut work);
        pass.extend(passes());
        times.push(time);
        ratios.push(time / median(pass));
    }
    (median(times), median(ratios))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
