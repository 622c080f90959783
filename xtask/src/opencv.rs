//! Speed of BICA's vision and of `OpenCV`, on the same frames and the same core.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::install::{folder, python};
use crate::process::{output, run, works};

const PACKAGE: &str = "opencv-python-headless";
/// Number of turns of each side. They alternate, so that other load on the machine affects both.
const TURNS: usize = 3;
/// Required ratio of OpenCV's time to the vision's.
const MIN_RATIO: f64 = 10.0;

/// Installs `OpenCV` into a virtual environment, measures both sides in turn on one core, and prints a table of minima.
///
/// # Errors
/// If an installation or a measurement fails, or the ratio is below the required one.
pub(crate) fn compare() -> Result<(), String> {
    let folder = folder("opencv");
    let text = |path: PathBuf| path.to_string_lossy().into_owned();
    let (python, frames) = (python(&text(folder.join("venv")), "cv2", &[PACKAGE])?, text(folder.join("frames")));
    // The first build takes minutes, so its progress is shown.
    run("cargo", &["bench", "-p", "bica-benches", "--bench", "vision", "--", "export", &frames], &[])?;
    let vision = ["cargo", "bench", "--quiet", "-p", "bica-benches", "--bench", "vision", "--"];
    let mut table = Table::new();
    for _ in 0..TURNS {
        note(&mut table, 0, &on_one_core(&[&vision[..], &["everything"]].concat())?);
        let opencv = [python.as_str(), "benches/vision/opencv.py", &frames];
        note(&mut table, 2, &on_one_core(&opencv)?);
        note(&mut table, 4, &output(opencv[0], &[&opencv[1..], &["--threads"]].concat(), &[])?);
    }
    print(&table)
}

fn on_one_core(words: &[&str]) -> Result<String, String> {
    if works("taskset", &["-c", "0", "true"]) {
        return output("taskset", &[&["-c", "0"], words].concat(), &[]);
    }
    eprintln!("xtask: `taskset` is not installed, so the system chooses the core");
    output(words[0], &words[1..], &[])
}

/// Times by frame size and set of frames, µs: the whole vision, a copy of the frame, `OpenCV` without and with component
/// statistics on one thread, and both with `OpenCV`'s default number of threads.
type Table = BTreeMap<(u32, u32, String), [f64; 6]>;

/// Keeps the minimum of each figure. A line contains a set of frames with its frame size, and at least two figures.
fn note(table: &mut Table, column: usize, text: &str) {
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let Some(key) = key(words[0]).filter(|_| words.len() > 2) else { continue };
        let row = table.entry(key).or_insert([f64::INFINITY; 6]);
        for (ratio, word) in row[column..column + 2].iter_mut().zip(&words[1..]) {
            *ratio = ratio.min(word.parse().unwrap_or(f64::INFINITY));
        }
    }
}

/// Frame size and name of a set of frames, from `NAME-WIDTHxHEIGHT`.
fn key(word: &str) -> Option<(u32, u32, String)> {
    let (name, size) = word.rsplit_once('-')?;
    let (width, height) = size.split_once('x')?;
    Some((width.parse().ok()?, height.parse().ok()?, name.to_owned()))
}

fn print(table: &Table) -> Result<(), String> {
    println!(
        "\nTime per frame, µs, minimum of {TURNS} alternating turns. OpenCV: colour segmentation alone, with region statistics or labels only"
    );
    let heads = ["memcpy", "everything", "regions", "regions, threads", "labels", "labels, threads"];
    println!(
        "{:20}{:>12}{:>12}{:>20}{:>20}{:>20}{:>20}",
        "", heads[0], heads[1], heads[2], heads[3], heads[4], heads[5]
    );
    for ((width, height, name), [vision, floor, plain, stats, plain_threads, stats_threads]) in table {
        print!("{:20}{floor:12.1}{vision:12.1}", format!("{name} {width}×{height}"));
        for opencv in [stats, stats_threads, plain, plain_threads] {
            print!("{:>20}", format!("{opencv:.0} = {:.1} ×", opencv / vision));
        }
        println!();
    }
    // The vision computes area, bounding box and centroid of each region, so the statistics are needed for equal work.
    let ratio = table.values().map(|[vision, _, _, stats, ..]| stats / vision).fold(f64::INFINITY, f64::min);
    if ratio.is_finite() && ratio >= MIN_RATIO {
        println!(
            "OpenCV with statistics takes at ratio {ratio:.1} times as long as the vision; {MIN_RATIO} times is required"
        );
        return Ok(());
    }
    Err(format!(
        "OpenCV with statistics takes {ratio:.1} times as long as the vision; {MIN_RATIO} times or more is required"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minimum_of_each_figure_is_kept_for_each_set_and_size() {
        let mut table = Table::new();
        note(&mut table, 0, "nao2009-160x120 40.0 1.5 90.0\nrendered-160x120 30.0 1.6 80.0\nnot a line of a table\n");
        note(&mut table, 0, "nao2009-160x120 41.0 1.4 91.0\n");
        note(&mut table, 2, "nao2009-160x120 700.0 900.0\n");
        let infinity = f64::INFINITY;
        let nao = ((160, 120, "nao2009".to_owned()), [40.0, 1.4, 700.0, 900.0, infinity, infinity]);
        let rendered = ((160, 120, "rendered".to_owned()), [30.0, 1.6, infinity, infinity, infinity, infinity]);
        assert_eq!(table.into_iter().collect::<Vec<_>>(), [nao, rendered]);
    }

    #[test]
    fn ratio_of_each_row_counts() {
        let row = |vision: f64| [vision, 1.0, 700.0, 1000.0, 700.0, 1000.0];
        let table = |slow: f64| {
            let rows = [("nao2009", 50.0), ("rendered", slow)];
            rows.map(|(name, vision)| ((160, 120, name.to_owned()), row(vision))).into_iter().collect::<Table>()
        };
        assert_eq!(print(&table(100.0)), Ok(()));
        assert!(print(&table(101.0)).is_err() && print(&Table::new()).is_err());
    }
}
