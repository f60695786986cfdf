#![no_main]

libfuzzer_sys::fuzz_target!(init: grazing_fuzz::seeds::write("models"), |data: &[u8]| grazing_fuzz::readers::models(data));
