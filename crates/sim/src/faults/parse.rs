//! Parsing of faults.

use std::str::FromStr;

use super::when::{FaultTime, time, unsigned};
use super::{Amount, Damage, Directions, Fault, FaultKind, Tilt};
use crate::Joint;

impl FromStr for Fault {
    type Err = FaultError;

    fn from_str(text: &str) -> Result<Self, FaultError> {
        let (what, when) = match text.split_once('@') {
            Some((what, when)) => (what, Some(when)),
            None => (text, None),
        };
        let (name, value) = what.split_once('=').unwrap_or((what, ""));
        let Some(form) = FORMS.iter().find(|form| form.name == name) else {
            return Err(FaultError::UnknownKind {
                fault: text.to_owned(),
                kind: name.to_owned(),
            });
        };
        let kind = (form.parse)(value).ok_or_else(|| FaultError::BadValue {
            fault: text.to_owned(),
            found: value.to_owned(),
            kind: form.name,
            allowed: form.values,
        })?;
        let when = when.map_or(Some(FaultTime::ALWAYS), FaultTime::parse);
        match when.filter(|when| form.times.allow(when)) {
            Some(when) => Ok(Self { kind, when }),
            None => Err(FaultError::BadTime {
                fault: text.to_owned(),
                kind: form.name,
                allowed: form.times.text(),
            }),
        }
    }
}

/// The error returned when a text is not a fault.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FaultError {
    /// The kind is unknown.
    #[error(
        "fault `{fault}` is of the kind `{kind}`; allowed are drop, flip, duplicate, delay, withhold, close, reset, power, lose, backlash and zero, as in drop=1% or reset@12s"
    )]
    UnknownKind {
        /// The whole text.
        fault: String,
        /// The text before `=` or `@`.
        kind: String,
    },
    /// The value after `=` does not fit the kind.
    #[error("fault `{fault}` has the value `{found}`; {kind} allows {allowed}")]
    BadValue {
        /// The whole text.
        fault: String,
        /// The text after `=`.
        found: String,
        /// The kind.
        kind: &'static str,
        /// The allowed form.
        allowed: &'static str,
    },
    /// The fault must be set before power-up.
    #[error("fault `{fault}` must be set when the arm is switched on: `dobot arm --fault {fault}`")]
    NotNow {
        /// The whole text.
        fault: String,
    },
    /// The time after `@` does not fit the kind.
    #[error("fault `{fault}` has an invalid time; {kind} allows {allowed}")]
    BadTime {
        /// The whole text.
        fault: String,
        /// The kind.
        kind: &'static str,
        /// The allowed form.
        allowed: &'static str,
    },
}

/// The syntax of a kind of fault.
struct Form {
    name: &'static str,
    parse: fn(&str) -> Option<FaultKind>,
    values: &'static str,
    times: Times,
}

/// The times allowed for a kind.
#[derive(Clone, Copy)]
enum Times {
    Any,
    Window,
    Moment,
    None,
}

impl Times {
    fn allow(self, when: &FaultTime) -> bool {
        match self {
            Self::Any => !when.is_open(),
            Self::Window => !when.is_open() && when.end.is_some(),
            Self::Moment => when.end.is_none() && *when != FaultTime::ALWAYS,
            Self::None => *when == FaultTime::ALWAYS,
        }
    }

    const fn text(self) -> &'static str {
        match self {
            Self::Any => {
                "a moment to begin at or a window, @12s, @packet5, @status100, @12s..15s or @packet5..+2s (units ms, s, min and h, up to 1000 h), or nothing for always"
            }
            Self::Window => {
                "a window, @12s..15s, @packet5..packet9 or @status100..+2s (units ms, s, min and h, up to 1000 h)"
            }
            Self::Moment => {
                "a moment, @12s, @packet5, @status100 or @open (units ms, s, min and h, up to 1000 h)"
            }
            Self::None => "no @; it applies from power-up on",
        }
    }
}

fn bytes(damage: Damage, value: &str) -> Option<FaultKind> {
    let (amount, way) = split_way(value)?;
    let amount = parse_amount(amount)?;
    Some(FaultKind::Bytes {
        damage,
        amount,
        way,
    })
}

