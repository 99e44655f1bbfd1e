/// Everything that a person writes for a virtual arm: an error, but never a panic.
pub fn texts(input: &[u8]) {
    let text = &*String::from_utf8_lossy(input);
    let _ = dobot_sim::Script::parse(text);
    let _ = dobot_sim::world::Scene::parse(text);
    if let Ok(fault) = text.parse::<dobot_sim::Fault>() {
        assert_eq!(fault.to_string().parse(), Ok(fault));
    }
}
