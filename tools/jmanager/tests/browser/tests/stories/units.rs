//! Values of the page's functions.

use serde_json::json;

use crate::game;

#[tokio::test]
async fn functions_of_the_page_return_their_values() {
    let (_server, page) = game("units").await;
    assert_eq!(page.run(include_str!("../units.js")).await, json!([]));
    page.close().await;
}
