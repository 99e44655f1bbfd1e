//! Everything that a person writes for a virtual arm: an error, but never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = dobot_sim::Script::parse(text);
    let _ = dobot_sim::world::Scene::parse(text);
    if let Ok(fault) = text.parse::<dobot_sim::Fault>() {
        assert_eq!(fault.to_string().parse(), Ok(fault));
    }
});
