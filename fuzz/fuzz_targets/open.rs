#![no_main]

libfuzzer_sys::fuzz_target!(init: grazing_fuzz::seeds::write("open"), |data: &[u8]| grazing_fuzz::readers::open(data));
