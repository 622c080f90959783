//! Numbers of the result of a run.

use std::fmt;

use bica::runner::{Robot, World};
use bica_wire::model::Invalid;
use serde::{Deserialize, Serialize};

/// Names that have another meaning in the result of a run, or in the table of a study.
const RESERVED: [&str; 16] = [
    "schema",
    "world",
    "seed",
    "result",
    "simulated_s",
    "cycles",
    "story",
    "report",
    "figures",
    "layers",
    "failed",
    "error",
    "tries",
    "wall_s",
    "host",
    "fingerprint",
];

/// A number of the result of a run, such as a distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// Name, with which an expression of a study has the value: letters, digits and `_`.
    pub name: String,
    /// Value; none if the world has no value, or one that is not finite.
    pub value: Option<f64>,
    /// Unit; empty for a number without one.
    pub unit: String,
}

impl Figure {
    /// Returns the figures of a world.
    ///
    /// # Errors
    /// If a name is no identifier, is used twice or means something else already.
    pub fn all<R: Robot>(world: &dyn World<R>) -> Result<Vec<Self>, Invalid> {
        let mut figures: Vec<Self> = Vec::new();
        world.figures(&mut |name, value, unit| {
            let value = Some(value).filter(|value| value.is_finite());
            figures.push(Self { name: name.to_owned(), value, unit: unit.to_owned() });
        });
        for (index, Self { name, .. }) in figures.iter().enumerate() {
            let is_name = name.chars().all(|sign| sign.is_alphanumeric() || sign == '_')
                && name.starts_with(|sign: char| !sign.is_numeric());
            let why = match () {
                () if !is_name => "is no name: letters, digits and `_` make one",
                () if RESERVED.contains(&&**name) => "is a field of the result already",
                () if figures[..index].iter().any(|before| before.name == *name) => "occurs twice",
                () => continue,
            };
            return Err(Invalid::new(
                format!("the figure `{name}` of the world {why}"),
                "rename it in `World::figures`",
            ));
        }
        Ok(figures)
    }

    /// Returns a result followed by figures, for people.
    #[must_use]
    pub fn with(result: &str, figures: &[Self]) -> String {
        let figures = figures.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let between = if result.is_empty() || figures.is_empty() { "" } else { "; " };
        format!("{result}{between}{figures}")
    }
}

/// Writes the name, and the value with four digits.
impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, unit } = self;
        let Some(value) = value else { return write!(f, "{name} without a value") };
        let space = if unit.is_empty() { "" } else { " " };
        // Rounded to four digits; the shortest text of that number.
        let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(*value);
        write!(f, "{name} {rounded}{space}{unit}")
    }
}
