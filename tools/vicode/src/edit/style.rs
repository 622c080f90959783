//! Format of new code: that of `rustfmt`, with the line ends and the indentation of the file.

use crate::model::Component;
use crate::read::{Kind, lexed};

/// Default line length of `rustfmt`, characters.
pub const DEFAULT_WIDTH: usize = 100;

/// Format of a file.
#[derive(Clone, Debug)]
pub(super) struct Style {
    /// `\n` or `\r\n`.
    pub(super) newline: &'static str,
    /// Maximum line length, characters.
    pub(super) width: usize,
    /// Indentation of the functions of the block.
    pub(super) indent: String,
    /// Indentation of the block.
    pub(super) outer: String,
}

impl Style {
    /// Derives the format from a file, and from one of its blocks if given.
    pub(super) fn of(text: &str, component: Option<&Component>, width: usize) -> Self {
        let lines = text.matches('\n').count();
        let newline = if text.matches("\r\n").count() * 2 > lines { "\r\n" } else { "\n" };
        let outer = component.map_or_else(String::new, |component| indentation(text, component.span.start).to_owned());
        let functions = component.iter().flat_map(|component| component.functions());
        let indent = functions.min_by_key(|function| function.span.start).and_then(|first| {
            let before = indentation(text, first.span.start);
            (text[..first.span.start].ends_with(before) && starts_line(text, first.span.start))
                .then(|| before.to_owned())
        });
        let indent = indent.unwrap_or_else(|| format!("{outer}    "));
        Self { newline, width, indent, outer }
    }

    /// Returns the indentation of one level.
    pub(super) fn unit(&self) -> &str {
        if self.indent.starts_with('\t') { "\t" } else { "    " }
    }

    /// Indents lines of code, except those within a string or a comment of several lines.
    pub(super) fn lay(&self, code: &str, indent: &str) -> String {
        let code = code.replace("\r\n", "\n");
        let inside = continued(&code);
        let lines: Vec<&str> = code.split('\n').collect();
        let common = common_indent(&lines, &inside);
        let mut result = String::new();
        for (index, line) in lines.iter().enumerate() {
            if index > 0 {
                result.push_str(self.newline);
            }
            if inside[index] {
                result.push_str(line);
            } else if !line.trim().is_empty() {
                result.push_str(indent);
                result.push_str(line[common..].trim_end());
            }
        }
        result
    }

    /// Formats a doc comment, each line with its indentation and line end.
    pub(super) fn docs(&self, docs: &str, indent: &str) -> String {
        let docs = docs.trim_end().trim_start_matches(['\n', '\r']);
        if docs.is_empty() {
            return String::new();
        }
        let mut result = String::new();
        // Rust does not allow a bare carriage return in a doc comment.
        for line in docs.replace("\r\n", "\n").split(['\n', '\r']).map(str::trim_end) {
            result.push_str(indent);
            result.push_str(if line.is_empty() { "///" } else { "/// " });
            result.push_str(line);
            result.push_str(self.newline);
        }
        result
    }

    /// Formats the body of a function with its braces.
    pub(super) fn body(&self, body: &str, indent: &str) -> String {
        format!("{{{}}}", self.block(body, indent))
    }

    /// Formats the body of a function without its braces.
    pub(super) fn block(&self, body: &str, indent: &str) -> String {
        let body = body.trim_matches(['\n', '\r']).trim_end();
        if body.trim().is_empty() {
            return String::new();
        }
        let laid = self.lay(body, &format!("{indent}{}", self.unit()));
        format!("{}{laid}{}{indent}", self.newline, self.newline)
    }
}

/// Returns for each line whether it begins within a string or a comment.
fn continued(code: &str) -> Vec<bool> {
    let mut inside = vec![false; code.split('\n').count()];
    let mut line = 0;
    for token in lexed(code) {
        let breaks = token.text.matches('\n').count();
        if token.kind != Kind::Space {
            inside[line + 1..][..breaks].fill(true);
        }
        line += breaks;
    }
    inside
}

/// Returns the common indentation of all lines, bytes.
fn common_indent(lines: &[&str], inside: &[bool]) -> usize {
    let lines = lines.iter().zip(inside).filter(|(line, inside)| !**inside && !line.trim().is_empty());
    lines.map(|(line, _)| line.len() - line.trim_start_matches([' ', '\t']).len()).min().unwrap_or(0)
}

/// Converts `BallDetector` to `ball_detector`.
pub(super) fn snake(name: &str) -> String {
    let mut snake = String::new();
    for character in name.chars() {
        if character.is_uppercase() && !snake.is_empty() && !snake.ends_with('_') {
            snake.push('_');
        }
        snake.extend(character.to_lowercase());
    }
    snake
}

/// Returns the indentation of a line.
pub(super) fn indentation(text: &str, at: usize) -> &str {
    let line = &text[line_start(text, at)..];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

/// Returns the offset of the beginning of a line.
pub(super) fn line_start(text: &str, at: usize) -> usize {
    text[..at].rfind('\n').map_or(0, |newline| newline + 1)
}

/// Returns the number of a line, from 1.
pub(super) fn line_number(text: &str, at: usize) -> usize {
    1 + text[..at].matches('\n').count()
}

/// Returns the offset of the end of a line, before `\r\n` or `\n`.
pub(super) fn line_end(text: &str, at: usize) -> usize {
    let end = text[at..].find('\n').map_or(text.len(), |newline| at + newline);
    if text[at..end].ends_with('\r') { end - 1 } else { end }
}

/// Returns whether only white space precedes a byte in its line.
pub(super) fn starts_line(text: &str, at: usize) -> bool {
    text[line_start(text, at)..at].trim().is_empty()
}