fn delay(value: &str) -> Option<FaultKind> {
    let (longest, way) = split_way(value)?;
    let longest =
        time(longest).filter(|delay| !delay.is_zero() && delay.as_secs() <= LONGEST_DELAY_S)?;
    Some(FaultKind::Delay { longest, way })
}

fn lose(value: &str) -> Option<FaultKind> {
    let (joint, amount) = value.split_once(':')?;
    let joint = parse_joint(joint).filter(|&it| it != Joint::Servo)?;
    let amount = parse_amount(amount)?;
    Some(FaultKind::Lose { joint, amount })
}

fn backlash(value: &str) -> Option<FaultKind> {
    let (joint, deg) = joint_angle(value)?;
    (0.0..=MAX_BACKLASH_DEG)
        .contains(&deg)
        .then_some(FaultKind::Backlash { joint, deg })
}

fn zero(value: &str) -> Option<FaultKind> {
    let (joint, deg) = joint_angle(value)?;
    Some(FaultKind::Zero { joint, deg })
}

fn tilt(value: &str) -> Option<Tilt> {
    let mut tilt = Tilt::default();
    for part in value.split(',').filter(|_| !value.is_empty()) {
        match joint_angle(part)? {
            (Joint::Rear, deg) => tilt.rear_deg = deg,
            (Joint::Fore, deg) => tilt.fore_deg = deg,
            _ => return None,
        }
    }
    Some(tilt)
}

fn nothing(kind: FaultKind, value: &str) -> Option<FaultKind> {
    value.is_empty().then_some(kind)
}

fn split_way(value: &str) -> Option<(&str, Directions)> {
    match value.split_once(':') {
        None => Some((value, Directions::Both)),
        Some((value, "to")) => Some((value, Directions::To)),
        Some((value, "from")) => Some((value, Directions::From)),
        Some(_) => None,
    }
}

fn parse_amount(text: &str) -> Option<Amount> {
    if let Some(percent) = text.strip_suffix('%') {
        let percent = unsigned(percent).filter(|&it| it > 0.0 && it <= 100.0)?;
        return Some(Amount::Percent(percent));
    }
    let plain = text.bytes().all(|byte| byte.is_ascii_digit());
    let count = text.parse().ok().filter(|&it| plain && it > 0)?;
    Some(Amount::Count(count))
}

fn joint_angle(text: &str) -> Option<(Joint, f64)> {
    let (joint, deg) = text.split_once(':')?;
    let (sign, size) = match deg.strip_prefix('-') {
        Some(size) => (-1.0, size),
        None => (1.0, deg),
    };
    let size = unsigned(size).filter(|&it| it <= MAX_DEG)?;
    Some((parse_joint(joint)?, sign * size))
}

fn parse_joint(text: &str) -> Option<Joint> {
    Joint::ALL.into_iter().find(|joint| joint.name() == text)
}

const fn form(
    name: &'static str,
    parse: fn(&str) -> Option<FaultKind>,
    values: &'static str,
    times: Times,
) -> Form {
    Form {
        name,
        parse,
        values,
        times,
    }
}

/// All kinds of faults.
const FORMS: [Form; 11] = [
    form("drop", |text| bytes(Damage::Drop, text), BYTES, Times::Any),
    form("flip", |text| bytes(Damage::Flip, text), BYTES, Times::Any),
    form(
        "duplicate",
        |text| bytes(Damage::Duplicate, text),
        BYTES,
        Times::Any,
    ),
    form("delay", delay, DELAY, Times::Any),
    form(
        "withhold",
        |text| nothing(FaultKind::Withhold, text),
        WITHHOLD,
        Times::Any,
    ),
    form(
        "close",
        |text| nothing(FaultKind::Close, text),
        CLOSE,
        Times::Window,
    ),
    form(
        "reset",
        |text| tilt(text).map(FaultKind::Reset),
        TILT,
        Times::Moment,
    ),
    form(
        "power",
        |text| tilt(text).map(FaultKind::Power),
        TILT,
        Times::Window,
    ),
    form("lose", lose, LOSE, Times::Any),
    form("backlash", backlash, BACKLASH, Times::None),
    form("zero", zero, ZERO, Times::None),
];

