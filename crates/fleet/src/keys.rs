//! The keys of Zenoh.

/// The version of the messages: stations of another one are seen, and nothing is asked of them.
pub const MESSAGES: u32 = 1;

/// Everyone who is there, of every version.
pub(crate) const ALL_ALIVE: &str = "dobot/alive/**";

/// A station, as its keys name it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct MemberKey {
    /// What it is called.
    pub(crate) name: String,
    /// The number that it goes by, 32 hexadecimal digits.
    pub(crate) id: String,
}

/// What a liveliness token says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Alive {
    pub(crate) member: MemberKey,
    /// The version of its messages.
    pub(crate) messages: u32,
    /// The version of its program.
    pub(crate) version: String,
}

impl Alive {
    pub(crate) fn key(&self) -> String {
        let Self {
            member: MemberKey { name, id },
            messages,
            version,
        } = self;
        format!("dobot/alive/{messages}/{version}/{name}/{id}")
    }

    /// Nothing for a key that is none of a station.
    pub(crate) fn of(key: &str) -> Option<Self> {
        let parts = key.strip_prefix("dobot/alive/")?;
        let (messages, parts) = parts.split_once('/')?;
        let (version, member) = parts.split_once('/')?;
        Some(Self {
            member: MemberKey::of(member)?,
            messages: messages.parse().ok()?,
            version: version.chars().take(40).collect(),
        })
    }
}

impl MemberKey {
    /// The key of one of its resources.
    pub(crate) fn resource(&self, what: &str) -> String {
        let Self { name, id } = self;
        format!("dobot/{MESSAGES}/{name}/{id}/{what}")
    }

    /// The station whose resource this is.
    pub(crate) fn of_resource(key: &str, what: &str) -> Option<Self> {
        let member = key.strip_prefix("dobot/")?;
        let (messages, member) = member.split_once('/')?;
        let member = member.strip_suffix(what)?.strip_suffix('/')?;
        Self::of(member).filter(|_| messages.parse() == Ok(MESSAGES))
    }

    fn of(text: &str) -> Option<Self> {
        let (name, id) = text.split_once('/')?;
        let is_id = id.len() == 32 && id.bytes().all(|it| it.is_ascii_hexdigit());
        (dobot_api::is_fleet_name(name) && is_id).then(|| Self {
            name: name.into(),
            id: id.into(),
        })
    }
}

/// A resource of all stations.
pub(crate) fn of_all(what: &str) -> String {
    format!("dobot/{MESSAGES}/*/*/{what}")
}

/// What a station tells.
pub(crate) const TOLD: &str = "told";
/// Where a station is asked.
pub(crate) const API: &str = "api";
/// Where a station is told which stops of the fleet there are, and tells those that it knows of.
pub(crate) const STOPS: &str = "stops";

#[cfg(test)]
mod tests {
    use super::*;

    fn desk() -> MemberKey {
        MemberKey {
            name: "desk-3".into(),
            id: "00112233445566778899aabbccddeeff".into(),
        }
    }

    #[test]
    fn a_key_is_read_as_it_was_written() {
        let alive = Alive {
            member: desk(),
            messages: 7,
            version: "2.0.1-rc.1".into(),
        };
        assert_eq!(Alive::of(&alive.key()), Some(alive));
        let told = desk().resource(TOLD);
        assert_eq!(MemberKey::of_resource(&told, TOLD), Some(desk()));
        assert_eq!(MemberKey::of_resource(&told, API), None);
    }

    #[test]
    fn a_key_of_something_else_is_no_station() {
        let id = desk().id;
        for key in [
            "dobot/alive".to_owned(),
            format!("dobot/alive/x/1.0/desk-3/{id}"),
            format!("dobot/alive/1/1.0/Desk 3/{id}"),
            format!("dobot/alive/1/1.0/desk-3/{id}0"),
            "dobot/alive/1/1.0/desk-3/..".to_owned(),
            format!("dobot/alive/1/1.0/desk-3/{id}/more"),
        ] {
            assert_eq!(Alive::of(&key), None, "{key}");
        }
        let of_other_messages = format!("dobot/2/desk-3/{id}/told");
        assert_eq!(MemberKey::of_resource(&of_other_messages, TOLD), None);
    }
}
