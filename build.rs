//! Turns SKIP_GPU=1 into `cfg(skip_gpu)`, under which the tests that want a graphics adapter are ignored: the test
//! harness decides that when it is compiled.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=SKIP_GPU");
    println!("cargo::rustc-check-cfg=cfg(skip_gpu)");
    if std::env::var("SKIP_GPU").is_ok_and(|value| value == "1") {
        println!("cargo::rustc-cfg=skip_gpu");
    }
}
