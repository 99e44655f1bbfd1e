//! The API of a station, asked by hand.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::Instant;

use serde_json::{Value, json};

use super::PATIENCE;

/// The API of a station.
pub(crate) struct Api {
    address: String,
    lease: String,
}

impl Api {
    /// For one who only looks on; the page is served at the same address.
    pub(crate) fn new(page: &str) -> Self {
        Self {
            address: page.replace("http://", "").trim_end_matches('/').to_owned(),
            lease: String::new(),
        }
    }

    /// With control of the arm.
    pub(crate) fn with_control(page: &str) -> Self {
        let mut api = Self::new(page);
        let lease = api.asks("POST", "lease", &json!({}));
        let token = lease["token"].as_str();
        token
            .unwrap_or_else(|| panic!("{lease}"))
            .clone_into(&mut api.lease);
        api
    }

    /// Waits for a state that matches, and returns it.
    pub(crate) fn wait_for_state(&self, is_match: impl Fn(&Value) -> bool) -> Value {
        let Self { address, .. } = self;
        let mut way = self.connect();
        write!(
            way,
            "GET /api/v1/events?states=20 HTTP/1.0\r\nHost: {address}\r\n\r\n"
        )
        .expect("it is sent");
        let until = Instant::now() + PATIENCE;
        let lines = BufReader::new(way).lines().map_while(Result::ok);
        let lines = lines.take_while(|_| Instant::now() < until);
        let data = lines.filter_map(|line| line.strip_prefix("data:").map(read_json));
        let mut states = data.filter_map(|mut message| message.get_mut("state").map(Value::take));
        states
            .find(is_match)
            .expect("the station reports a matching state")
    }

    /// Its answer, which is not a problem.
    pub(crate) fn asks(&self, method: &str, path: &str, body: &Value) -> Value {
        let Self { address, lease } = self;
        let body = if body.is_null() {
            String::new()
        } else {
            body.to_string()
        };
        let lease = if lease.is_empty() {
            String::new()
        } else {
            format!("Dobot-Lease: {lease}\r\n")
        };
        let mut way = self.connect();
        write!(
            way,
            "{method} /api/v1/{path} HTTP/1.0\r\nHost: {address}\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\n{lease}\r\n{body}",
            body.len()
        )
        .expect("it is sent");
        let mut answer = String::new();
        way.read_to_string(&mut answer).expect("it answers");
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head and a body");
        assert!(head.starts_with("HTTP/1.0 20"), "{method} {path}: {answer}");
        match body {
            "" => Value::Null,
            text => read_json(text),
        }
    }

    fn connect(&self) -> TcpStream {
        let way = TcpStream::connect(&self.address).expect("the station listens");
        way.set_read_timeout(Some(PATIENCE)).expect("it can be set");
        way
    }
}

pub(crate) fn read_json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}
