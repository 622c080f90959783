//! Words of a line.

use std::ops::RangeInclusive;

use winnow::ascii::{float, multispace0};
use winnow::combinator::{alt, delimited, preceded, repeat, terminated};
use winnow::prelude::*;
use winnow::stream::Location;
use winnow::token::{one_of, take_till, take_while};
use winnow::{LocatingSlice, Result};

use super::{Problem, text};

type Input<'a> = LocatingSlice<&'a str>;
/// Line and column, from 1.
pub(super) type Place = (usize, usize);
type Checked<T> = std::result::Result<T, Problem>;

/// A word, a number or a text in quotes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Word<'a> {
    Name(&'a str),
    Number(f32),
    Text(&'a str),
}

fn word<'a>(input: &mut Input<'a>) -> Result<(usize, Word<'a>)> {
    let at = input.current_token_start();
    let start = one_of(|c: char| c.is_alphabetic());
    let name = (start, take_while(0.., |c: char| c.is_alphanumeric() || "_.-".contains(c))).take();
    let digits = one_of(('0'..='9', '-', '.'));
    let number = (winnow::combinator::peek(digits), float).map(|(_, number): (_, f32)| number);
    let text = delimited('"', take_till(0.., '"'), '"');
    let word = alt((text.map(Word::Text), name.map(Word::Name), number.map(Word::Number))).parse_next(input)?;
    Ok((at, word))
}

fn words<'a>(input: &mut Input<'a>) -> Result<Vec<(usize, Word<'a>)>> {
    preceded(multispace0, repeat(0.., terminated(word, multispace0))).parse_next(input)
}

/// Words of a line that have not been read yet.
pub(super) struct Line<'a> {
    number: usize,
    text: &'a str,
    words: std::vec::IntoIter<(usize, Word<'a>)>,
}

impl<'a> Line<'a> {
    /// Splits a line, up to its comment, into words. `number` is the number of the line, from 1.
    pub(super) fn new(number: usize, line: &'a str) -> Checked<Self> {
        let mut input = LocatingSlice::new(line);
        let words = words(&mut input).unwrap_or_default();
        let (text, rest) = line.split_at(input.current_token_start());
        let line = Self { number, text, words: words.into_iter() };
        let Some(sign) = rest.chars().next().filter(|sign| *sign != '#') else { return Ok(line) };
        let at = line.place(text.len());
        if sign == '"' {
            return Err(Problem::at(at, text::no_end(rest)));
        }
        let what = text::odd_sign(line.text, sign, &rest[sign.len_utf8()..]);
        Err(Problem::new(at, what, "", &["a word", "a number", "a text in quotes"]))
    }

    fn place(&self, offset: usize) -> Place {
        (self.number, self.text[..offset].chars().count() + 1)
    }

    /// Returns whether all words have been read.
    pub(super) fn is_done(&self) -> bool {
        self.words.as_slice().is_empty()
    }

    /// Returns whether the next word is a number.
    pub(super) fn next_is_number(&self) -> bool {
        matches!(self.first(), Some((_, Word::Number(_))))
    }

    fn first(&self) -> Option<(usize, Word<'a>)> {
        self.words.as_slice().first().copied()
    }

    /// Position of the next word, or of the end of the line.
    pub(super) fn next_place(&self) -> Place {
        self.place(self.first().map_or(self.text.trim_end().len(), |(offset, _)| offset))
    }

    /// Creates an error at the next word.
    pub(super) fn wrong(&self, wanted: &str, allowed: &[&str]) -> Problem {
        let at = self.next_place();
        let (what, found) = match self.first() {
            None => (format!("{wanted} is missing"), ""),
            Some((_, Word::Name(name))) => (format!("`{name}` is not {wanted}"), name),
            Some((_, Word::Number(number))) => (format!("{number} is not {wanted}"), ""),
            Some((_, Word::Text(text))) => (format!("\"{text}\" is not {wanted}"), ""),
        };
        Problem::new(at, what, found, allowed)
    }

    /// Reads the next word with `read`. If `read` does not accept it, the error lists the allowed words.
    fn take<T>(&mut self, wanted: &str, allowed: &[&str], read: impl FnOnce(Word<'a>) -> Option<T>) -> Checked<T> {
        let read = self.first().and_then(|(_, word)| read(word)).ok_or_else(|| self.wrong(wanted, allowed))?;
        self.words.next();
        Ok(read)
    }

    /// Reads one of the words in `choices`.
    pub(super) fn choice<T: Copy>(&mut self, wanted: &str, choices: &[(&str, T)]) -> Checked<T> {
        let allowed: Vec<_> = choices.iter().map(|(name, _)| *name).collect();
        let chosen = |word| choices.iter().find(|(name, _)| word == Word::Name(name)).map(|(_, choice)| *choice);
        self.take(wanted, &allowed, chosen)
    }

    /// Reads the word `wanted` if it is the next one; returns whether it was.
    pub(super) fn has(&mut self, wanted: &str) -> bool {
        self.expect(&[wanted]).is_ok()
    }

    /// Reads all words in `wanted`, in order.
    pub(super) fn expect(&mut self, wanted: &[&str]) -> Checked<()> {
        wanted.iter().try_for_each(|name| {
            self.take(&format!("`{name}`"), &[name], |word| (word == Word::Name(name)).then_some(()))
        })
    }

    /// Reads a name that the author chooses; returns it with its position.
    pub(super) fn name(&mut self, wanted: &str) -> Checked<(&'a str, Place)> {
        let at = self.next_place();
        self.take(wanted, &[], |word| if let Word::Name(name) = word { Some((name, at)) } else { None })
    }

    /// Reads a text in quotes; returns it with its position.
    pub(super) fn text(&mut self, wanted: &str) -> Checked<(&'a str, Place)> {
        let at = self.next_place();
        let text = |word| if let Word::Text(text) = word { Some(text) } else { None };
        let text = self.take(wanted, &["a text in quotes"], text)?;
        if text.trim().is_empty() { Err(Problem::at(at, format!("{wanted} is empty"))) } else { Ok((text, at)) }
    }

    /// Reads a number within a range.
    pub(super) fn number(&mut self, wanted: &str, range: RangeInclusive<f32>) -> Checked<f32> {
        let allowed = format!("{} to {}", range.start(), range.end());
        let within = |word| if let Word::Number(number) = word { Some(number) } else { None };
        self.take(wanted, &[&allowed], |word| within(word).filter(|number| range.contains(number)))
    }

    /// Reads a number within a range, and its unit.
    pub(super) fn measure(&mut self, wanted: &str, range: RangeInclusive<f32>, unit: &str) -> Checked<f32> {
        let number = self.number(wanted, range)?;
        self.expect(&[unit]).map(|()| number)
    }

    /// Reads a whole number within a range.
    pub(super) fn count(&mut self, wanted: &str, range: RangeInclusive<u16>) -> Checked<u16> {
        let rest = self.words.clone();
        let number = self.number(wanted, f32::from(*range.start())..=f32::from(*range.end()))?;
        if number.fract() == 0.0 {
            return Ok(number as u16);
        }
        self.words = rest;
        Err(self.wrong(wanted, &["a whole number"]))
    }

    /// Checks that all words have been read.
    pub(super) fn end(&self) -> Checked<()> {
        if self.is_done() { Ok(()) } else { Err(self.wrong("the end of the line", &[])) }
    }
}
