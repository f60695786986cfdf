//! Every command that writes, killed at random times over an existing file: the old one or the whole new one is left. After
//! KILL a whole new one may be left beside it as well, and nothing else.

use crate::common::display::Running;
use crate::common::folder::{Folder, left_in};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Begin of the names of files that are not in their place.
const PREFIX: &str = ".grazing-";
const OLD: &[u8] = b"the old one";

/// Arguments of a command, and the name of its output.
fn commands() -> Vec<(&'static str, &'static str)> {
    vec![
        ("sample green-lacquer", "out.binary"),
        ("eval model.json --directions directions.csv", "out.csv"),
        ("fit data.binary", "out.json"),
        ("fit data.binary", "out.csv"),
        ("figure figure.json", "out.svg"),
        ("figure figure.json", "out.pdf"),
        ("figure figure.json", "out.png"),
        ("figure lobes.json", "out.csv"),
        ("figure figure.json", "out.exr"),
        ("render model.json --size 300", "out.png"),
        ("render model.json --size 300", "out.exr"),
        ("export model.json", "out.binary"),
        ("export model.json", "out.brdf"),
        ("export model.json", "out.wgsl"),
        ("export model.json", "out.glsl"),
    ]
}

const MODEL: &str = r#"{"model": "phong", "rho_d": [0.5, 0.4, 0.3], "k_s": [1, 2, 3], "s": 20}"#;

const FIGURE: &str = r#"{"subjects": [{"label": "m", "source": {"model": {"model": "phong", "rho_d": [0.5, 0.4, 0.3],
    "k_s": [1, 2, 3], "s": 20}}}], "rows": [{"panels": [{"subjects": [0], "view": {"sphere": {"show": "model"}}}]}]}"#;

/// Kills each command so many times.
pub fn run(each: usize, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let folder = Folder::new();
    folder.file("model.json", MODEL);
    folder.file("figure.json", FIGURE);
    let lobes = FIGURE.replace(r#"{"sphere": {"show": "model"}}"#, r#"{"lobes": {}}"#);
    folder.file("lobes.json", lobes);
    let rows = (0..20_000).map(|k| format!("{},0,{},180\n", k % 90, k / 90 % 90));
    folder.file(
        "directions.csv",
        format!("theta_i,phi_i,theta_o,phi_o\n{}", rows.collect::<String>()),
    );
    let out = folder.path("out");
    fs::create_dir(&out).expect("made");
    let grazing = |args: &str, to: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
        command
            .args(args.split(' '))
            .arg("--force")
            .arg("-o")
            .arg(to);
        command.current_dir(folder.root()).stdin(Stdio::null());
        command
    };
    let made = grazing("sample hammered-gold", &folder.path("data.binary")).status();
    assert!(made.expect("it runs").success());
    let (mut within, mut kills, mut whole_beside) = (0, 0, 0);
    for (args, name) in commands() {
        let to: PathBuf = out.join(name);
        let began = Instant::now();
        let output = grazing(args, &to).output().expect("it runs");
        let takes = began.elapsed();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{args}: {said}");
        let whole = fs::read(&to).expect("is there");
        let beside = left_in(&out);
        let of_others: Vec<Vec<u8>> = beside
            .iter()
            .filter_map(|path| fs::read(path).ok())
            .collect();
        for _ in 0..each {
            fs::write(&to, OLD).expect("is written");
            let mut command = grazing(args, &to);
            command.stdout(Stdio::null()).stderr(Stdio::null());
            let mut process = Running(command.spawn().expect("it runs"));
            let share = 1.2 * random.f64();
            thread::sleep(Duration::from_secs_f64(share * takes.as_secs_f64()));
            let signal = ["-KILL", "-TERM", "-INT"][random.usize(..3)];
            let id = process.0.id().to_string();
            let _ = Command::new("kill")
                .args([signal, &id])
                .stderr(Stdio::null())
                .status();
            let ended = process.0.wait().expect("it ends");
            let left = fs::read(&to).expect("is there");
            assert!(left == OLD || left == whole, "{args}: {} bytes", left.len());
            // A figure has its recipe beside it. A file that replaces another has a name of its own for a moment, in which
            // nothing can be done against KILL; it is whole then.
            for path in left_in(&out).iter().filter(|path| !beside.contains(path)) {
                let named = path
                    .file_name()
                    .is_some_and(|name| name.to_string_lossy().starts_with(PREFIX));
                let bytes = fs::read(path).expect("is there");
                let is_whole = bytes == whole || of_others.contains(&bytes);
                assert!(
                    signal == "-KILL" && named && is_whole,
                    "{args}, {signal}: {}",
                    path.display()
                );
                fs::remove_file(path).expect("is removed");
                whole_beside += 1;
            }
            kills += usize::from(!ended.success());
            within += usize::from(left == OLD);
        }
        for path in left_in(&out) {
            fs::remove_file(path).expect("is removed");
        }
    }
    println!(
        "soak: {kills} kills, {within} before the new file was in its place, {whole_beside} while it had a name beside it; no file lost or half"
    );
}
