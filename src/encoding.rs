//! Encodings of text other than UTF-8, told by the first bytes.

/// Words for a text that is no UTF-8.
pub const WIDE: &str = "it is UTF-16 text; save it as UTF-8";

/// Whether bytes begin as a text in UTF-16 does: with its mark, or with two letters of ASCII. UTF-32 has the same mark.
pub fn is_wide(start: &[u8]) -> bool {
    let letter = |byte: u8| matches!(byte, b'\t' | b'\n' | b'\r' | b' '..=b'~');
    match *start {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        [a, 0, b, 0, ..] | [0, a, 0, b, ..] => letter(a) && letter(b),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_text_is_told_from_numbers_and_from_other_text() {
        let wide = |text: &str, unit: fn(u16) -> [u8; 2]| {
            text.encode_utf16().flat_map(unit).collect::<Vec<u8>>()
        };
        for unit in [u16::to_le_bytes, u16::to_be_bytes] {
            assert!(is_wide(&wide("\u{feff}[", unit)));
            assert!(is_wide(&wide("{\"", unit)));
            assert!(is_wide(&wide("\r\n", unit)));
            assert!(!is_wide(&wide("é木", unit)));
        }
        assert!(!is_wide(b"[{}]") && !is_wide(b"") && !is_wide(b"\xef\xbb\xbf["));
        // The header of a MERL file, and nothing but zeros.
        assert!(!is_wide(&90i32.to_le_bytes()) && !is_wide(&[0; 4]));
    }
}
