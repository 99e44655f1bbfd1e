//! The packets of `vectors/` have the stated meaning, and are written exactly as given there.

use std::fs;
use std::path::Path;

use dobot_wire::{Command, Dialect, Frame, PACKET_LEN, Packet, Status};
use serde::Deserialize;

#[test]
fn every_vector_has_the_stated_meaning() {
    let vectors = vectors();
    assert!(vectors.len() > 70, "only {} vectors", vectors.len());
    for vector in &vectors {
        for dialect in &vector.dialects {
            vector.check(dialect);
        }
    }
}

#[derive(Deserialize)]
struct Vector {
    name: String,
    hex: String,
    #[serde(default = "all_dialects")]
    dialects: Vec<Dialect>,
    #[serde(flatten)]
    meaning: Meaning,
    #[serde(default)]
    one_way: bool,
    table: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Meaning {
    Command(Command),
    Status(Status),
    Error(String),
}

impl Vector {
    fn check(&self, dialect: &Dialect) {
        let place = format!("{} in dialect {dialect}", self.name);
        let bytes = self.bytes();
        match &self.meaning {
            Meaning::Command(command) => {
                let packet = Packet::from_bytes(&bytes).unwrap();
                assert_eq!(
                    Command::parse(&packet, dialect).as_ref(),
                    Ok(command),
                    "{place}"
                );
                assert!(
                    self.one_way || command.emit(dialect).to_bytes() == bytes,
                    "{place}"
                );
            }
            Meaning::Status(status) => {
                let frame = Frame::from_bytes(&bytes).unwrap();
                assert_eq!(Status::parse(&frame).as_ref(), Ok(status), "{place}");
                assert_eq!(status.emit().to_bytes(), bytes, "{place}");
            }
            Meaning::Error(error) => {
                assert_eq!(self.refusal(&bytes, dialect), *error, "{place}");
            }
        }
    }

    fn refusal(&self, bytes: &[u8; PACKET_LEN], dialect: &Dialect) -> String {
        let packet = Packet::from_bytes(bytes).unwrap();
        match packet {
            Packet::Frame(frame) if self.table == "2.3" => Status::parse(&frame).unwrap_err(),
            _ => Command::parse(&packet, dialect).unwrap_err(),
        }
        .to_string()
    }

    fn bytes(&self) -> [u8; PACKET_LEN] {
        let digits: Vec<u32> = self
            .hex
            .chars()
            .filter_map(|digit| digit.to_digit(16))
            .collect();
        let bytes: Vec<u8> = digits
            .chunks(2)
            .map(|pair| u8::try_from(pair[0] * 16 + pair[1]).unwrap())
            .collect();
        bytes.try_into().unwrap()
    }
}

fn vectors() -> Vec<Vector> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vectors");
    fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "json")
        })
        .flat_map(|path| {
            let text = fs::read_to_string(&path).unwrap();
            serde_json::from_str::<Vec<Vector>>(&text)
                .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        })
        .collect()
}

fn all_dialects() -> Vec<Dialect> {
    Dialect::ALL.to_vec()
}
