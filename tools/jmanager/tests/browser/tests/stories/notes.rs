//! Notes on the drawing of a machine.

use jmanager_browser::{Folder, Page};

use crate::designing::focus;

/// Writes a note, drags it, changes and deletes it, and undoes that.
pub(crate) async fn write_note(page: &Page, source: &Folder) {
    focus(page, "State kick").await;
    page.press("w").await;
    page.find("textbox", "What the note says", "").await;
    page.press("Ask the coach.").await;
    page.control('\u{e007}').await;
    // The note is below the machine, which still has its automatic layout.
    page.saves(&source.path("src/keeper.vicode"), &["Keeper * - - \"Ask the coach.\"\n"]).await;
    let (x, y) = page.find("button", "Note: Ask the coach.", "").await.middle().await;
    page.drag((x, y), (x + 60.0, y - 20.0)).await;
    page.saves(&source.path("src/keeper.vicode"), &["Keeper kick "]).await;
    page.until("it has a place", "return import('/vicode/sources.js').then(({ notes }) => notes.value[0].at !== null)")
        .await;
    let (to_x, to_y) = page.find("button", "Note: Ask the coach.", "").await.middle().await;
    assert!(
        (to_x - x - 60.0).abs() < 3.0 && (to_y - y + 20.0).abs() < 3.0,
        "it moved by {} and {}",
        to_x - x,
        to_y - y
    );
    page.press("\u{e032}").await;
    page.find("textbox", "What the note says", "").await;
    page.press("\u{e010} Twice.").await;
    page.control('\u{e007}').await;
    page.find("button", "Note: Ask the coach. Twice.", "").await.focus().await;
    page.saves(&source.path("src/keeper.vicode"), &["Ask the coach. Twice."]).await;
    page.screenshot("designer-note").await;
    page.press("\u{e017}").await;
    page.lacks(".note").await;
    page.control('z').await;
    page.find("button", "Note: Ask the coach. Twice.", "").await;
    page.control('z').await;
    // `find` accepts the beginning of a name, so the whole text is checked in the file.
    page.saves(&source.path("src/keeper.vicode"), &["\"Ask the coach.\"\n"]).await;
}
