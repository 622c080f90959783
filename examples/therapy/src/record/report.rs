//! HTML page about the records of a person.

use std::fmt::{Display, Write};
use std::fs;
use std::path::Path;
use std::time::{Duration, UNIX_EPOCH};

use bica_app::Failure;

use super::{Entry, Head, files};

/// Width of a bar with its gap, and height of 180°, both in pixels of the page.
const BAR: usize = 34;
const HEIGHT: f32 = 180.0;

const STYLE: &str = "body{font:18px sans-serif;max-width:60em;margin:2em auto;color:#14202e}svg{display:block}\
    rect{stroke-width:2}.correct{fill:#2c9a5f;stroke:#137a48}.incorrect{fill:#f4b232;stroke:#8a5200}\
    .cannot_tell{fill:none;stroke:#556;stroke-dasharray:4}line{stroke:#137a48;stroke-width:2;stroke-dasharray:6}";

/// Script that shows times in the local time of the reader.
const LOCAL: &str = "<script>for (const one of document.querySelectorAll('time')) \
    one.textContent = new Date(one.dateTime).toLocaleString(undefined, { dateStyle: 'medium', timeStyle: 'short' })</script>\n";

/// Returns an HTML page about all sessions of a code.
pub(crate) fn report(folder: &Path, code: &str) -> Result<String, Failure> {
    let mut page =
        format!("<!doctype html><meta charset=\"utf-8\"><title>{code}</title><style>{STYLE}</style><h1>{code}</h1>\n");
    for file in files(folder, code)? {
        let failed = |error: &dyn Display| Failure::of_path("read", &file, error, "delete the file, or mend it");
        let text = fs::read_to_string(&file).map_err(|error| failed(&error))?;
        let mut lines = text.lines();
        let head: Head = serde_json::from_str(lines.next().unwrap_or_default()).map_err(|error| failed(&error))?;
        let lines =
            lines.map(serde_json::from_str).collect::<Result<Vec<Entry>, _>>().map_err(|error| failed(&error))?;
        let title = head.session.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let date = humantime::format_rfc3339_seconds(UNIX_EPOCH + Duration::from_secs(head.begun)).to_string();
        let _ =
            writeln!(page, "<h2>{title}, <time datetime=\"{date}\">{} {} UTC</time></h2>", &date[..10], &date[11..16]);
        for exercise in lines.chunk_by(|a, b| a.line == b.line) {
            write_exercise(&mut page, exercise);
        }
    }
    page.push_str(LOCAL);
    page.push_str("<p>Angles of the arm and counts, by a program that is no medical device.</p>\n");
    Ok(page)
}

fn write_exercise(page: &mut String, lines: &[Entry]) {
    let count = |verdict: &str| lines.iter().filter(|line| line.verdict == verdict).count();
    let wrong = lines.iter().filter(|line| line.verdict == "incorrect");
    let mut reasons: Vec<&str> = wrong.flat_map(|line| &line.reasons).map(String::as_str).collect();
    reasons.sort_unstable();
    reasons.dedup();
    let reasons = if reasons.is_empty() { String::new() } else { format!(" ({})", reasons.join(", ")) };
    let (yes, no, unknown) = (count("correct"), count("incorrect"), count("cannot_tell"));
    let bar = |(index, line): (usize, &Entry)| {
        let (x, height) = (BAR * index + 6, line.peak.clamp(0.0, HEIGHT));
        let (y, Entry { verdict, peak, goal, .. }) = (HEIGHT - height, line);
        let rect = format!(r#"<rect class="{verdict}" x="{x}" y="{y:.0}" width="24" height="{height:.0}">"#);
        format!("{rect}<title>{peak:.0}°, goal {goal:.0}°</title></rect>")
    };
    let bars = lines.iter().enumerate().map(bar).collect::<Vec<_>>().concat();
    let (first, width) = (&lines[0], BAR * lines.len() + 10);
    let (line, y) = (first.line, HEIGHT - first.goal.clamp(0.0, HEIGHT));
    let _ = writeln!(
        page,
        r#"<h3>Line {line}</h3><p>{yes} correct, {no} not correct{reasons}, {unknown} not seen</p>
<svg width="{width}" height="{HEIGHT}" role="img" aria-label="highest angle of each repetition">{bars}
<line x1="0" x2="{width}" y1="{y:.0}" y2="{y:.0}"/></svg>"#
    );
}
