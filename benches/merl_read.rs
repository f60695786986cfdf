//! What opening a MERL file costs, as a multiple of reading its bytes: `cargo bench --bench merl_read [FILE]`.
//!
//! Both are timed in turn in one process, so that they share whatever the machine does. The goal is ≤ 2.5.

use grazing::files::open_table;
use grazing::measured::{SAMPLES, merl};
use std::hint::black_box;
use std::io::Read as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
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
    let open = || open_table(&path, &mut |_| ControlFlow::Continue(()));
    let first = timed(open)?;
    let (mut bytes, mut chunks, mut table) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..RUNS {
        bytes.push(timed(|| std::fs::read(&path))?);
        chunks.push(timed(|| read_in_chunks(&path))?);
        table.push(timed(open)?);
    }
    let [bytes, chunks, table] = [bytes, chunks, table].map(median);
    println!("fs::read    {bytes:6.1} ms  into memory of its own");
    println!("chunks      {chunks:6.1} ms  the same bytes through 64 KiB");
    println!("open_table  {table:6.1} ms  (the first time {first:.1} ms)");
    println!("ratio       {:6.2}     to fs::read", table / bytes);
    println!("            {:6.2}     to chunks", table / chunks);
    Ok(())
}

/// Milliseconds that it takes.
fn timed<T, E>(work: impl FnOnce() -> Result<T, E>) -> Result<f64, E> {
    let started = Instant::now();
    black_box(work()?);
    Ok(1e3 * started.elapsed().as_secs_f64())
}

/// The least that reading can cost: no memory is taken, and all of it stays in the cache.
fn read_in_chunks(path: &Path) -> std::io::Result<usize> {
    let mut file = std::fs::File::open(path)?;
    let mut buffer = vec![0; 64 * 1024];
    let mut total = 0;
    loop {
        match black_box(file.read(&mut buffer)?) {
            0 => return Ok(total),
            count => total += count,
        }
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
