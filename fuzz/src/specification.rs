use dobot_arm::{Joints, Limits, Tool};
use dobot_controller::Personality;

/// The controller that follows the document: no panic, and never a status that is not finite, nor a
/// joint beyond its limit.
pub fn specification(input: &[u8]) {
    crate::drive(Personality::Specification, input, |_, status| {
        assert!(
            status.floats().iter().all(|float| float.is_finite()),
            "{status:?}"
        );
        let angle = |n| f64::from(status.float(n));
        let joints = Joints::new(angle(5), angle(6), angle(7), angle(8));
        let is_within = |tool| match Limits::STOCK.check(&joints, tool) {
            Ok(()) => true,
            // A status is in single precision, which may round a value over its limit.
            Err(error) => error.excess() < 1e-3,
        };
        assert!(Tool::ALL.into_iter().any(is_within), "{status:?}");
    });
}
