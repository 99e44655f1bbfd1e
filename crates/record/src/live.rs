//! The messages of a recording for live viewers.

use std::time::Duration;

use jiff::Timestamp;

use crate::encoder::Encoder;
use crate::{Message, Record, StartError};

/// A sans-IO encoder of the messages of a recording without delay: records in, messages out.
///
/// A recording contains a repeated status once, with all its times. Here each one is a message, and
/// its views at least once a second, for late subscribers.
///
/// ```
/// use std::time::Duration;
///
/// use dobot_record::{Live, Record};
/// use dobot_wire::Status;
///
/// let mut live = Live::new("2026-11-21T12:30:00Z".parse()?)?;
/// let status = Record::FromArm(Status::AT_ZERO.emit().to_bytes().to_vec());
/// let topics: Vec<_> = live.write(Duration::ZERO, &status).iter().map(|message| message.topic.name().to_owned()).collect();
/// assert_eq!(topics, ["/wire/from_arm", "/arm/pose", "/tf", "/arm/joints"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Live {
    encoder: Encoder,
    /// The last time at which the views were sent even without changes.
    viewed_at: Option<Duration>,
}

impl Live {
    /// Creates an encoder for records whose times count from `start`.
    ///
    /// # Errors
    ///
    /// [`StartError::Clock`] before 1970 and after 2500.
    pub fn new(start: Timestamp) -> Result<Self, StartError> {
        Ok(Self {
            encoder: Encoder::new(start).ok_or(StartError::Clock(start))?,
            viewed_at: None,
        })
    }

    /// Handles a record without subscribers: ink drawn meanwhile is sent to late subscribers.
    pub fn follow(&mut self, at: Duration, record: &Record) {
        self.encoder.follow(at, record);
    }

    /// The ink before `at`, for a late subscriber: messages of [`INK`](crate::INK), with at most
    /// the newest 50,000 points.
    #[must_use]
    pub fn ink_so_far(&self, at: Duration) -> Vec<Message<'static>> {
        self.encoder.ink_so_far(at)
    }

    /// Returns the messages for a record; none if its time is centuries in the future.
    pub fn write<'t>(&mut self, at: Duration, record: &'t Record) -> Vec<Message<'t>> {
        let viewed_at = *self.viewed_at.get_or_insert(at);
        let is_due = at.saturating_sub(viewed_at) >= VIEW_PERIOD;
        if is_due {
            self.viewed_at = Some(at);
        }
        self.encoder.forget_repeats(is_due);
        self.encoder.write(at, record).unwrap_or_default()
    }
}

/// The interval at which the views of a resting arm are sent.
const VIEW_PERIOD: Duration = Duration::from_secs(1);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_wire::Status;

    use super::*;
    use crate::{FROM_ARM, TRANSFORMS};

    #[test]
    fn an_arm_that_rests_is_reported_with_each_status_and_shown_once_a_second() {
        let mut live = Live::new("2026-11-21T12:30:00Z".parse().unwrap()).unwrap();
        let status = Record::FromArm(Status::AT_ZERO.emit().to_bytes().to_vec());
        let (mut sent, mut shown) = (0, 0);
        // 20 per second, for ten seconds.
        for n in 0..=200 {
            for message in live.write(Duration::from_millis(50 * n), &status) {
                sent += u32::from(message.topic.name() == FROM_ARM);
                shown += u32::from(message.topic.name() == TRANSFORMS);
            }
        }
        assert_eq!(sent, 201);
        assert_eq!(shown, 11);
    }
}
