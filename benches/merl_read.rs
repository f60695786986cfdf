//! What opening a MERL file costs, as a multiple of reading its bytes: `cargo bench --bench merl_read [FILE]`.
//!
//! Both are timed in turn in one process, so that they share whatever the machine does. The goal is ≤ 2.5.

use grazing::files::open_table;
use grazing::measured::{SAMPLES, merl};
use std::hint::black_box;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

const RUNS: usize = 21;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // cargo passes --bench.
    let named = std::env::args().skip(1).find(|arg| !arg.starts_with("--"));
    let folder = tempfile::tempdir()?;
    let path = match named {
        Some(path) => PathBuf::from(path),
        None => {
            let path = folder.path().join("sample.binary");
            let started = Instant::now();
            let table = SAMPLES[0].synthesize();
            println!(
                "synthesize  {:6.1} ms",
                1e3 * started.elapsed().as_secs_f64()
            );
            merl::write(&table, std::fs::File::create(&path)?)?;
            path
        }
    };
    let (mut bytes, mut table) = (Vec::new(), Vec::new());
    for _ in 0..RUNS {
        let started = Instant::now();
        black_box(std::fs::read(&path)?);
        bytes.push(1e3 * started.elapsed().as_secs_f64());
        let started = Instant::now();
        black_box(open_table(&path, &mut |_| ControlFlow::Continue(()))?);
        table.push(1e3 * started.elapsed().as_secs_f64());
    }
    let (bytes, table) = (median(bytes), median(table));
    println!(
        "fs::read    {bytes:6.1} ms\nopen_table  {table:6.1} ms\nratio       {:6.2}",
        table / bytes
    );
    Ok(())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
