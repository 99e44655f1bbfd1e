//! The addresses of the page on the network.

use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};

use axum::Json;

use super::GET;
use crate::http::exchange::requester::Requester;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/addresses",
            "The addresses at which other devices in the network reach the page; none if the station listens on this \
                computer only",
            list,
        )
        .gives::<Vec<String>>(200, "the addresses, as in http://192.168.1.7:8642"),
    ]
}

async fn list(requester: Requester) -> Json<Vec<String>> {
    let (listens, is_secure) = requester.app.listens;
    let ip = reachable(listens.ip(), network_address);
    let scheme = if is_secure { "https" } else { "http" };
    let address = ip.map(|ip| format!("{scheme}://{}", SocketAddr::new(ip, listens.port())));
    Json(address.into_iter().collect())
}

/// Returns the address at which other devices reach a station that listens on this one.
fn reachable(listens: IpAddr, network: impl FnOnce() -> Option<IpAddr>) -> Option<IpAddr> {
    match listens {
        ip if ip.is_loopback() => None,
        ip if ip.is_unspecified() => network(),
        ip => Some(ip),
    }
}

/// Returns the address of this computer in its network. Nothing is sent: the system only chooses
/// the network for an address that is reserved for documentation (RFC 5737).
fn network_address() -> Option<IpAddr> {
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).ok()?;
    socket.connect((Ipv4Addr::new(192, 0, 2, 1), 9)).ok()?;
    let ip = socket.local_addr().ok()?.ip();
    (!ip.is_loopback() && !ip.is_unspecified()).then_some(ip)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_station_is_reached_where_it_listens_and_not_on_loopback() {
        let network: IpAddr = [192, 168, 1, 7].into();
        let at = |listens: [u8; 4]| reachable(listens.into(), || Some(network));
        assert_eq!(at([127, 0, 0, 1]), None);
        assert_eq!(at([0, 0, 0, 0]), Some(network));
        assert_eq!(at([10, 0, 0, 3]), Some([10, 0, 0, 3].into()));
    }
}
