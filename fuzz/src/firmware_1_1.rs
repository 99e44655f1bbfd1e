use dobot_controller::Personality;

/// The twin of the stock controller: no panic and no endless loop. What is not finite is part of it,
/// but never reaches the motors.
pub fn firmware_1_1(input: &[u8]) {
    crate::drive(Personality::Firmware11, input, |controller, status| {
        assert!([0.0, 1.0].contains(&status.float(9)), "{status:?}");
        let joints = controller.joints_at(std::time::Duration::MAX);
        let angles = [joints.base, joints.rear, joints.fore, joints.servo];
        assert!(angles.iter().all(|angle| angle.0.is_finite()), "{joints:?}");
    });
}
