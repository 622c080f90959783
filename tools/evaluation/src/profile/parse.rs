//! Parser of profiles. An error names line and key, and the remedy.

use std::ops::Range;

use bica_vision::colour::{Filter, Filters};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::CLASSES;

/// Error in a profile.
#[derive(Debug)]
pub(super) struct ParseError {
    pub(super) what: String,
    pub(super) help: String,
}

type Entry<'a> = Spanned<DeValue<'a>>;

/// Parses a profile.
pub(super) fn parse(text: &str) -> Result<Filters, ParseError> {
    let reader = Reader { text };
    let root = DeTable::parse(text).map_err(|error| {
        let help = "a profile is TOML: `[class]` and under it `key = value` lines";
        reader.wrong(&error.span().unwrap_or_default(), None, error.message(), help)
    })?;
    let root = root.get_ref();
    let known = |key: &str| CLASSES.contains(&key);
    if let Some((key, _)) = root.iter().find(|(key, _)| !known(key.get_ref())) {
        let help = format!("the classes are {}", CLASSES.join(", "));
        return Err(reader.wrong(&key.span(), Some(key.get_ref()), "there is no such class", &help));
    }
    let [orange, yellow, blue, green, white] = CLASSES.map(|class| reader.class(root, class));
    Ok(Filters { orange: orange?, yellow: yellow?, blue: blue?, white: white?, green: green? })
}

struct Reader<'a> {
    text: &'a str,
}

impl Reader<'_> {
    fn class(&self, root: &DeTable<'_>, class: &str) -> Result<Filter, ParseError> {
        let help = format!("write a section `[{class}]`; without lines it accepts every colour");
        let end = self.text.len()..self.text.len();
        let entry = root.get(class).ok_or_else(|| self.wrong(&end, Some(class), "the class is missing", &help))?;
        let DeValue::Table(table) = entry.get_ref() else {
            return Err(self.wrong(&entry.span(), Some(class), "this is not a section", &help));
        };
        let mut filter = Filter::ANY;
        for (key, value) in table {
            let name = format!("{class}.{}", key.get_ref());
            filter = match key.get_ref().as_ref() {
                "hue" => self.hue(filter, &name, value)?,
                "saturation" => {
                    let [min, max] = self.range(&name, value, u16::MAX)?;
                    filter.saturation(min, max)
                }
                "luma" => {
                    let [min, max] = self.range(&name, value, u8::MAX)?;
                    filter.luma(min, max)
                }
                "chroma" => filter.chroma(self.number(&name, value, u8::MAX)?),
                _ => {
                    let help = "the keys are hue, saturation, luma and chroma";
                    return Err(self.wrong(&key.span(), Some(&name), "there is no such key", help));
                }
            };
        }
        Ok(filter)
    }

    fn hue(&self, filter: Filter, key: &str, value: &Entry<'_>) -> Result<Filter, ParseError> {
        let [from, to] = self.pair(key, value, 719_i16)?;
        if !(1..180).contains(&(to - from)) || from >= 360 {
            let help = "write [from, to] in degrees, from 0 to 359 and to 1 to 179 more; 350 to 10 is [350, 370]";
            return Err(self.wrong(&value.span(), Some(key), &format!("{from} to {to} is not a range of hues"), help));
        }
        Ok(filter.hue(from, to))
    }

    /// Returns two numbers from 0 to `most`, the first not above the second.
    fn range<T: Number>(&self, key: &str, value: &Entry<'_>, most: T) -> Result<[T; 2], ParseError> {
        let [min, max] = self.pair(key, value, most)?;
        if min > max {
            let help = "write [min, max]";
            return Err(self.wrong(&value.span(), Some(key), &format!("{min} is more than {max}"), help));
        }
        Ok([min, max])
    }

    fn pair<T: Number>(&self, key: &str, value: &Entry<'_>, most: T) -> Result<[T; 2], ParseError> {
        let list: &[Entry<'_>] = value.get_ref().as_array().map_or(&[], |list| list);
        let [first, second] = list else {
            let help = "write two whole numbers in brackets, like [10, 20]";
            return Err(self.wrong(&value.span(), Some(key), "these are not two numbers", help));
        };
        Ok([self.number(key, first, most)?, self.number(key, second, most)?])
    }

    fn number<T: Number>(&self, key: &str, value: &Entry<'_>, most: T) -> Result<T, ParseError> {
        let integer = value.get_ref().as_integer();
        let number = integer.and_then(|integer| i64::from_str_radix(integer.as_str(), integer.radix()).ok());
        let fits =
            number.and_then(|number| T::try_from(number).ok()).filter(|number| *number <= most && number.is_positive());
        fits.ok_or_else(|| {
            let found = &self.text[value.span()];
            let help = format!("write a whole number from 0 to {most}");
            self.wrong(&value.span(), Some(key), &format!("`{found}` is out of range"), &help)
        })
    }

    fn wrong(&self, at: &Range<usize>, key: Option<&str>, what: &str, help: &str) -> ParseError {
        let before = self.text.get(..at.start).unwrap_or(self.text);
        let line = 1 + before.matches('\n').count();
        let key = key.map(|key| format!(" `{key}`:")).unwrap_or_default();
        ParseError { what: format!("line {line}:{key} {what}"), help: help.to_owned() }
    }
}

/// Integer type of a threshold.
trait Number: Copy + PartialOrd + std::fmt::Display + TryFrom<i64> + Default {
    fn is_positive(self) -> bool {
        self >= Self::default()
    }
}

impl Number for u8 {}
impl Number for u16 {}
impl Number for i16 {}

#[cfg(test)]
mod tests {
    use super::*;

    const REST: &str = "[yellow]\n[blue]\n[green]\n[white]\n";

    #[test]
    fn a_missing_threshold_accepts_every_value() {
        let filters = parse(&format!("[orange]\nhue = [350, 370]\n{REST}")).expect("a profile");
        assert_eq!((filters.orange, filters.green), (Filter::ANY.hue(350, 10), Filter::ANY));
    }

    #[test]
    fn errors_name_line_and_key() {
        let wrong = |orange: &str| parse(&format!("# A hall.\n[orange]\n{orange}\n{REST}")).expect_err(orange).what;
        assert_eq!(wrong("hue = [10, 200]"), "line 3: `orange.hue`: 10 to 200 is not a range of hues");
        assert_eq!(wrong("hue = [400, 410]"), "line 3: `orange.hue`: 400 to 410 is not a range of hues");
        assert_eq!(wrong("\nluma = [9, 300]"), "line 4: `orange.luma`: `300` is out of range");
        assert_eq!(wrong("luma = [-1, 30]"), "line 3: `orange.luma`: `-1` is out of range");
        assert_eq!(wrong("luma = [60, 30]"), "line 3: `orange.luma`: 60 is more than 30");
        assert_eq!(wrong("saturation = [10]"), "line 3: `orange.saturation`: these are not two numbers");
        assert_eq!(wrong("chroma = 1.5"), "line 3: `orange.chroma`: `1.5` is out of range");
        assert_eq!(wrong("colour = 3"), "line 3: `orange.colour`: there is no such key");
        assert_eq!(wrong("[red]"), "line 3: `red`: there is no such class");
        assert!(wrong("chroma = = 3").starts_with("line 3: "));
        assert_eq!(parse(REST).expect_err("orange").what, "line 5: `orange`: the class is missing");
    }
}
