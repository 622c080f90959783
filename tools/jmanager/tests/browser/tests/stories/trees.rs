//! Story of an activation tree: names of its components, and its roles with their providers.

use jmanager_browser::Server;
use serde_json::json;

use crate::access::{AXE, TARGETS, load_axe};
use crate::designing::{open, small_crate};

const ROBOT: &str = "//! A robot.\n\nuse bica::prelude::*;\n\nuse crate::parts::{Ball, Legs};\n\n\
    /// What is followed.\n#[role]\npub trait Sight {\n    /// Whether it is there.\n    fn is_there(&self) -> bool;\n}\n\n\
    impl Sight for Ball {\n    fn is_there(&self) -> bool {\n        self.is_seen()\n    }\n}\n\n\
    activation_tree! {\n    pub struct Robot {\n        root: Follow,\n        cycle_hz: 50,\n        roles: { Sight: Ball },\n        \
    components: [Follow, Ball, left = Legs<0>, right = Legs<1>],\n    }\n}\n";

#[tokio::test]
async fn names_providers_and_roles_of_a_tree_are_changed() {
    let source = small_crate("tree");
    source.write("src/robot.rs", ROBOT);
    let server = Server::with_sources("tree", &source);
    let page = open(&server).await;
    // The file has no component.
    page.click("button", "Robot", "Sources").await;
    let file = source.path("src/robot.rs");
    page.fill("Name of Legs<0>", "front").await;
    page.saves(&file, &["[Follow, Ball, front = Legs<0>, right = Legs<1>]"]).await;
    page.find("combobox", "Provider of Sight", "").await.set("Legs<1>").await;
    page.saves(&file, &["roles: { Sight: Legs<1> }"]).await;
    page.fill("Name of the role Sight", "View").await;
    page.saves(&file, &["pub trait View {", "impl View for Ball {", "roles: { View: Legs<1> }"]).await;
    load_axe(&page).await;
    for theme in ["dark", "light"] {
        // Where a page begins is the browser's choice.
        let press = format!(
            "if (document.documentElement.dataset.theme !== '{theme}') \
            document.querySelector('[aria-label$=\"{theme} theme\"]').click()"
        );
        page.run(&press).await;
        page.is("html", &format!("one.dataset.theme === '{theme}'")).await;
        page.screenshot(&format!("tree-{theme}")).await;
        assert_eq!(page.run(TARGETS).await, json!([]), "{theme}");
        assert_eq!(page.run(&AXE.replace("run(document", "run('.inspector'")).await, json!([]), "{theme}");
    }
    page.click("button", "Remove right from the tree", "").await;
    page.reads("`Legs<1>` provides `View`: name another provider first").await;
    page.click("button", "Remove front from the tree", "").await;
    page.saves(&file, &["[Follow, Ball, right = Legs<1>]"]).await;
    // One history: the first bytes again.
    for _ in 0..4 {
        page.click("button", "Undo", "").await;
    }
    page.saves(&file, &[ROBOT]).await;
    page.close().await;
}