const BYTES: &str = "a share of the bytes above 0 and up to 100 % or a number of them from 1 on, then :to or :from for one way, as in drop=1% or drop=3:to";
const DELAY: &str = "a time of up to 60 s, as in delay=50ms or delay=50ms:from";
const WITHHOLD: &str = "no value, as in withhold@10s..12s";
const CLOSE: &str = "no value, as in close@12s..14s";
const LOSE: &str = "base, rear or fore with a share of its pulses above 0 and up to 100 % or a number of them from 1 on, as in lose=fore:1% or lose=rear:30";
const BACKLASH: &str =
    "base, rear, fore or servo with degrees from 0 to 10, as in backlash=base:0.3";
const ZERO: &str = "base, rear, fore or servo with degrees from -90 to 90, as in zero=fore:2";
const TILT: &str = "nothing, or the reading errors of rear and fore from -90 to 90 degrees, as in reset=rear:1.5,fore:-0.8@open";
const LONGEST_DELAY_S: u64 = 60;
const MAX_BACKLASH_DEG: f64 = 10.0;
const MAX_DEG: f64 = 90.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::time::Duration;

    use proptest::prelude::*;

    use super::super::when::{FaultEnd, FaultMoment};
    use super::*;

    #[test]
    fn every_form_is_written_as_it_is_read() {
        for text in [
            "drop=1%",
            "drop=1%:to",
            "drop=3:from@12s",
            "flip=0.1%@12s..15s",
            "duplicate=100%@packet5",
            "delay=50ms:from@status100..+2s",
            "withhold",
            "withhold@10s..12s",
            "close@packet5..packet9",
            "reset@12s",
            "reset@open",
            "reset=rear:1.5,fore:-0.8@open",
            "power@12s..15s",
            "power=rear:1,fore:0@status3..+500ms",
            "lose=rear:30@5s",
            "lose=fore:1%",
            "backlash=base:0.3",
            "zero=fore:2",
            "zero=servo:-4.5",
        ] {
            let fault: Fault = text.parse().unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(fault.to_string(), text);
        }
    }

    #[test]
    fn an_unknown_kind_is_reported_with_all_known_kinds() {
        let error = "dorp=1%".parse::<Fault>().unwrap_err().to_string();
        assert!(error.contains("`dorp`"), "{error}");
        for form in &FORMS {
            assert!(error.contains(form.name), "{}: {error}", form.name);
        }
    }

    #[test]
    fn an_invalid_value_is_reported_with_the_allowed_range() {
        for (text, part) in [
            ("drop", "has the value ``; drop allows a share"),
            ("drop=0%", "`0%`"),
            ("drop=101%", "up to 100 %"),
            ("drop=0", "from 1 on"),
            ("drop=1%:up", ":to or :from"),
            ("drop=-1%", "`-1%`"),
            ("drop=1.5", "a number of them"),
            ("delay=61s", "up to 60 s"),
            ("delay=0s", "delay=50ms"),
            ("withhold=3@1s", "no value"),
            ("close=3@1s..2s", "no value"),
            ("lose=servo:1%", "base, rear or fore"),
            ("lose=rear", "lose=rear:30"),
            ("backlash=base:-1", "from 0 to 10"),
            ("backlash=elbow:1", "base, rear, fore or servo"),
            ("zero=fore:nan", "-90 to 90"),
            ("zero=fore:91", "-90 to 90"),
            ("reset=base:1@open", "rear and fore"),
        ] {
            let error = text.parse::<Fault>().unwrap_err();
            assert!(matches!(error, FaultError::BadValue { .. }), "{text}");
            let error = error.to_string();
            assert!(error.contains(part), "{text}: {error}");
            assert!(error.contains(&format!("`{text}`")), "{text}: {error}");
        }
    }

    #[test]
    fn an_invalid_time_is_reported_with_the_allowed_range() {
        for (text, part) in [
            ("drop=1%@", "or nothing for always"),
            ("drop=1%@12", "@12s"),
            ("drop=1%@open", "@12s"),
            ("drop=1%@packet0", "@packet5"),
            ("close@12s", "a window"),
            ("close", "a window"),
            ("power@12s..11s", "a window"),
            ("reset", "a moment"),
            ("reset@12s..13s", "a moment"),
            ("backlash=base:1@3s", "no @"),
            ("zero=base:1@open", "no @"),
        ] {
            let error = text.parse::<Fault>().unwrap_err();
            assert!(matches!(error, FaultError::BadTime { .. }), "{text}");
            let error = error.to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }

    fn times() -> impl Strategy<Value = Duration> {
        (0_u64..3_600_000_000_000).prop_map(Duration::from_micros)
    }

    fn moments() -> impl Strategy<Value = FaultMoment> {
        prop_oneof![
            times().prop_map(FaultMoment::Time),
            (1..u64::MAX).prop_map(FaultMoment::Packet),
            (1..u64::MAX).prop_map(FaultMoment::Status),
            Just(FaultMoment::Open),
        ]
    }

    fn whens() -> impl Strategy<Value = FaultTime> {
        let ends = prop_oneof![
            moments().prop_map(FaultEnd::At),
            times().prop_map(FaultEnd::After)
        ];
        (moments(), proptest::option::of(ends)).prop_map(|(begin, end)| FaultTime { begin, end })
    }

    fn kinds() -> impl Strategy<Value = FaultKind> {
        let amounts = prop_oneof![
            (1e-12..=100.0).prop_map(Amount::Percent),
            (1..u32::MAX).prop_map(Amount::Count),
        ];
        let ways =
            proptest::sample::select(vec![Directions::Both, Directions::To, Directions::From]);
        let joints = proptest::sample::select(Joint::ALL.to_vec());
        let damages = proptest::sample::select(vec![Damage::Drop, Damage::Flip, Damage::Duplicate]);
        let tilts = || {
            (-90.0..=90.0, -90.0..=90.0)
                .prop_map(|(rear_deg, fore_deg)| Tilt { rear_deg, fore_deg })
        };
        prop_oneof![
            (damages, amounts.clone(), ways.clone()).prop_map(|(damage, amount, way)| {
                FaultKind::Bytes {
                    damage,
                    amount,
                    way,
                }
            }),
            ((1_u64..60_000_000).prop_map(Duration::from_micros), ways)
                .prop_map(|(longest, way)| FaultKind::Delay { longest, way }),
            Just(FaultKind::Withhold),
            Just(FaultKind::Close),
            tilts().prop_map(FaultKind::Reset),
            tilts().prop_map(FaultKind::Power),
            (joints.clone(), amounts).prop_map(|(joint, amount)| FaultKind::Lose { joint, amount }),
            (joints.clone(), 0.0..=10.0)
                .prop_map(|(joint, deg)| FaultKind::Backlash { joint, deg }),
            (joints, -90.0..=90.0).prop_map(|(joint, deg)| FaultKind::Zero { joint, deg }),
        ]
    }

    proptest! {
        #[test]
        fn what_is_read_is_what_was_written((kind, when) in (kinds(), whens())) {
            // A kind and a time that do not go together are refused; one of these goes with each.
            let window = FaultTime::parse("1s..+1s").unwrap();
            let open = FaultTime::parse("open").unwrap();
            let mut read = 0;
            for when in [when, FaultTime::ALWAYS, window, open] {
                let fault = Fault { kind, when };
                if let Ok(found) = fault.to_string().parse::<Fault>() {
                    prop_assert_eq!(found, fault);
                    read += 1;
                }
            }
            let servo_pulses = matches!(kind, FaultKind::Lose { joint: Joint::Servo, .. });
            prop_assert_eq!(read == 0, servo_pulses, "{:?}", kind);
        }

        #[test]
        fn no_text_makes_it_panic(text in ".{0,40}") {
            let _ = text.parse::<Fault>();
        }

        #[test]
        fn no_text_that_is_nearly_a_fault_makes_it_panic(
            text in "(drop|flip|delay|reset|power|lose|zero|close)[=:@.,%0-9a-z+-]{0,20}"
        ) {
            if let Ok(fault) = text.parse::<Fault>() {
                prop_assert_eq!(fault.to_string().parse::<Fault>().unwrap(), fault);
            }
        }
    }
}
