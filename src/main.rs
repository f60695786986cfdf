//! The program `grazing`: see [`grazing::cli`].

fn main() -> std::process::ExitCode {
    grazing::cli::main()
}
