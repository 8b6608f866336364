//! Any bytes as an answer; the first chooses the model.
#![no_main]

mod chance;
#[path = "../../tests/strange/laws.rs"]
mod laws;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Some((number, text)) = bytes.split_first() {
        laws::hold(*number, &String::from_utf8_lossy(text));
    }
});
