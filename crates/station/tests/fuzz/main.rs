//! Anything that anybody may ask, for half a minute: `examples/fuzz.rs` asks a million times.

#[path = "../../examples/reliability/cases/mod.rs"]
#[expect(dead_code, reason = "the other cases are tested in tests/faults")]
mod cases;

#[test]
fn an_arm_is_never_lost_whatever_it_is_asked() {
    let it = cases::fuzz::run(0, 60);
    assert!(
        it.wrong.is_empty(),
        "{} of {} arms: {}",
        it.wrong.len(),
        it.cases,
        it.wrong.join("\n")
    );
    assert!(it.taken > it.requests / 5 && it.packets > 1000, "{it:?}");
}
