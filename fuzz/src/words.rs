//! Texts made of the words of a format.

/// A text of half-finished words: after a first byte that is odd, each byte is one of them, so that
/// commands are found sooner than by letters alone; after an even one the rest is the text.
pub(crate) fn spelled(input: &[u8], words: &[&str]) -> Vec<u8> {
    let Some((kind, rest)) = input.split_first() else {
        return Vec::new();
    };
    if kind % 2 == 0 {
        return rest.to_vec();
    }
    let words = rest
        .iter()
        .map(|&byte| words[usize::from(byte) % words.len()]);
    words.collect::<String>().into_bytes()
}
