//! The page for people with a keyboard, a screen reader or an unsteady hand.

use jmanager_browser::{Page, Server, repository, target};

use crate::glance::SMALL;
use crate::{open_in, put_beside, tab};

/// Visible buttons and fields with a side below 24 px.
pub(crate) const TARGETS: &str = r"
const small = (one) => { const { width, height } = one.getBoundingClientRect(); return Math.min(width, height) < 23.5; };
const controls = [...document.querySelectorAll('button, select, input:not([type=range]), summary, [role=button], '
  + '[role=tab]')]
  .filter((one) => one.checkVisibility({ visibilityProperty: true })
    && !one.closest('.chart'));
const name = (one) => one.ariaLabel || one.textContent || one.outerHTML.slice(0, 80);
const size = ({ width, height }) => `${Math.round(width)}×${Math.round(height)}`;
return controls.filter(small).map((one) => `${name(one)} ${size(one.getBoundingClientRect())}`);
";

/// Findings of axe of the levels critical and serious.
pub(crate) const AXE: &str = r"
return axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => violations
  .filter(({ impact }) => impact === 'critical' || impact === 'serious')
  .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 4).map(({ target, any }) => `${target} ${any[0]?.message ?? ''}`).join('; ')}`));
";

/// Loads axe into the page.
pub(crate) async fn load_axe(page: &Page) {
    let file = target().join("axe/node_modules/axe-core/axe.min.js");
    let axe = std::fs::read_to_string(&file)
        .unwrap_or_else(|error| panic!("{}: {error}; `cargo xtask browser` installs it", file.display()));
    page.run(&format!("{axe}; window.axe = axe;")).await;
}

/// Sets a theme.
pub(crate) async fn set_theme(page: &Page, theme: &str) {
    if page.run("return document.documentElement.dataset.theme").await != theme {
        page.press("t").await;
    }
}

#[tokio::test]
async fn no_layout_has_a_serious_finding_of_axe() {
    let server = Server::start("access", &["--source", &repository("player")]);
    let page = open_in(&server, SMALL).await;
    load_axe(&page).await;
    for theme in ["dark", "light"] {
        set_theme(&page, theme).await;
        for key in ["1", "2", "3", "4", "5", "6", "7"] {
            page.press(key).await;
            page.counts(".panel", "> 1").await;
            page.rests().await;
            for check in [TARGETS, AXE] {
                page.finds_none(check, &format!("layout {key}, {theme}")).await;
            }
        }
    }
    // Panels that are in no layout: a table, the map in 3D, and two sessions.
    page.press("1").await;
    let table = "import('/lib/dock.js').then(({ open }) => open('table', { rows: ['Odometry.walked', 'Head.pan'] }))";
    page.run(table).await;
    put_beside(&page).await;
    tab(&page, "Map").await;
    page.click("switch", "3D", "Map").await;
    page.counts("[aria-label=Values] thead th", "=== 7").await;
    for check in [TARGETS, AXE] {
        page.finds_none(check, "panels that are in no layout").await;
    }
    // Escape closes a menu even if it is a key of the focused panel.
    page.click("button", "What can be done here", "Map").await;
    page.run("document.querySelector('.component').focus()").await;
    page.press("\u{e00c}").await;
    page.lacks(".menu:popover-open").await;
    page.close().await;
}
