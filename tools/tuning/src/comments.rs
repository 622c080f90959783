//! Comments of a tune file that a person wrote.

use std::collections::BTreeMap;

/// Beginning of a comment at the end of a line that [`render`](crate::render) wrote.
pub(crate) const GENERATED: &str = "# default ";

/// Comment lines of a tune file, by the section and the name of the value that they precede. An empty name is the beginning of
/// the file or of a section.
#[derive(Debug, Default)]
pub(crate) struct Comments {
    before: BTreeMap<(String, String), Vec<String>>,
    /// Comment lines after the last value.
    end: Vec<String>,
}

impl Comments {
    /// Reads the comments of a file. A comment at the end of a line moves before the line.
    pub(crate) fn read(text: &str) -> Self {
        let (mut comments, mut section, mut pending) = (Self::default(), String::new(), Vec::new());
        for line in text.lines().map(str::trim) {
            let (code, comment) = split(line);
            pending.extend(comment.filter(|comment| !comment.starts_with(GENERATED)).map(str::to_owned));
            let key = match (code.strip_prefix('[').and_then(|code| code.strip_suffix(']')), code.split_once('=')) {
                (Some(name), _) => {
                    unquoted(name).clone_into(&mut section);
                    ""
                }
                (None, Some((key, _))) => unquoted(key),
                // Comments before an empty line and before all sections belong to the file.
                (None, None) if section.is_empty() && line.is_empty() => "",
                (None, None) => continue,
            };
            comments.before.entry((section.clone(), key.to_owned())).or_default().append(&mut pending);
        }
        Self { end: pending, ..comments }
    }

    /// Takes the comments of a place, without the `generated` lines.
    pub(crate) fn take(&mut self, section: &str, key: &str, generated: &[String]) -> Vec<String> {
        let mut lines = self.before.remove(&(section.to_owned(), key.to_owned())).unwrap_or_default();
        lines.retain(|line| !generated.contains(line));
        lines
    }

    /// Takes all remaining comments.
    pub(crate) fn rest(self) -> impl Iterator<Item = String> {
        self.before.into_values().flatten().chain(self.end)
    }
}

/// Returns a key without quotes.
fn unquoted(key: &str) -> &str {
    key.trim().trim_matches(['"', '\''])
}

/// Returns the text before a comment, and the comment. A `#` in a string does not begin a comment.
fn split(line: &str) -> (&str, Option<&str>) {
    let (mut quote, mut escaped) = (None, false);
    for (at, char) in line.char_indices() {
        match (quote, char) {
            _ if escaped => escaped = false,
            (Some('"'), '\\') => escaped = true,
            (Some(open), _) if open == char => quote = None,
            (None, '"' | '\'') => quote = Some(char),
            (None, '#') => return (line[..at].trim_end(), Some(&line[at..])),
            _ => {}
        }
    }
    (line, None)
}
