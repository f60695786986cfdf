fn main() { if let Err(e) = grazing::app::run(std::env::args_os().skip(1).map(Into::into).collect()) { eprintln!("grazing: {e}"); std::process::exit(1) } }
