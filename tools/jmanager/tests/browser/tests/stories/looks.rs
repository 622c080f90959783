//! Pictures of the page in four sizes and both themes, and what must hold in each.

use jmanager_browser::{Page, Server, repository};
use serde_json::json;

use crate::access::set_theme;
use crate::glance::{SMALL, show_in};
use crate::{GOES_ON, open_in, put_beside};

/// Lists faults: the page is wider than the window, a text has less than 11 px, the text of a button is cut, or a control has no name or
/// contains another control.
pub(crate) const FAULTS: &str = r"
const faults = [];
if (document.documentElement.scrollWidth > innerWidth) faults.push(`the page is ${document.documentElement.scrollWidth} px wide`);
for (const one of document.querySelectorAll('button, input, select, summary, canvas, [role=button], [role=tab]')) {
  if (one.getClientRects().length === 0 || one.closest('.chart') || one.closest('.dv-dockview [class*=dropdown]')) continue;
  const name = one.ariaLabel || one.textContent.trim() || one.labels?.[0]?.textContent.trim() || one.placeholder || one.title;
  if (!name && !one.className.baseVal) faults.push(`no name: ${one.outerHTML.slice(0, 120)}`);
  const around = one.parentElement.closest('button, summary, [role=button], [role=tab]');
  if (around) faults.push(`inside another control: ${around.outerHTML.slice(0, 120)}`);
  const isCut = one.tagName === 'BUTTON' && one.scrollWidth > one.clientWidth + 2 && getComputedStyle(one).overflow === 'visible';
  if (isCut) faults.push(`cut: ${one.textContent}`);
}
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT, ({ data, parentElement: one }) =>
  data.trim() && !one.closest('style, script, option') && one.checkVisibility({ visibilityProperty: true }) ? 1 : 2);
while (texts.nextNode()) {
  const one = texts.currentNode.parentElement;
  const { a = 1, b = 0 } = one.getScreenCTM?.() ?? {};
  const size = Number.parseFloat(getComputedStyle(one).fontSize) * Math.hypot(a, b);
  if (size < 10.95) faults.push(`${size.toFixed(1)} px: ${texts.currentNode.data} in ${one.closest('[aria-label]')?.ariaLabel}`);
}
return faults;
";

#[tokio::test]
async fn the_page_looks_right_in_four_sizes_and_both_themes() {
    let server = Server::start("looks", &[]);
    let mut page: Option<Page> = None;
    for (width, height) in [(1600, 1000), SMALL, (1024, 768), (390, 844)] {
        // Each URL works once, so one browser is resized for all sizes.
        let shown = match page.take() {
            None => Page::open(&server, (width, height)).await,
            Some(shown) => {
                shown.resize((width, height)).await;
                shown
            }
        };
        for theme in ["dark", "light"] {
            let reload = "localStorage.removeItem('jmanager-layout'); \
                localStorage.setItem('jmanager-theme', JSON.stringify(arguments[0])); location.hash = ''; location.reload()";
            shown.run_with(reload, vec![json!(theme)]).await;
            shown.counts(".component", "> 5").await;
            shown.shows(&format!("html[data-theme={theme}]")).await;
            for (key, name) in (1..).zip(["overview", "behaviour", "colours", "driving", "replay", "designer"]) {
                shown.press(&key.to_string()).await;
                shown.counts(".panel", "> 1").await;
                shown.rests().await;
                shown.screenshot(&format!("{theme}-{width}-{name}")).await;
                shown.finds_none(FAULTS, &format!("{theme} {width} {name}")).await;
            }
        }
        page = Some(shown);
    }
    page.expect("a page").close().await;
}

/// Opens a machine and a motion, which layouts show.
const OPEN_SOURCES: &str = "return Promise.all([import('/vicode/sources.js'), import('/motion/model.js')])\
    .then(async ([{ readList, list, open }, { readMotions, motions, openMotion }]) => { \
    await readList(); const file = list.value.find(({ components }) => components.some(({ machine }) => machine)); \
    await open(file.file, file.components.find(({ machine }) => machine).key); \
    await readMotions(); const { file: of, key } = motions.value[0]; if (arguments[0]) await openMotion(of, key); })";

/// Writes pictures of all panels, for review.
#[tokio::test]
#[ignore = "writes pictures of all panels"]
async fn each_panel_looks_right() {
    let server = Server::start("panels", &["--source", &repository("examples/therapy")]);
    let page = open_in(&server, SMALL).await;
    page.run(GOES_ON).await;
    let names = "return import('/lib/panels.js').then(({ PANELS }) => Object.keys(PANELS))";
    let names: Vec<String> = serde_json::from_value(page.run(names).await).expect("names");
    for size in [SMALL, (1600, 1000)] {
        show_in(&page, size).await;
        for theme in ["dark", "light"] {
            set_theme(&page, theme).await;
            for (at, name) in names.iter().enumerate() {
                let layout = match &**name {
                    "vicode" | "code" | "inspector" | "sources" => "designer",
                    "motion" => "motions",
                    _ => "overview",
                };
                if at == 0 || layout != "overview" {
                    page.run_with(OPEN_SOURCES, vec![json!(layout == "motions")]).await;
                }
                let open = "return import('/lib/dock.js').then(({ preset, open }) => { preset(arguments[1]); open(arguments[0], {}); })";
                page.run_with(open, vec![json!(name), json!(layout)]).await;
                page.rests().await;
                page.screenshot(&format!("panel-{name}-{}-{theme}", size.0)).await;
                page.finds_none(FAULTS, &format!("{name} {size:?} {theme}")).await;
            }
        }
    }
    page.close().await;
}

/// Writes pictures of the first layout of other programs, of two sessions and of a recording, for review.
#[tokio::test]
#[ignore = "writes pictures of other programs"]
async fn other_programs_look_right() {
    let pair = Server::start("pair", &[]);
    pair.record("one", &["--seconds", "6", "--size", "160x120", "--seed", "1"]);
    for (name, server) in [
        ("follower", Server::start_example("wall_follower")),
        ("keeper", Server::start_other("goalkeeper", &["monitor"])),
        ("pair", pair),
    ] {
        let page = Page::open(&server, SMALL).await;
        page.counts(".component", "> 2").await;
        if name == "pair" {
            put_beside(&page).await;
        }
        tokio::time::sleep(std::time::Duration::from_secs(4)).await;
        in_both(&page, name).await;
        if name == "pair" {
            page.click("tab", "Recordings", "").await;
            page.click("button", "one", "Recordings").await;
            page.press("5").await;
            in_both(&page, "recording").await;
        }
        page.close().await;
    }
}

/// Takes pictures in both sizes and themes.
async fn in_both(page: &Page, name: &str) {
    for size in [SMALL, (1600, 1000)] {
        show_in(page, size).await;
        for theme in ["dark", "light"] {
            set_theme(page, theme).await;
            page.rests().await;
            page.screenshot(&format!("other-{name}-{}-{theme}", size.0)).await;
            page.finds_none(FAULTS, &format!("{name} {size:?} {theme}")).await;
        }
    }
}
