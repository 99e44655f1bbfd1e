//! Rate limits.

use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A rate limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rate {
    /// The sustained rate, per second.
    pub(crate) per_s: f64,
    /// The burst.
    pub(crate) burst: f64,
}

/// The used part of a rate limit. Times are relative to any origin and never decrease.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Used {
    amount: f64,
    at: Duration,
}

impl Used {
    /// Uses up `cost`.
    ///
    /// # Errors
    ///
    /// The time to wait until the cost is allowed; nothing is used up then.
    pub(crate) fn take(&mut self, rate: Rate, now: Duration, cost: f64) -> Result<(), Duration> {
        let amount = self.left(rate, now) + cost;
        if amount > rate.burst {
            return Err(Duration::from_secs_f64((amount - rate.burst) / rate.per_s));
        }
        *self = Self { amount, at: now };
        Ok(())
    }

    /// Returns the part that still counts.
    fn left(&self, rate: Rate, now: Duration) -> f64 {
        let passed = now.saturating_sub(self.at).as_secs_f64();
        (self.amount - passed * rate.per_s).max(0.0)
    }
}

/// The used part per address.
#[derive(Debug, Default)]
pub(crate) struct Addresses(Mutex<HashMap<IpAddr, Used>>);

impl Addresses {
    /// Uses up `cost` for an address.
    ///
    /// # Errors
    ///
    /// The time to wait until the cost is allowed.
    pub(crate) fn take(&self, from: IpAddr, now: Duration, cost: f64) -> Result<(), Duration> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let rate = rate_of(from);
        if all.len() >= MAX_ADDRESSES {
            all.retain(|&address, used| used.left(rate_of(address), now) > 0.0);
        }
        let network = network(from);
        if all.len() >= MAX_ADDRESSES && !all.contains_key(&network) {
            return Err(Duration::from_secs(1));
        }
        all.entry(network).or_default().take(rate, now, cost)
    }
}

/// The limit for programs on the same machine, which have other means to do harm.
const NEAR: Rate = Rate {
    per_s: 2000.0,
    burst: 4000.0,
};

/// The limit for other addresses.
const FAR: Rate = Rate {
    per_s: 50.0,
    burst: 200.0,
};

/// The shared limit of all members of the fleet, which have no address.
const FLEET: Rate = Rate {
    per_s: 500.0,
    burst: 1000.0,
};

/// The maximum number of tracked addresses; idle ones are dropped beyond it.
const MAX_ADDRESSES: usize = 10_000;

fn rate_of(from: IpAddr) -> Rate {
    match from {
        _ if from.is_loopback() => NEAR,
        _ if from.is_unspecified() => FLEET,
        _ => FAR,
    }
}

/// Returns the network that an address stands for: in IPv6 each user has a whole network of
/// addresses.
fn network(from: IpAddr) -> IpAddr {
    match from.to_canonical() {
        IpAddr::V6(address) => {
            let [a, b, c, d, ..] = address.segments();
            Ipv6Addr::new(a, b, c, d, 0, 0, 0, u16::from(address.is_loopback())).into()
        }
        address @ IpAddr::V4(_) => address,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: Rate = Rate {
        per_s: 10.0,
        burst: 3.0,
    };

    #[test]
    fn a_burst_is_allowed_and_then_the_rate() {
        let mut used = Used::default();
        let at = Duration::from_millis;
        for _ in 0..3 {
            assert_eq!(used.take(RATE, at(0), 1.0), Ok(()));
        }
        assert_eq!(used.take(RATE, at(0), 1.0), Err(at(100)));
        assert_eq!(used.take(RATE, at(100), 1.0), Ok(()));
        assert!(used.take(RATE, at(150), 1.0).is_err());
    }

    #[test]
    fn one_address_does_not_use_up_the_allowance_of_another() {
        let addresses = Addresses::default();
        let [one, other] = [[192, 168, 0, 1], [192, 168, 0, 2]].map(IpAddr::from);
        while addresses.take(one, Duration::ZERO, 1.0).is_ok() {}
        assert_eq!(addresses.take(other, Duration::ZERO, 1.0), Ok(()));
    }

    #[test]
    fn all_addresses_of_one_ipv6_network_count_as_one() {
        let addresses = Addresses::default();
        let [one, other] = [1, 2].map(|last| IpAddr::from([0x2001, 0xdb8, 0, 0, 0, 0, 0, last]));
        while addresses.take(one, Duration::ZERO, 1.0).is_ok() {}
        assert!(addresses.take(other, Duration::ZERO, 1.0).is_err());
    }

    #[test]
    fn addresses_that_have_been_quiet_are_forgotten() {
        let addresses = Addresses::default();
        for n in 0..u32::try_from(MAX_ADDRESSES).expect("ten thousand is small") {
            let _ = addresses.take(IpAddr::V4(n.into()), Duration::ZERO, 1.0);
        }
        let later = Duration::from_mins(1);
        let _ = addresses.take(IpAddr::from([1, 1, 1, 1]), later, 1.0);
        assert_eq!(addresses.0.lock().map_or(0, |all| all.len()), 1);
    }

    #[test]
    fn while_all_known_addresses_are_busy_new_ones_must_wait() {
        let addresses = Addresses::default();
        let mut refused = 0;
        for n in 0..u32::try_from(MAX_ADDRESSES).expect("ten thousand is small") + 5 {
            let taken = addresses.take(IpAddr::V4(n.into()), Duration::ZERO, 1.0);
            refused += u32::from(taken.is_err());
        }
        assert_eq!(refused, 5);
    }
}
