//! Settings of the cameras.

use std::num::ParseIntError;
use std::str::FromStr;

/// Setting of a camera that it can also choose by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Setting {
    /// The camera chooses it.
    #[default]
    Auto,
    /// This value, in the unit of the device.
    Fixed(u16),
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let fixed = || text.parse().map(Self::Fixed);
        let why = |_: ParseIntError| "this is neither `auto` nor a whole number from 0 to 65535".to_owned();
        if text == "auto" { Ok(Self::Auto) } else { fixed().map_err(why) }
    }
}

/// Settings of both cameras.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// Time of exposure: V4L2 counts 100 µs.
    pub exposure: Setting,
    /// Gain, in steps of the device.
    pub gain: Setting,
    /// Temperature of the light for the white balance, K.
    pub white_balance: Setting,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_auto_or_numbers() {
        assert_eq!(["auto", "512"].map(str::parse), [Ok(Setting::Auto), Ok(Setting::Fixed(512))]);
        for text in ["", "-1", "1.5", "65536", "Auto"] {
            assert!(text.parse::<Setting>().is_err_and(|why| why.contains("65535")), "{text}");
        }
    }
}
