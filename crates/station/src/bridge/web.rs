//! Detection of web browsers on the port for programs.

/// Whether a connection begins like that of a web browser.
///
/// Any page on the internet can make its visitor's browser send a request to this machine with
/// arbitrary bytes, packets included. It begins with a method in capitals or with a TLS handshake;
/// neither begins a packet.
pub(super) fn is_web(beginning: &[u8]) -> bool {
    beginning.starts_with(&TLS_HANDSHAKE)
        || METHODS
            .iter()
            .any(|method| beginning.starts_with(method.as_bytes()))
}

/// The methods that browsers allow pages to choose; the HTTP/2 preface is `PRI`.
const METHODS: [&str; 9] = [
    "GET ", "POST ", "PUT ", "HEAD ", "DELETE ", "OPTIONS ", "PATCH ", "CONNECT ", "PRI ",
];
const TLS_HANDSHAKE: [u8; 2] = [0x16, 0x03];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_of_browsers_are_recognised() {
        for request in ["GET / HTTP/1.1\r\n", "POST /x HTTP/1.1\r\n", "OPTIONS * "] {
            assert!(is_web(request.as_bytes()), "{request}");
        }
        assert!(is_web(&[0x16, 0x03, 0x01, 0x02]));
    }

    #[test]
    fn packets_and_plain_noise_are_not_browser_requests() {
        for noise in [
            &[0xA5][..],
            &[0xB5, b'G'],
            b"AT\r\n",
            b"GETTING",
            b"",
            &[0x16],
        ] {
            assert!(!is_web(noise), "{noise:?}");
        }
    }
}
