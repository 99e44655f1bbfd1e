use std::io::Cursor;

use dobot_record::{Moment, Recording};

/// Recordings that anybody hands on, whole and damaged: what is read comes from the bytes that are
/// told to be good, and never a panic.
pub fn mcap(input: &[u8]) {
    let file = file(input);
    let Some((moments, good)) = read(&file) else {
        return;
    };
    let Some(good) = good else {
        return;
    };
    let good = usize::try_from(good).expect("a few bytes");
    assert!(
        good <= file.len(),
        "{good} of {} bytes are good",
        file.len()
    );
    // A chunk that is damaged gives what comes before the damage, so that there may be more.
    let (before, _) = read(&file[..good]).expect("it begins as before");
    assert!(moments.starts_with(&before), "{before:?}\n{moments:?}");
}

/// What a recording tells, and how much of the file is good where not all of it is.
fn read(file: &[u8]) -> Option<(Vec<Moment>, Option<u64>)> {
    let mut recording = Recording::over(Cursor::new(file.to_vec())).ok()?;
    let moments: Vec<Moment> = recording.by_ref().take(MAX_COUNT).collect();
    if let Some(damage) = recording.damage() {
        assert!(!damage.to_string().is_empty());
    }
    Some((moments, recording.damage().map(|damage| damage.good_bytes)))
}

/// After a first byte that is odd the records that the bytes spell; after an even one the bytes.
fn file(input: &[u8]) -> Vec<u8> {
    let Some((&kind, mut rest)) = input.split_first() else {
        return Vec::new();
    };
    if kind % 2 == 0 {
        return rest.to_vec();
    }
    let mut file = MAGIC.to_vec();
    let mut chunk = None;
    while let Some((&step, after)) = rest.split_first() {
        rest = after;
        let open: &mut Vec<u8> = chunk.as_mut().unwrap_or(&mut file);
        match step % 12 {
            0 => record(open, 0x01, &[text(""), text("fuzz")].concat()),
            1 | 2 => record(open, 0x04, &channel(step)),
            3..=5 => {
                let (at, data) = (take(&mut rest, 2), take(&mut rest, usize::from(step / 12)));
                record(open, 0x05, &message(step, at, data));
            }
            6 => {
                let body = format!(
                    "{{\"bytes\":\"a55a\",\"gaps_ns\":[{}]}}",
                    take(&mut rest, usize::from(step / 48))
                        .iter()
                        .map(|number| (u64::from(*number) << (*number % 60)).to_string())
                        .collect::<Vec<_>>()
                        .join(",")
                );
                record(open, 0x05, &message(step, &[9, 9], body.as_bytes()));
            }
            7 => record(open, 0x0C, &metadata()),
            8 => match chunk.take() {
                Some(records) => record(&mut file, 0x06, &whole_chunk(step, &records)),
                None => chunk = Some(Vec::new()),
            },
            9 => {
                record(open, 0x0F, &[0; 4]);
                record(open, 0x02, &[0; 20]);
                open.extend_from_slice(MAGIC);
            }
            10 => open.extend_from_slice(take(&mut rest, usize::from(step / 12))),
            _ => {
                let (kind, body) = (take(&mut rest, 1), take(&mut rest, usize::from(step / 12)));
                record(open, kind.first().copied().unwrap_or(0), body);
            }
        }
    }
    file
}

fn take<'a>(rest: &mut &'a [u8], count: usize) -> &'a [u8] {
    let (taken, left) = rest.split_at(count.min(rest.len()));
    *rest = left;
    taken
}

fn record(to: &mut Vec<u8>, kind: u8, body: &[u8]) {
    to.push(kind);
    to.extend_from_slice(&(body.len() as u64).to_le_bytes());
    to.extend_from_slice(body);
}

fn text(text: &str) -> Vec<u8> {
    let len = u32::try_from(text.len()).expect("a short text");
    [&len.to_le_bytes(), text.as_bytes()].concat()
}

fn channel(step: u8) -> Vec<u8> {
    let topic = ["/wire/to_arm", "/wire/from_arm", "/events", ""][usize::from(step / 12 % 4)];
    let encoding = if step < 200 { "json" } else { "cdr" };
    let id = [step / 12 % 4, 0, 0, 0];
    [&id, &text(topic)[..], &text(encoding), &[0; 4]].concat()
}

fn message(step: u8, at: &[u8], data: &[u8]) -> Vec<u8> {
    let mut at_ns = [0; 8];
    at_ns[4..4 + at.len()].copy_from_slice(at);
    let id = [step / 12 % 4, 0, 0, 0, 0, 0];
    [&id, &at_ns[..], &at_ns, data].concat()
}

fn metadata() -> Vec<u8> {
    let fields = [
        ("program", "fuzz"),
        ("start", "1970-01-01T00:00:10Z"),
        ("dialect", "firmware-1.1"),
    ];
    let fields: Vec<u8> = fields
        .iter()
        .flat_map(|(name, value)| [text(name), text(value)].concat())
        .collect();
    let len = u32::try_from(fields.len()).expect("a few fields");
    [&text("dobot"), &len.to_le_bytes()[..], &fields].concat()
}

/// A chunk that is not compressed, or says that it is, without a sum (CRC 0).
fn whole_chunk(step: u8, records: &[u8]) -> Vec<u8> {
    let size = records.len() as u64;
    let compression = if step < 200 { "" } else { "zstd" };
    [
        &[0; 16],
        &size.to_le_bytes()[..],
        &[0; 4],
        &text(compression),
        &size.to_le_bytes(),
        records,
    ]
    .concat()
}

const MAGIC: &[u8; 8] = b"\x89MCAP0\r\n";

/// More than an input of some hundred bytes can tell.
const MAX_COUNT: usize = 100_000;
