//! Figures in the docs that a program computes: `<!--=KIND ARGUMENTS-->FIGURE<!--/-->` in Markdown.
//!
//! Figures of recordings, which contain times, may differ by 1 in their last digit.
//!
//! | kind | figure |
//! |---|---|
//! | `lines PATH…` | lines of files, or of all Rust files in folders |
//! | `values FILE` | values of a TOML file |
//! | `count FILE NAME [COLUMN]` | number in a line `NAME NUMBER NUMBER …` of a file |
//! | `million FILE NAME [COLUMN]` | the same in millions |
//! | `each SIZE IMAGES TOPICS` | kB of a recording for each cycle, without its images; SIZE as `160x120`, IMAGES and TOPICS as the options of `play` |
//! | `megabytes SIZE IMAGES TOPICS` | MB of a recording |
//! | `growth SIZE IMAGES TOPICS` | by which share topics make a recording larger, % |
//! | `ratio SIZE` | size of the images divided by that in a recording |

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::install::folder;
use crate::process::{output, root};

const OPEN: &str = "<!--=";
const CLOSE: &str = "<!--/-->";
/// Fewest figures of all pages; fewer mean that the pages are not read.
const LEAST: usize = 20;

/// Writes all figures into the pages, or compares them.
///
/// # Errors
/// If a figure cannot be computed, or `is_check` and a page has another one; all of them are named.
pub(crate) fn figures(is_check: bool) -> Result<(), String> {
    let (mut source, mut count, mut stale) = (Source::default(), 0, Vec::new());
    for file in output("git", &["ls-files", "*.md"], &[])?.lines() {
        let path = root().join(file);
        let text = fs::read_to_string(&path).map_err(|error| format!("{file}: {error}"))?;
        let new = replace(&text, |figure, old| {
            count += 1;
            let new = source.figure(figure)?;
            if new == old || is_measured(figure) && is_near(old, &new) {
                return Ok(old.to_owned());
            }
            stale.push(format!("{file}: `{figure}` is {new}, the page has {old}"));
            Ok(new)
        });
        let new = new.map_err(|error| format!("{file}: {error}"))?;
        if !is_check && new != text {
            fs::write(&path, new).map_err(|error| format!("{file}: {error}"))?;
        }
    }
    if count < LEAST {
        return Err(format!("only {count} figures were found: are the pages read?"));
    }
    eprintln!("xtask: {count} figures in the docs, {} of them changed", stale.len());
    if is_check && !stale.is_empty() {
        return Err(format!(
            "figures of the docs are not true:\n  {}\n  help: `cargo xtask figures` writes them",
            stale.join("\n  ")
        ));
    }
    for line in stale {
        eprintln!("{line}");
    }
    Ok(())
}

/// Whether a figure is one of a recording, which contains times.
fn is_measured(figure: &str) -> bool {
    ["each", "megabytes", "growth", "ratio"].iter().any(|kind| figure.split(' ').next() == Some(kind))
}

/// Whether two numbers with as many decimals differ by at most 1 in the last one.
fn is_near(old: &str, new: &str) -> bool {
    let decimals = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let without_point = |text: &str| text.replace('.', "").parse::<i64>().ok();
    let differ = |(old, new): (i64, i64)| old.abs_diff(new);
    decimals(old) == decimals(new) && without_point(old).zip(without_point(new)).map(differ).is_some_and(|by| by <= 1)
}

/// Replaces each figure of a page. `new` gets its kind with arguments, and the old figure.
fn replace(text: &str, mut new: impl FnMut(&str, &str) -> Result<String, String>) -> Result<String, String> {
    let (mut done, mut rest) = (String::new(), text);
    while let Some((before, mark)) = rest.split_once(OPEN) {
        let end = || format!("a figure without its end `{CLOSE}`: {OPEN}{}", mark.lines().next().unwrap_or_default());
        let (figure, after) = mark.split_once("-->").ok_or_else(end)?;
        let (old, after) = after.split_once(CLOSE).filter(|(old, _)| !old.contains(OPEN)).ok_or_else(end)?;
        let new = new(figure, old)?;
        done.extend([before, OPEN, figure, "-->", &new, CLOSE]);
        rest = after;
    }
    Ok(done + rest)
}

/// What figures are computed from.
#[derive(Default)]
struct Source {
    /// Recordings by the options of their game.
    recordings: BTreeMap<String, Recording>,
}

/// Sizes of a recording, bytes.
#[derive(Clone, Copy)]
struct Recording {
    file: f64,
    cycles: f64,
    images: f64,
    /// Number of images.
    taken: f64,
}

