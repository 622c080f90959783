//! Parser of profiles. An error names the line and the remedy.

use std::fmt::Display;
use std::ops::Range;

use bica_vision::colour::{Filter, Filters};
use serde::Deserialize;
use toml::Spanned;

/// Error in a profile.
#[derive(Debug)]
pub(super) struct ParseError {
    pub(super) what: String,
    pub(super) help: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Classes {
    orange: Class,
    yellow: Class,
    blue: Class,
    green: Class,
    white: Class,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Class {
    hue: Option<Spanned<[u16; 2]>>,
    saturation: Option<Spanned<[u16; 2]>>,
    luma: Option<Spanned<[u8; 2]>>,
    chroma: Option<u8>,
}

/// Parses a profile.
pub(super) fn parse(text: &str) -> Result<Filters, ParseError> {
    let Classes { orange, yellow, blue, green, white } = toml::from_str(text).map_err(|error| {
        let help = "a profile has the sections [orange], [yellow], [blue], [green] and [white], and in them lines \
                    `hue = [from, to]`, `saturation = [min, max]`, `luma = [min, max]` (0 to 255) and `chroma = min` (0 to 255)";
        wrong(text, &error.span().unwrap_or_default(), error.message(), help)
    })?;
    let filter = |class: Class| class.filter(text);
    let (orange, yellow, blue) = (filter(orange)?, filter(yellow)?, filter(blue)?);
    Ok(Filters { orange, yellow, blue, white: filter(white)?, green: filter(green)? })
}

impl Class {
    fn filter(self, text: &str) -> Result<Filter, ParseError> {
        let mut filter = Filter::ANY.chroma(self.chroma.unwrap_or(0));
        if let Some(hue) = self.hue {
            let [from, to] = *hue.get_ref();
            if from >= 360 || !(from + 1..from + 180).contains(&to) {
                let help = "write [from, to] in degrees, from 0 to 359 and to 1 to 179 more; 350 to 10 is [350, 370]";
                return Err(wrong(text, &hue.span(), &format!("{from} to {to} is not a range of hues"), help));
            }
            filter = filter.hue(from as i16, to as i16);
        }
        if let Some(saturation) = self.saturation {
            let [min, max] = ordered(text, &saturation)?;
            filter = filter.saturation(min, max);
        }
        if let Some(luma) = self.luma {
            let [min, max] = ordered(text, &luma)?;
            filter = filter.luma(min, max);
        }
        Ok(filter)
    }
}

fn ordered<T: Copy + Display + PartialOrd>(text: &str, range: &Spanned<[T; 2]>) -> Result<[T; 2], ParseError> {
    let [min, max] = *range.get_ref();
    if min > max {
        return Err(wrong(text, &range.span(), &format!("{min} is more than {max}"), "write [min, max]"));
    }
    Ok([min, max])
}

fn wrong(text: &str, at: &Range<usize>, what: &str, help: &str) -> ParseError {
    let line = text.get(..at.start).unwrap_or(text).matches('\n').count();
    let written = text.lines().nth(line).unwrap_or_default().trim();
    ParseError { what: format!("line {} `{written}`: {what}", line + 1), help: help.to_owned() }
}

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
        assert_eq!(wrong("hue = [10, 200]"), "line 3 `hue = [10, 200]`: 10 to 200 is not a range of hues");
        assert_eq!(wrong("hue = [400, 410]"), "line 3 `hue = [400, 410]`: 400 to 410 is not a range of hues");
        assert_eq!(wrong("\nluma = [9, 300]"), "line 4 `luma = [9, 300]`: invalid value: integer `300`, expected u8");
        assert_eq!(wrong("luma = [-1, 30]"), "line 3 `luma = [-1, 30]`: invalid value: integer `-1`, expected u8");
        assert_eq!(wrong("luma = [60, 30]"), "line 3 `luma = [60, 30]`: 60 is more than 30");
        assert_eq!(
            wrong("saturation = [10]"),
            "line 3 `saturation = [10]`: invalid length 1, expected an array of length 2"
        );
        assert_eq!(wrong("chroma = 1.5"), "line 3 `chroma = 1.5`: invalid type: floating point `1.5`, expected u8");
        assert!(wrong("colour = 3").starts_with("line 3 `colour = 3`: unknown field `colour`, expected one of `hue`"));
        assert!(wrong("[red]").starts_with("line 3 `[red]`: unknown field `red`, expected one of `orange`"));
        assert!(wrong("chroma = = 3").starts_with("line 3 `chroma = = 3`: "));
        assert!(parse(REST).expect_err("orange").what.ends_with(": missing field `orange`"));
    }
}
