//! Worlds of a program, by name.

use std::any::{Any, type_name};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use bica::runner::{Robot, World};
use bica_recording::SetUp;

use crate::console::Failure;

/// Remedy for a recording whose world cannot be created again.
pub(crate) const REPLAY_HELP: &str = "replay it with the program that recorded it";

/// Options of a world from the command line.
#[derive(Clone, Debug, Default)]
pub struct WorldOptions {
    /// Seed of all random values; the same seed creates the same world.
    pub seed: u64,
    /// Values of `--option NAME=VALUE` that the world has not read yet.
    values: RefCell<BTreeMap<String, String>>,
}

impl WorldOptions {
    /// Options with texts `NAME=VALUE`.
    ///
    /// # Errors
    /// If a text has another form, or sets a name again.
    pub fn new(seed: u64, options: &[String]) -> Result<Self, Failure> {
        let mut values = BTreeMap::new();
        for text in options {
            let (name, value) = text.split_once('=').ok_or_else(|| {
                Failure::new(format!("`{text}` is not an option of a world"), "write it as NAME=VALUE")
            })?;
            if values.insert(name.trim().to_owned(), value.trim().to_owned()).is_some() {
                return Err(Failure::new(format!("--option sets `{name}` twice"), "leave one of them out"));
            }
        }
        Ok(Self { seed, values: RefCell::new(values) })
    }

    /// Returns the options as a set-up for the header of a recording.
    pub(crate) fn set_up(&self, world: &str) -> SetUp {
        let options: Vec<_> = self.values.borrow().iter().map(|(name, value)| format!("{name}={value}")).collect();
        let set_up = [("world", world.into()), ("seed", self.seed.into()), ("options", options.into())];
        set_up.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
    }

    /// Returns the options of a recorded set-up.
    pub(crate) fn of_set_up(set_up: &SetUp) -> Result<Self, Failure> {
        let value = |name| set_up.get(name).cloned().unwrap_or_default();
        let invalid = |error| Failure::new(format!("the set-up in the recording is invalid: {error}"), REPLAY_HELP);
        let seed = serde_json::from_value(value("seed")).map_err(invalid)?;
        Self::new(seed, &serde_json::from_value::<Vec<String>>(value("options")).map_err(invalid)?)
    }

    /// Returns the value of `--option NAME=VALUE`, or `default` without one.
    ///
    /// # Errors
    /// If the text is not a value of this type, or a number that is not finite.
    pub fn value<T: FromStr<Err: fmt::Display> + 'static>(&self, name: &str, default: T) -> Result<T, Failure> {
        let Some(text) = self.values.borrow_mut().remove(name) else { return Ok(default) };
        let refused = |why: &str| {
            let what = format!("--option {name}={text}: {why}");
            Failure::new(what, format!("choose another value of `{name}`"))
        };
        let value: T = text.parse().map_err(|error: T::Err| match number::<T>() {
            Some(kind) => refused(&format!("this is not {kind}")),
            None => refused(&error.to_string()),
        })?;
        let of_any = &value as &dyn Any;
        let narrow = of_any.downcast_ref().is_none_or(|number: &f32| number.is_finite());
        let wide = of_any.downcast_ref().is_none_or(|number: &f64| number.is_finite());
        if narrow && wide { Ok(value) } else { Err(refused("the number is not finite")) }
    }

    /// Checks that the world named `world` has read all options.
    ///
    /// # Errors
    /// If there is a value that the world has not read.
    pub fn check_all_read(&self, world: &str) -> Result<(), Failure> {
        match self.values.borrow().keys().next() {
            None => Ok(()),
            Some(name) => {
                let what = format!("the world `{world}` has no option `{name}`");
                Err(Failure::new(what, "leave it out, or choose another --world"))
            }
        }
    }
}

/// Returns the description of a numeric type in messages; `None` for another type.
fn number<T>() -> Option<&'static str> {
    match type_name::<T>() {
        "f32" | "f64" => Some("a number"),
        "i8" | "i16" | "i32" | "i64" | "u8" | "u16" | "u32" | "u64" | "usize" => Some("a whole number in its range"),
        _ => None,
    }
}

/// Constructor of a robot, and the aim of its run.
pub(crate) struct Robots<R: Robot> {
    pub(crate) make: fn() -> Box<R>,
    pub(crate) is_done: Option<fn(&R) -> bool>,
}

impl<R: Robot> Clone for Robots<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Robot> Copy for Robots<R> {}

/// Function that creates a world.
type Open<R> = Box<dyn Fn(&WorldOptions) -> Result<Box<dyn World<R>>, Failure> + Send + Sync>;

/// Pace of a world: what determines when its next cycle begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// The program: as fast as possible, or by its clock.
    Program,
    /// A clock, as of a real robot: the world can neither run faster nor be paused.
    Clock,
    /// The world, which waits for its robot in each cycle: it cannot be paused either.
    World,
}

/// World of a program.
pub(crate) struct RegisteredWorld<R: Robot> {
    pub(crate) name: &'static str,
    pub(crate) pace: Pace,
    open: Open<R>,
}

impl<R: Robot> RegisteredWorld<R> {
    pub(crate) fn new<W: World<R> + 'static>(
        name: &'static str,
        pace: Pace,
        open: impl Fn(&WorldOptions) -> Result<W, Failure> + Send + Sync + 'static,
    ) -> Self {
        Self { name, pace, open: Box::new(move |options| Ok(Box::new(open(options)?))) }
    }

    pub(crate) fn open(&self, options: &WorldOptions) -> Result<Box<dyn World<R>>, Failure> {
        let world = (self.open)(options)?;
        options.check_all_read(self.name)?;
        Ok(world)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_finite_numbers() {
        let read =
            |text: &str| WorldOptions::new(0, &[format!("speed={text}")]).expect("an option").value("speed", 0.0_f32);
        assert_eq!(read("1.5").ok(), Some(1.5));
        for (text, why) in
            [("NaN", "not finite"), ("-inf", "not finite"), ("1e300", "not finite"), ("fast", "not a number")]
        {
            let Err(Failure::Error { what, .. }) = read(text) else { panic!("{text} is accepted") };
            assert!(what.contains(why), "{what}");
        }
    }
}