impl Source {
    fn figure(&mut self, figure: &str) -> Result<String, String> {
        let words: Vec<&str> = figure.split(' ').collect();
        match words[..] {
            ["lines", ref paths @ ..] if !paths.is_empty() => Ok(thousands(lines(paths)?)),
            ["values", file] => {
                let is_value = |line: &&str| line.contains(" = ") && !line.starts_with('#');
                Ok(read(file)?.lines().filter(is_value).count().to_string())
            }
            ["count", file, name, ref column @ ..] => Ok(thousands(number(file, name, column)?)),
            ["million", file, name, ref column @ ..] => {
                let millions = 1e-6 * number(file, name, column)? as f64;
                Ok(if millions < 1.0 { format!("{millions:.2}") } else { format!("{millions:.1}") })
            }
            ["each", size, images, topics] => {
                let Recording { file, images, cycles, .. } = self.recording(size, images, topics)?;
                Ok(format!("{:.2}", 1e-3 * (file - images) / cycles))
            }
            ["megabytes", size, images, topics] => {
                Ok(format!("{:.1}", 1e-6 * self.recording(size, images, topics)?.file))
            }
            ["growth", size, images, topics] => {
                let without = self.recording(size, images, "none")?.file;
                let growth = 100.0 * (self.recording(size, images, topics)?.file / without - 1.0);
                Ok(if growth < 10.0 { format!("{growth:.1}") } else { format!("{growth:.0}") })
            }
            ["ratio", size] => {
                let Recording { images, taken, .. } = self.recording(size, "all", "none")?;
                let pixels = size.split('x').map_while(|side| side.parse::<f64>().ok()).product::<f64>();
                Ok(format!("{:.1}", 2.0 * pixels * taken / images))
            }
            _ => Err(format!("`{figure}` is no figure: xtask/src/figures.rs lists the kinds")),
        }
    }

    /// Records the game with seed 1, once.
    fn recording(&mut self, size: &str, images: &str, topics: &str) -> Result<Recording, String> {
        let key = format!("{size} {images} {topics}");
        if let Some(found) = self.recordings.get(&key) {
            return Ok(*found);
        }
        let path = folder("figure.mcap");
        let file = path.to_str().ok_or("the path of the workspace is not UTF-8")?;
        let run = [&["run", "--quiet", "--release"], crate::build::release(), &["--"]].concat();
        let game = ["play", "--seed", "1", "--size", size, "--force", "--record", file, "--images", images];
        output("cargo", &[&run[..], &game, &["--topics", topics]].concat(), &[])?;
        let info = output("cargo", &[&run[..], &["record", "info", file]].concat(), &[])?;
        let recording = Recording {
            file: fs::metadata(&path).map_err(|error| format!("{file}: {error}"))?.len() as f64,
            cycles: column(&info, "length", 3).ok_or("`record info` prints no cycles")?,
            images: column(&info, "blobs", 2).unwrap_or_default(),
            taken: column(&info, "blobs", 1).unwrap_or_default(),
        };
        self.recordings.insert(key, recording);
        Ok(recording)
    }
}

/// A number in the line of a text that begins with a name; column 1 follows the name.
fn column(text: &str, name: &str, column: usize) -> Option<f64> {
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let line = text.lines().map(words).find(|words| words.first().is_some_and(|word| word == name))?;
    line.get(column)?.trim_end_matches(',').parse().ok()
}

fn number(file: &str, name: &str, at: &[&str]) -> Result<u64, String> {
    let at = at.first().map_or(Ok(1), |at| at.parse()).map_err(|_| format!("no column {at:?}"))?;
    let number = column(&read(file)?, name, at).ok_or_else(|| format!("{file} has no number {at} of `{name}`"))?;
    Ok(number as u64)
}

/// Lines of files, or of the Rust files in folders.
fn lines(paths: &[&str]) -> Result<u64, String> {
    let mut lines = 0;
    for path in paths {
        let files = if Path::new(path).extension().is_some() { (*path).to_owned() } else { format!("{path}/*.rs") };
        let files = output("git", &["ls-files", "--", &files], &[])?;
        if files.is_empty() {
            return Err(format!("the repository has no file {path}"));
        }
        lines += files.lines().map(|file| Ok(read(file)?.lines().count() as u64)).sum::<Result<u64, String>>()?;
    }
    Ok(lines)
}

fn read(file: &str) -> Result<String, String> {
    fs::read_to_string(root().join(file)).map_err(|error| format!("{file}: {error}"))
}

/// A number with a comma after each three digits.
fn thousands(number: u64) -> String {
    if number < 1000 { number.to_string() } else { format!("{},{:03}", thousands(number / 1000), number % 1000) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_between_marks_are_replaced() {
        let page = "It has <!--=lines a b-->7<!--/--> lines and <!--=values c--><!--/-->.\n";
        let new = replace(page, |figure, old| Ok(format!("{figure}:{old}")));
        assert_eq!(
            new.as_deref(),
            Ok("It has <!--=lines a b-->lines a b:7<!--/--> lines and <!--=values c-->values c:<!--/-->.\n")
        );
        assert!(replace("<!--=lines a-->7\n", |_, _| Ok(String::new())).is_err());
        assert!(replace("<!--=a-->7 <!--=b-->8<!--/-->", |_, _| Ok(String::new())).is_err());
    }

    #[test]
    fn figure_of_a_recording_may_differ_in_its_last_digit() {
        assert!(is_near("0.23", "0.22") && is_near("91", "90") && !is_near("0.23", "0.25") && !is_near("2.3", "23"));
        assert!(is_measured("growth 160x120 all none") && !is_measured("lines a"));
    }

    #[test]
    fn figures_are_computed_from_files() {
        let figure = |text| Source::default().figure(text);
        assert_eq!(figure("count benches/instructions.txt recovery_by_matrices.step"), Ok("232,098".to_owned()));
        assert_eq!(figure("lines rustfmt.toml"), Ok("2".to_owned()));
        assert!(figure("count benches/instructions.txt none").is_err_and(|error| error.contains("`none`")));
        assert!(figure("lines no/such").is_err() && figure("length README.md").is_err());
    }
}
