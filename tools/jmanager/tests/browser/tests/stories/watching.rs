//! Watches: conditions that mark the timeline and pause a simulated world.

use jmanager_browser::Page;
use serde_json::json;

use crate::{game, tab};

/// Returns a script for the times at which a watch fired, and the spans in which its condition held, µs.
fn found(text: &str) -> String {
    format!(
        "return import('/lib/watches.js').then(({{ findings }}) => {{ const one = findings.value.get({text:?}); \
            return one?.fired.length ? [one.fired, one.spans] : null; }})"
    )
}

async fn watch(page: &Page, text: &str) {
    page.find("combobox", "Condition to watch", "").await.set(text).await;
    page.find("button", "Watch", "Watches").await.click().await;
}

#[tokio::test]
async fn watch_pauses_marks_and_is_kept() {
    let (_server, page) = game("watch").await;
    tab(&page, "Watches").await;
    page.reads("No watch yet").await;
    watch(&page, "Odometry.wanders > 1").await;
    page.reads("there is no output or parameter “Odometry.wanders”").await;
    page.click("switch", "Pause the world", "Watches").await;
    // The condition cannot hold before the watch exists: with 30 images per second it begins to hold 3 s later. It stays true while a
    // busy page pauses the world.
    page.click("button", "Pause", "").await;
    page.reads("world paused").await;
    let clock = "return document.querySelector('.clock b').textContent.split(':') \
        .reduce((sum, part) => 60 * sum + Number.parseFloat(part), 0)";
    let seconds = page.run(clock).await.as_f64().expect("a time");
    let text = &*format!("CameraInput.count > {:.0} for 500 ms", 30.0 * (seconds + 3.0));
    watch(&page, text).await;
    page.click("button", "Continue", "").await;
    page.reads("Watch fired at").await;
    page.reads("The world is paused; all panels show").await;
    let live = page.until("it fired once", &found(text)).await;
    assert_eq!(
        (live[0].as_array().map(Vec::len), &live[1][0][0]),
        (Some(1), &json!(live[0][0].as_u64().unwrap() - 500_000))
    );
    let paused =
        "return import('/lib/store.js').then(({ cursor, session }) => [cursor.value, session.value.info.value.paused])";
    assert_eq!(page.run(paused).await, json!([live[0][0], true]));
    page.click("button", "Go on", "").await;
    page.find("button", "Time: live", "").await;
    // The stored history has the same alerts, also after a reload.
    page.run("location.reload()").await;
    assert_eq!(page.until("it fired before", &found(text)).await[0], live[0]);
    tab(&page, "Recordings").await;
    page.find("textbox", "Name of the recording", "").await.set("watched").await;
    page.click("button", "Keep recording", "").await;
    page.click("button", "watched", "Recordings").await;
    page.find("button", "Play", "Replay").await;
    // A kept recording has ten values a second.
    let kept = page.until("it fired in the recording", &found(text)).await[0][0].clone();
    let later = kept.as_u64().unwrap() - live[0][0].as_u64().unwrap();
    assert!(later < 100_000, "{later} µs later in the recording");
    tab(&page, "Watches 1").await;
    page.click("button", "Next alert of", "").await;
    page.until(
        "its moment is shown",
        &format!("return import('/lib/store.js').then(({{ cursor }}) => cursor.value === {kept})"),
    )
    .await;
    page.reads("holds for 500 ms").await;
    page.click("button", &format!("Remove {text}"), "").await;
    page.reads("No watch yet").await;
    page.close().await;
}
