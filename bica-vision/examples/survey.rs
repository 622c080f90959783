//! How well everything is seen: random poses in the built-in world, whose referee knows the truth.
//!
//! `cargo run --release -p bica-vision --example survey -- [--poses 2000] [--first 0] [--amiss crossings]` prints a table;
//! with `--amiss` also the numbers of the poses from which something of that name was missed or wrong. `--first 7 --picture
//! FILE.png` writes the image of one pose instead, with all that is seen in it.

#[path = "../tests/support/picture.rs"]
mod picture;
#[path = "../tests/support/survey/mod.rs"]
mod survey;

use std::io;
use std::path::Path;

use survey::{Look, Survey};

fn main() -> io::Result<()> {
    let words: Vec<String> = std::env::args().collect();
    let word = |name: &str| words.get(words.iter().position(|word| word == name)? + 1);
    let number = |name: &str, default: u64| word(name).and_then(|word| word.parse().ok()).unwrap_or(default);
    if let Some(file) = word("--picture") {
        let look = Look::new(number("--first", 0)).expect("a number that the table counts");
        return picture::write(Path::new(file), &look);
    }
    let survey = Survey::of(number("--first", 0), number("--poses", 2000) as usize);
    print!("{survey}");
    for score in survey.scores() {
        if word("--amiss").is_some_and(|word| score.name.contains(word.as_str())) {
            println!("missed {:?}\nwrong {:?}", score.missed, score.wrong);
        }
    }
    Ok(())
}
