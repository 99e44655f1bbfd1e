use dobot_import::Source;

/// Files of every format that a decoder of others reads, and packed ones: an error, or ink, but never a
/// panic, and never more memory than a drawing needs.
pub fn files(input: &[u8]) {
    let Some((&kind, rest)) = input.split_first() else {
        return;
    };
    let begin = BEGINS[usize::from(kind) % BEGINS.len()];
    let file = [begin, rest].concat();
    if let Ok(source) = Source::of_file("-", file) {
        crate::read(&source);
    }
}

const BEGINS: [&[u8]; 8] = [
    b"",
    b"GIF89a\x04\x00\x04\x00\x80\x00\x00\x00\x00\x00\xff\xff\xff,\x00\x00\x00\x00\x04\x00\x04\x00\x00",
    b"RIFF\x40\x00\x00\x00WEBPVP8L",
    b"RIFF\x40\x00\x00\x00WEBPVP8 ",
    b"BM\x46\x00\x00\x00\x00\x00\x00\x00\x36\x00\x00\x00\x28\x00\x00\x00\x04\x00\x00\x00\x04\x00\x00\x00\x01\x00\x18\x00",
    b"II*\0\x08\x00\x00\x00",
    b"MM\0*\x00\x00\x00\x08",
    b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03",
];
