//! Rules for prose: its width and its words.

use crate::pages::Page;

/// Longest line of prose, in characters.
const WIDTH: usize = 140;
/// Phrase that is no English: a result for tools is an output.
const BANNED: &str = "an information";

/// Returns each line of prose that is too long or contains a banned phrase; `is_prose` selects the lines to check.
pub(crate) fn faults(page: &Page, is_prose: impl Fn(&str) -> bool) -> Vec<String> {
    let mut is_code = false;
    let lines = page.text.lines().enumerate().filter(|(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        is_code ^= is_fence;
        !is_code && !is_fence && is_prose(line)
    });
    let faults = lines.flat_map(|(index, line)| {
        // Marks of figures are not shown.
        let shown = line.split("<!--").enumerate().map(|(place, part)| {
            if place == 0 { part } else { part.split_once("-->").map_or(part, |(_, shown)| shown) }
        });
        let width = shown.map(|part| part.chars().count()).sum::<usize>();
        let long = (width > WIDTH && !line.contains("://")).then(|| format!("{width} characters, at most {WIDTH}"));
        let banned = line.to_lowercase().contains(BANNED).then(|| format!("`{BANNED}`"));
        long.into_iter().chain(banned).map(move |fault| format!("{}:{}: {fault}", page.name, index + 1))
    });
    faults.collect()
}

#[test]
fn long_lines_and_banned_words_are_found() {
    let text =
        format!("An information.\n| {} |\n```\n{}\n```\n{}\n", "a".repeat(200), "b".repeat(200), "c".repeat(141));
    let page = Page { path: "x.md".into(), name: "x.md".into(), text };
    let found = faults(&page, |line| !line.starts_with('|'));
    assert_eq!(found, ["x.md:1: `an information`", "x.md:6: 141 characters, at most 140"]);
}
