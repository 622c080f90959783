//! Pictures of the page in three widths and both themes, and what must hold in each.

use jmanager_browser::{Page, Server};
use serde_json::json;

/// Nothing is wider than the window, no text of a button is cut, and all controls have a name and contain no other control.
const FAULTS: &str = r"
const faults = [];
if (document.documentElement.scrollWidth > innerWidth) faults.push(`the page is ${document.documentElement.scrollWidth} px wide`);
for (const one of document.querySelectorAll('button, input, select, summary, canvas, [role=button], [role=tab]')) {
  if (one.getClientRects().length === 0 || one.closest('.chart') || one.closest('.dv-dockview [class*=dropdown]')) continue;
  const name = one.ariaLabel || one.textContent.trim() || one.labels?.[0]?.textContent.trim() || one.placeholder || one.title;
  if (!name && !one.className.baseVal) faults.push(`no name: ${one.outerHTML.slice(0, 120)}`);
  const around = one.parentElement.closest('button, summary, [role=button], [role=tab]');
  if (around) faults.push(`inside another control: ${around.outerHTML.slice(0, 120)}`);
  if (one.tagName === 'BUTTON' && one.scrollWidth > one.clientWidth + 2 && getComputedStyle(one).overflow === 'visible') faults.push(`cut: ${one.textContent}`);
}
return faults;
";

#[tokio::test]
async fn the_page_looks_right_in_three_widths_and_both_themes() {
    let server = Server::start("looks", &[]);
    let mut page: Option<Page> = None;
    for (width, height) in [(1600, 940), (1100, 800), (700, 900)] {
        // Each URL works once; the browser is the same for a size.
        let shown = match page.take() {
            None => Page::open(&server, (width, height)).await,
            Some(shown) => {
                shown.resize((width, height)).await;
                shown
            }
        };
        shown.find("button", "View", "").await;
        for theme in ["dark", "light"] {
            shown.run("localStorage.removeItem('jmanager-layout'); localStorage.setItem('jmanager-theme', JSON.stringify(arguments[0])); location.hash = ''; location.reload()", vec![json!(theme)]).await;
            shown
                .until(
                    "the page is loaded",
                    "return document.readyState === 'complete' && document.querySelectorAll('.component').length > 5",
                )
                .await;
            shown
                .until("the theme is set", &format!("return document.documentElement.dataset.theme === '{theme}'"))
                .await;
            for (key, name) in [
                ("1", "overview"),
                ("2", "behaviour"),
                ("3", "colours"),
                ("4", "driving"),
                ("5", "replay"),
                ("6", "designer"),
            ] {
                shown.press(key).await;
                shown.until("panels are shown", "return document.querySelectorAll('.panel').length > 1").await;
                tokio::time::sleep(std::time::Duration::from_millis(300)).await;
                shown.screenshot(&format!("{theme}-{width}-{name}")).await;
                let faults = shown.run(FAULTS, vec![]).await;
                assert_eq!(faults, json!([]), "{theme} {width} {name}");
            }
        }
        page = Some(shown);
    }
    page.expect("a page").close().await;
}
