//! Colour profiles: thresholds of each class in a TOML file.

mod parse;
mod write;

use std::fs;
use std::path::Path;

use bica_app::Failure;
use bica_vision::colour::Filters;
use bica_vision::profile::{BUILT_IN, DARWIN_2013, NAO_2009};

pub use write::{Notes, write};

/// Names of the classes, in the order of decision.
pub const CLASSES: [&str; 5] = ["orange", "yellow", "blue", "green", "white"];

/// Built-in profiles by name.
const NAMED: [(&str, Filters); 3] = [("built-in", BUILT_IN), ("nao2009", NAO_2009), ("darwin2013", DARWIN_2013)];

/// Loads a built-in profile by its name, or a profile from a file.
///
/// # Errors
/// If there is no such file or profile, or the file is malformed.
pub fn load(name: &str) -> Result<Filters, Failure> {
    let known = NAMED.iter().find(|(known, _)| *known == name);
    if let Some((_, filters)) = known {
        return Ok(*filters);
    }
    let path = Path::new(name);
    let help = "name a TOML file, or one of built-in, nao2009 and darwin2013";
    let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read the profile", path, &error, help))?;
    parse::parse(&text).map_err(|wrong| Failure::new(format!("`{name}`, {}", wrong.what), wrong.help))
}

#[cfg(test)]
mod tests {
    use bica_vision::colour::Filter;

    use super::*;

    #[test]
    fn written_profile_is_parsed_back_unchanged() {
        for (name, filters) in NAMED {
            let text = write(&filters, &Notes::default());
            let back = parse::parse(&text).unwrap_or_else(|wrong| panic!("{name}: {}", wrong.what));
            assert_eq!(back, filters, "{name}");
            assert_eq!(write(&back, &Notes::default()), text, "{name}");
        }
    }

    #[test]
    fn files_of_profiles_equal_built_in_ones() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../profiles/");
        for (name, filters) in NAMED {
            let file = load(&format!("{folder}{name}.toml")).expect(name);
            assert_eq!(file, filters, "{name}");
        }
    }

    #[test]
    fn every_threshold_is_written_and_parsed() {
        for from in (0..360).step_by(7) {
            let wide = 1 + from % 179;
            let filter = Filter::ANY.hue(from, from + wide).saturation(from as u16, 1000).luma(3, 250).chroma(181);
            let filters = Filters { orange: filter, yellow: Filter::ANY, white: filter.chroma(0), ..BUILT_IN };
            let back = parse::parse(&write(&filters, &Notes::default())).map_err(|wrong| wrong.what);
            assert_eq!(back, Ok(filters), "hue {from} to {}", from + wide);
        }
    }
}
