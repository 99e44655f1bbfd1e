//! The text encoding of a file: UTF-8 since version 2007, a code page before.

use std::borrow::Cow;

use encoding_rs::{BIG5, EUC_KR, Encoding, GBK, SHIFT_JIS, WINDOWS_1252};

use super::pairs::pairs;
use crate::place::beginning;

/// The header entries about the encoding.
#[derive(Debug, Default)]
struct Header<'a> {
    /// The version, such as `AC1015`.
    version: &'a [u8],
    /// The code page, such as `ANSI_1252`.
    code_page: Option<&'a [u8]>,
}

impl<'a> Header<'a> {
    /// Reads up to the end of the first section; without a header nothing is known.
    fn read(text: &'a [u8]) -> Self {
        let mut header = Self::default();
        let mut variable: &[u8] = b"";
        for pair in pairs(text, beginning(text)).map_while(Result::ok) {
            match (pair.code, variable) {
                (0, _) if pair.value == b"ENDSEC" => break,
                (9, _) => variable = pair.value,
                (1, b"$ACADVER") => header.version = pair.value,
                (3, b"$DWGCODEPAGE") => header.code_page = Some(pair.value),
                _ => {}
            }
        }
        header
    }

    /// Whether the whole file must be UTF-8. Version names sort alphabetically.
    fn is_in_utf8(&self) -> bool {
        self.version >= &b"AC1021"[..]
    }
}

/// Converts a file to UTF-8, line by line; returns the name of its code page if it is unknown.
///
/// Many programs write UTF-8 whatever the header declares, so that a line in UTF-8 stays unchanged.
/// In two-byte code pages short words may look like UTF-8; there the header decides.
pub(super) fn in_utf8(text: &[u8]) -> (Cow<'_, [u8]>, Option<String>) {
    if std::str::from_utf8(text).is_ok() {
        return (Cow::Borrowed(text), None);
    }
    let header = Header::read(text);
    let declared = header.code_page.map_or(Some(WESTERN), CodePage::of);
    let code_page = declared.unwrap_or(WESTERN);
    let may_stay = header.is_in_utf8() || code_page.is_single_byte();
    let mut decoded = Vec::with_capacity(text.len());
    for line in text.split_inclusive(|&byte| byte == b'\n') {
        if line.is_ascii() || may_stay && std::str::from_utf8(line).is_ok() {
            decoded.extend_from_slice(line);
        } else {
            decoded.extend_from_slice(code_page.decode(line).as_bytes());
        }
    }
    let unknown = header.code_page.filter(|_| declared.is_none());
    let unknown = unknown.map(|unknown| String::from_utf8_lossy(unknown).into_owned());
    (Cow::Owned(decoded), unknown)
}

/// The encoding of a file.
#[derive(Clone, Copy, Debug)]
enum CodePage {
    Known(&'static Encoding),
    /// The characters of the bytes from 128 on.
    Dos(&'static str),
}

impl CodePage {
    fn of(name: &[u8]) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let dos = DOS.iter().find(|page| name == page.0.as_bytes());
        match dos {
            Some(&(_, letters)) => Some(Self::Dos(letters)),
            None => encoding(&name).map(Self::Known),
        }
    }

    fn is_single_byte(self) -> bool {
        match self {
            Self::Known(encoding) => encoding.is_single_byte(),
            Self::Dos(_) => true,
        }
    }

    fn decode(self, line: &[u8]) -> Cow<'_, str> {
        match self {
            Self::Known(encoding) => encoding.decode_without_bom_handling(line).0,
            Self::Dos(letters) => {
                let letters: Vec<char> = letters.chars().collect();
                let letter = |byte: &u8| match byte.checked_sub(128) {
                    Some(number) => letters[usize::from(number)],
                    None => char::from(*byte),
                };
                line.iter().map(letter).collect()
            }
        }
    }
}

/// The standard name of a lower-case code page.
fn encoding(name: &[u8]) -> Option<&'static Encoding> {
    let number = name.strip_prefix(b"ansi_");
    let Some(number) = number.or_else(|| name.strip_prefix(b"dos")) else {
        return Encoding::for_label(name).filter(|encoding| encoding.is_ascii_compatible());
    };
    match number {
        b"874" => Encoding::for_label(b"windows-874"),
        b"932" => Some(SHIFT_JIS),
        b"936" => Some(GBK),
        b"949" => Some(EUC_KR),
        b"950" => Some(BIG5),
        _ => Encoding::for_label(&[b"cp", number].concat()),
    }
}

const WESTERN: CodePage = CodePage::Known(WINDOWS_1252);

/// DOS code pages: the characters of their bytes from 128 on.
const DOS: [(&str, &str); 3] = [
    (
        "dos437",
        "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u{A0}",
    ),
    (
        "dos850",
        "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜø£Ø×ƒáíóúñÑªº¿®¬½¼¡«»░▒▓│┤ÁÂÀ©╣║╗╝¢¥┐└┴┬├─┼ãÃ╚╔╩╦╠═╬¤ðÐÊËÈıÍÎÏ┘┌█▄¦Ì▀ÓßÔÒõÕµþÞÚÛÙýÝ¯´\u{AD}±‗¾¶§÷¸°¨·¹³²■\u{A0}",
    ),
    (
        "dos852",
        "ÇüéâäůćçłëŐőîŹÄĆÉĹĺôöĽľŚśÖÜŤťŁ×čáíóúĄąŽžĘę¬źČş«»░▒▓│┤ÁÂĚŞ╣║╗╝Żż┐└┴┬├─┼Ăă╚╔╩╦╠═╬¤đĐĎËďŇÍÎě┘┌█▄ŢŮ▀ÓßÔŃńňŠšŔÚŕŰýÝţ´\u{AD}˝˛ˇ˘§÷¸°¨˙űŘř■\u{A0}",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_byte_of_dos_is_a_letter() {
        for (name, letters) in DOS {
            assert_eq!(letters.chars().count(), 128, "{name}");
            assert!(letters.chars().all(|c| !c.is_ascii()), "{name}");
        }
    }
}
