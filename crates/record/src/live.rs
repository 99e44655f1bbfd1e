//! The messages of a recording, for those who look on while it happens.

use std::time::Duration;

use jiff::Timestamp;

use crate::encoder::Encoder;
use crate::{Message, Record, StartError};

/// Makes the messages of a recording at once: an engine, records in, messages out.
///
/// A recording tells a status that comes again and again once, with all its times. Here each is told as it comes, and what
/// the views show of it once a second at least, for those who come late.
///
/// ```
/// use std::time::Duration;
///
/// use dobot_record::{Live, Record};
/// use dobot_wire::Status;
///
/// let mut live = Live::new("2026-11-21T12:30:00Z".parse()?)?;
/// let status = Record::FromArm(Status::AT_ZERO.emit().to_bytes().to_vec());
/// let topics: Vec<_> = live.write(Duration::ZERO, &status).iter().map(|it| it.topic.name().to_owned()).collect();
/// assert_eq!(topics, ["/wire/from_arm", "/arm/pose", "/tf", "/arm/joints"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Live {
    encoder: Encoder,
    /// When the views were told last whatever they showed.
    viewed_at: Option<Duration>,
}

impl Live {
    /// For records whose times count from `start`.
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

    /// Takes a record that nobody wants to be told: what is drawn meanwhile is told to those who come late.
    pub fn follow(&mut self, at: Duration, record: &Record) {
        self.encoder.follow(at, record);
    }

    /// The ink that was told before `at`, or would have been, for one who comes late: messages of [`INK`](crate::INK), with
    /// the newest 50,000 points at the most.
    #[must_use]
    pub fn ink_so_far(&self, at: Duration) -> Vec<Message<'static>> {
        self.encoder.ink_so_far(at)
    }

    /// The messages that tell a record; none where its time lies centuries ahead.
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

/// So often one who comes late is shown where the arm is that rests.
const VIEW_PERIOD: Duration = Duration::from_secs(1);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_wire::Status;

    use super::*;
    use crate::{FROM_ARM, TRANSFORMS};

    #[test]
    fn an_arm_that_rests_is_told_with_each_status_and_shown_once_a_second() {
        let mut live = Live::new("2026-11-21T12:30:00Z".parse().unwrap()).unwrap();
        let status = Record::FromArm(Status::AT_ZERO.emit().to_bytes().to_vec());
        let (mut told, mut shown) = (0, 0);
        // Twenty a second, for ten seconds.
        for n in 0..=200 {
            for message in live.write(Duration::from_millis(50 * n), &status) {
                told += u32::from(message.topic.name() == FROM_ARM);
                shown += u32::from(message.topic.name() == TRANSFORMS);
            }
        }
        assert_eq!(told, 201);
        assert_eq!(shown, 11);
    }
}
