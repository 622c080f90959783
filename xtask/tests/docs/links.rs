//! Links of a page.

use std::fs;
use std::path::Path;

use crate::pages::Page;

/// Returns the targets of the links and pictures of a Markdown text: `[text](target)`.
pub(crate) fn of(text: &str) -> impl Iterator<Item = &str> {
    text.split("](").skip(1).filter_map(|rest| rest.split_once(')').map(|(target, _)| target))
}

/// Returns a message for each relative link of a page without a target.
pub(crate) fn broken(page: &Page) -> Vec<String> {
    of(&page.text)
        .filter(|target| !target.contains("://"))
        .filter_map(|target| check(page, target).err().map(|error| format!("{}: {target}: {error}", page.name)))
        .collect()
}

fn check(page: &Page, target: &str) -> Result<(), String> {
    let (file, anchor) = target.split_once('#').map_or((target, None), |(file, anchor)| (file, Some(anchor)));
    let folder = page.path.parent().unwrap_or(Path::new("."));
    let path = if file.is_empty() { page.path.clone() } else { folder.join(file) };
    if !path.exists() {
        return Err("no such file".to_owned());
    }
    let Some(anchor) = anchor else { return Ok(()) };
    let text = fs::read_to_string(&path).map_err(|error| error.to_string())?;
    let found = text.lines().filter_map(|line| line.strip_prefix('#')).any(|heading| slug(heading) == anchor);
    if found { Ok(()) } else { Err("no such heading".to_owned()) }
}

/// Anchor of a heading on GitHub: lower case, spaces as hyphens, without punctuation.
fn slug(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn links_pictures_and_anchors_are_found() {
    let text = "See [a](x.md), ![b](y.png) and [c](z.md#the-part).";
    assert_eq!(of(text).collect::<Vec<_>>(), ["x.md", "y.png", "z.md#the-part"]);
    assert_eq!(slug("## `player play`: one game"), "player-play-one-game");
}
