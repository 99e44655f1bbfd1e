//! The key expressions of Zenoh.

use data_encoding::BASE64URL_NOPAD;

use crate::identity::{Identity, Peer, SIGNATURE, statement};

/// The version of the messages. Stations with another version are shown, but receive no requests.
pub const MESSAGES: u32 = 2;

/// The liveliness tokens of all stations, of every version.
pub(crate) const ALL_ALIVE: &str = "dobot/alive/**";

/// The name and id of a station, as in its keys.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct MemberKey {
    /// The name.
    pub(crate) name: String,
    /// The id, 32 hexadecimal digits.
    pub(crate) id: String,
}

/// The contents of a liveliness token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Alive {
    pub(crate) member: MemberKey,
    /// The version of its messages.
    pub(crate) messages: u32,
    /// The version of its program.
    pub(crate) version: String,
    /// Its start, in milliseconds since 1970 by its own clock: the latest start of a station is
    /// valid.
    pub(crate) run: u64,
    /// The signature of the preceding parts and the signer's certificate; empty with other versions
    /// of the messages.
    pub(crate) proof: Vec<u8>,
}

impl Alive {
    /// Returns the signed token of a station.
    pub(crate) fn signed(member: &MemberKey, own: &Identity, run: u64) -> Self {
        let mut alive = Self {
            member: member.clone(),
            messages: MESSAGES,
            version: env!("CARGO_PKG_VERSION").into(),
            run,
            proof: Vec::new(),
        };
        let signature = own.sign(&alive.statement());
        alive.proof = [&signature, own.certificate()].concat();
        alive
    }

    /// Returns the member that has signed this.
    pub(crate) fn signer(&self, own: &Identity) -> Result<Peer, &'static str> {
        let proof = self.proof.split_at_checked(SIGNATURE);
        let (signature, certificate) = proof.ok_or("it is not signed")?;
        let peer = own.peer(certificate)?;
        if !peer.has_signed(&self.statement(), signature) {
            return Err("it is signed by another station");
        }
        Ok(peer)
    }

    fn statement(&self) -> Vec<u8> {
        statement("alive", &[self.prefix().as_bytes()])
    }

    fn prefix(&self) -> String {
        let Self {
            member: MemberKey { name, id },
            messages,
            version,
            run,
            ..
        } = self;
        format!("dobot/alive/{messages}/{version}/{name}/{id}/{run}")
    }

    pub(crate) fn key(&self) -> String {
        format!("{}/{}", self.prefix(), BASE64URL_NOPAD.encode(&self.proof))
    }

    /// Parses a key; `None` if it is not the key of a station.
    pub(crate) fn of(key: &str) -> Option<Self> {
        let mut parts = key.strip_prefix("dobot/alive/")?.split('/');
        let mut next = || parts.next();
        let (messages, version) = (next()?.parse().ok()?, next()?);
        let member = MemberKey::of(next()?, next()?)?;
        let is_version = |char: char| char.is_ascii_alphanumeric() || ".+-".contains(char);
        if version.len() > 40 || !version.chars().all(is_version) {
            return None;
        }
        let (run, proof) = match messages {
            MESSAGES => (next()?.parse().ok()?, decoded(next()?)?),
            // The remaining parts of other versions are unknown.
            _ => (0, Vec::new()),
        };
        if messages == MESSAGES && next().is_some() {
            return None;
        }
        Some(Self {
            member,
            messages,
            version: version.into(),
            run,
            proof,
        })
    }
}

fn decoded(proof: &str) -> Option<Vec<u8>> {
    BASE64URL_NOPAD.decode(proof.as_bytes()).ok()
}

impl MemberKey {
    /// Returns the key of one of its resources.
    pub(crate) fn resource(&self, what: &str) -> String {
        let Self { name, id } = self;
        format!("dobot/{MESSAGES}/{name}/{id}/{what}")
    }

    /// Returns the station that owns this resource.
    pub(crate) fn of_resource(key: &str, what: &str) -> Option<Self> {
        let member = key.strip_prefix("dobot/")?;
        let (messages, member) = member.split_once('/')?;
        let member = member.strip_suffix(what)?.strip_suffix('/')?;
        let (name, id) = member.split_once('/')?;
        Self::of(name, id).filter(|_| messages.parse() == Ok(MESSAGES))
    }

    fn of(name: &str, id: &str) -> Option<Self> {
        let is_id = id.len() == 32 && id.bytes().all(|byte| byte.is_ascii_hexdigit());
        (dobot_api::is_fleet_name(name) && is_id).then(|| Self {
            name: name.into(),
            id: id.into(),
        })
    }
}

/// Returns the key expression of a resource of all stations.
pub(crate) fn of_all(what: &str) -> String {
    format!("dobot/{MESSAGES}/*/*/{what}")
}

/// The published state of a station.
pub(crate) const STATE: &str = "state";
/// The public requests of a station, and stops.
pub(crate) const API: &str = "api";
/// The exchange of the fleet's stops.
pub(crate) const STOPS: &str = "stops";
/// The sealed requests of a station.
pub(crate) const SEALED: &str = "sealed";

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
            messages: MESSAGES,
            version: "2.0.1-rc.1".into(),
            run: 17,
            proof: vec![1, 2, 255],
        };
        assert_eq!(Alive::of(&alive.key()), Some(alive));
        let state = desk().resource(STATE);
        assert_eq!(MemberKey::of_resource(&state, STATE), Some(desk()));
        assert_eq!(MemberKey::of_resource(&state, API), None);
    }

    #[test]
    fn a_key_of_another_kind_is_not_a_station() {
        let id = desk().id;
        for key in [
            "dobot/alive".to_owned(),
            format!("dobot/alive/x/1.0/desk-3/{id}"),
            format!("dobot/alive/1/1.0/Desk 3/{id}"),
            format!("dobot/alive/1/1.0/desk-3/{id}0"),
            "dobot/alive/1/1.0/desk-3/..".to_owned(),
            format!("dobot/alive/2/1.0/desk-3/{id}"),
            format!("dobot/alive/2/1.0/desk-3/{id}/1/AAAA/more"),
            format!("dobot/alive/1/1.0\u{1b}[31m/desk-3/{id}"),
        ] {
            assert_eq!(Alive::of(&key), None, "{key}");
        }
        let of_other_messages = format!("dobot/9/desk-3/{id}/state");
        assert_eq!(MemberKey::of_resource(&of_other_messages, STATE), None);
    }
}
