//! Decoding of session files that were written by word processors or on other systems.

use super::Problem;

/// Spaces of word processors and the byte-order mark, which are read as spaces.
const SPACES: [char; 4] = ['\u{a0}', '\u{2007}', '\u{202f}', '\u{feff}'];
/// Quotation marks of word processors.
const QUOTES: &str = "“”„‟«»‹›‘’‚‛";

/// Reads a file as text.
///
/// # Errors
/// If the text is not UTF-8 with line ends of Unix or Windows. The problem names the encoding and how to save the file.
pub(super) fn decode(bytes: &[u8]) -> Result<String, Problem> {
    let wrong = |line: usize, what: &str| Err(Problem::at((line, 1), what));
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || bytes.iter().take(64).any(|b| *b == 0) {
        return wrong(1, "the file is in UTF-16 or no text: save it as text in UTF-8");
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let (good, rest) = bytes.split_at(error.valid_up_to());
            let line = good.split(|byte| *byte == b'\n').count();
            let byte = rest[0];
            let what = format!(
                "byte 0x{byte:02X} is not UTF-8, but may be Latin-1 or Windows-1252: save the file as text in UTF-8"
            );
            return wrong(line, &what);
        }
    };
    match text.replace("\r\n", "\n") {
        unix if unix.contains('\r') => {
            wrong(1, "lines end with CR, as on old Macs: save the file with line ends of Unix or Windows")
        }
        _ => Ok(text.strip_prefix('\u{feff}').unwrap_or(text).replace(SPACES, " ")),
    }
}

/// Message for a character that cannot begin a word; `before` and `after` are the rest of its line.
pub(super) fn odd_sign(before: &str, sign: char, after: &str) -> String {
    let named =
        if sign.is_ascii_graphic() { format!("`{sign}`") } else { format!("`{sign}` (U+{:04X})", u32::from(sign)) };
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    if QUOTES.contains(sign) {
        format!("{named} is a quotation mark of a word processor: write `\"`, as straight quotes")
    } else if sign == ',' && digit(before.chars().next_back()) && digit(after.chars().next()) {
        format!("{named} stands in a number: write a decimal point, as 1.5")
    } else {
        format!("{named} cannot stand here")
    }
}

/// Message for a text without a closing quote.
pub(super) fn no_end(text: &str) -> String {
    let quote = text.chars().find(|sign| QUOTES.contains(*sign));
    quote.map_or_else(
        || "the text has no closing quote `\"`".to_owned(),
        |sign| {
            format!(
                "the text has no closing quote `\"`: `{sign}` (U+{:04X}) is one of a word processor",
                u32::from(sign)
            )
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_spaces_of_word_processors_are_read() {
        let text = decode("\u{feff}say\u{a0}\"Hello\"\r\nwait\u{202f}1 s".as_bytes());
        assert_eq!(text.as_deref(), Ok("say \"Hello\"\r\nwait 1 s"));
    }

    #[test]
    fn other_encodings_are_named_with_a_remedy() {
        let utf16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
        for (bytes, line, what) in [
            (utf16("\u{feff}wait 1 s"), 1, "UTF-16"),
            (utf16("wait 1 s"), 1, "UTF-16"),
            (b"wait 1 s\nsay \"Gr\xfc\xdfe\"".to_vec(), 2, "Latin-1"),
            (b"wait 1 s\rwait 2 s".to_vec(), 1, "CR"),
        ] {
            let problem = decode(&bytes).expect_err(what);
            assert!(problem.line == line && problem.what.contains(what) && problem.what.contains("save"), "{problem}");
        }
    }
}
