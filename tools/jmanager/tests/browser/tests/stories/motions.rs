//! Stories of the motion editor: keyframes are created, changed and tried, and the source contains them.

use std::fs;

use jmanager_browser::{Folder, Page, Server, repository};

use crate::access::{AXE, TARGETS, load_axe, set_theme};
use crate::looks::FAULTS;

const WIDE: (u32, u32) = (1600, 1000);
const WAVE: &str = "//! Keys.\n\nuse bica_motion::joints::Joint;\nuse Joint::*;\n\n\
    /// Angles of some joints, degrees.\npub type Key = &'static [(Joint, f32)];\n\n\
    /// Waves with the right arm.\npub const WAVE: &[Key] = &[];\n";

/// Sources with motions, in their own folder.
pub(crate) struct Sources(Folder);

impl Sources {
    pub(crate) fn new(name: &str) -> Self {
        let folder = Folder::new(&format!("motions-{name}"));
        folder.write("wave.rs", WAVE);
        for file in ["getup.rs", "kick_dynamic.rs"] {
            let motion = fs::read(repository(&format!("bica-motion/src/model/nao/{file}")));
            folder.write(&format!("nao/{file}"), motion.expect("a motion of the repository"));
        }
        Self(folder)
    }

    fn read(&self, file: &str) -> String {
        self.0.read(file)
    }

    async fn has(&self, page: &Page, file: &str, part: &str) {
        page.saves(&self.0.path(file), &[part]).await;
    }

    async fn has_no(&self, page: &Page, file: &str, part: &str) {
        page.saves_what(&self.0.path(file), &format!("no `{part}`"), |text| !text.contains(part)).await;
    }

    pub(crate) async fn open(&self, name: &str) -> (Server, Page) {
        let server = Server::with_sources(name, &self.0);
        let page = Page::open(&server, WIDE).await;
        page.find("button", "FaceBall", "Activation tree").await;
        page.run("location.hash = '#layout=motions'").await;
        page.find("button", "WAVE", "").await;
        (server, page)
    }
}

#[tokio::test]
async fn wave_is_made_tried_mirrored_and_undone() {
    let sources = Sources::new("wave");
    let (_server, page) = sources.open("motions-wave").await;
    page.click("button", "WAVE", "").await;
    page.reads("This motion has no keyframe").await;
    page.click("button", "Insert", "").await;
    page.reads("Keyframe 1 of 1").await;
    page.find("slider", "RShoulderPitch", "").await.set("-60").await;
    sources.has(&page, "wave.rs", "&[&[(RShoulderPitch, -60.0)]]").await;
    page.find("slider", "RElbowRoll", "").await.set("80").await;
    page.click("button", "Insert", "").await;
    page.reads("Keyframe 2 of 2").await;
    page.find("slider", "RElbowRoll", "").await.set("20").await;
    let both = "[\n    &[(RShoulderPitch, -60.0), (RElbowRoll, 80.0)],\n    &[(RShoulderPitch, -60.0), (RElbowRoll, 20.0)],\n]";
    sources.has(&page, "wave.rs", both).await;
    page.reads("within the edge of the soles").await;
    page.reads("load at rest: RShoulderPitch").await;

    page.click("button", "Try", "").await;
    page.is(".trial .fine", "one.textContent === 'stands'").await;
    page.screenshot("motion-wave").await;

    page.click("button", "Mirror all", "").await;
    sources.has(&page, "wave.rs", "(LShoulderPitch, -60.0), (LElbowRoll, -20.0)").await;
    page.reads("of an earlier version").await;
    page.click("button", "Undo", "").await;
    sources.has(&page, "wave.rs", both).await;

    load_axe(&page).await;
    for theme in ["light", "dark"] {
        set_theme(&page, theme).await;
        for check in [AXE, TARGETS, FAULTS] {
            page.finds_none(check, theme).await;
        }
    }

    // The posture of the robot that plays in the world.
    page.click("button", "Take from the robot", "").await;
    sources.has_no(&page, "wave.rs", "(RElbowRoll, 20.0)").await;
    page.click("button", "Undo", "").await;
    sources.has(&page, "wave.rs", both).await;
    page.close().await;
}

/// Returns the position of a joint's handle in the window.
pub(crate) async fn handle(page: &Page, joint: &str) -> (f64, f64) {
    let script = format!(
        "const one = document.querySelector('.figure canvas'), {{ left, top }} = one.getBoundingClientRect(); \
        const found = JSON.parse(one.dataset.handles ?? '[]').find(({{ names }}) => names.includes('{joint}')); \
        const at = found && [left + found.at[0], top + found.at[1]], before = window.before; window.before = String(at); \
        return at && String(at) === before ? at : null"
    );
    let at = page.until(&format!("the handle of {joint} rests"), &script).await;
    (at[0].as_f64().expect("a number"), at[1].as_f64().expect("a number"))
}

#[tokio::test]
async fn drag_of_a_limb_turns_its_joint() {
    let sources = Sources::new("handles");
    let (_server, page) = sources.open("motions-handles").await;
    page.click("button", "WAVE", "").await;
    page.click("button", "Insert", "").await;
    page.find("slider", "RElbowRoll", "").await.set("60").await;
    sources.has(&page, "wave.rs", "&[(RElbowRoll, 60.0)]").await;
    let before = sources.read("wave.rs");

    // Seen from the right, the robot looks to the right. Dragged there, the elbow moves ahead by the pitch of the shoulder.
    page.click("button", "Right", "View of the posture").await;
    let (x, y) = handle(&page, "RShoulderPitch").await;
    page.hold((x, y), (x + 60.0, y - 10.0)).await;
    page.is("[aria-label=RShoulderPitch]", "one.value < 70").await;
    page.screenshot("motion-handle").await;
    page.press("\u{e00c}").await;
    page.is("[aria-label=RShoulderPitch]", "one.value > 80").await;
    page.release().await;
    page.drag((x, y), (x + 60.0, y - 10.0)).await;
    sources.has(&page, "wave.rs", "(RShoulderPitch, ").await;
    let changed = sources.read("wave.rs");
    let angle: f32 = changed
        .split("(RShoulderPitch, ")
        .nth(1)
        .and_then(|rest| rest.split(')').next()?.parse().ok())
        .expect("an angle");
    assert!((0.0..70.0).contains(&angle), "{angle}");
    assert_eq!(changed.matches("(R").count() - before.matches("(R").count(), 1, "one joint has changed: {changed}");
    page.click("button", "Undo", "").await;
    sources.has_no(&page, "wave.rs", "RShoulderPitch").await;
    assert_eq!(sources.read("wave.rs"), before);

    // Seen from behind, dragging the same handle aside changes the roll.
    page.click("button", "Behind", "View of the posture").await;
    let (x, y) = handle(&page, "RShoulderRoll").await;
    page.drag((x, y), (x + 40.0, y - 20.0)).await;
    sources.has(&page, "wave.rs", "(RShoulderRoll, ").await;
    page.close().await;
}

#[tokio::test]
async fn robot_gets_up_by_an_edited_motion() {
    let sources = Sources::new("session");
    let (_server, page) = sources.open("motions-session").await;
    page.click("button", "SIT_UP_FROM_FRONT", "").await;
    page.find("combobox", "World of the trial", "").await.set("session").await;
    // The world of a game that is over does not move.
    page.click("button", "Restart", "").await;
    page.click("button", "Try", "").await;
    page.is(".trial .fine", "one.textContent === 'stands'").await;
    page.screenshot("motion-session").await;
    // The joints move little to keyframe 12, so the measured angles are near those of the source.
    for _ in 0..11 {
        page.click("button", "Next keyframe", "").await;
    }
    let far = "const all = [...document.querySelectorAll('.channel')].flatMap((one) => { \
        const measured = one.querySelector('span.dim:last-child')?.textContent.match(/measured (-?\\d+)/); \
        return measured ? [Math.abs(measured[1] - one.querySelector('input[type=range]').value)] : []; }); \
        return all.length > 15 && all.filter((error) => error > 12).length < 3";
    page.until("the measured angles are near", far).await;
    // A paused world is reported, and the trial does not wait for it.
    page.click("button", "Try", "").await;
    page.find("button", "Cancel", "").await;
    page.press(",").await;
    page.reads("The world is paused").await;
    page.click("button", "Cancel", "").await;
    page.is(".trial .primary", "!one.disabled").await;
    let control = "return import('/lib/store.js').then(({ session }) => session.value.info.value.control)";
    assert_eq!(page.run(control).await, "yours");
    page.close().await;
}

#[tokio::test]
async fn motion_file_is_changed_beside_another_editor() {
    let sources = Sources::new("changed");
    let (_server, page) = sources.open("motions-changed").await;
    let before = sources.read("nao/kick_dynamic.rs");
    page.click("button", "FRONT", "").await;
    page.reads("Keyframe 1 of 7").await;
    for _ in 0..3 {
        page.click("button", "Next keyframe", "").await;
    }
    page.fill("foot x in m", "0.150").await;
    let changed = before.replacen("[0.135, 0.056, 0.022]", "[0.150, 0.056, 0.022]", 1);
    sources.has(&page, "nao/kick_dynamic.rs", "0.150, 0.056").await;
    assert_eq!(sources.read("nao/kick_dynamic.rs"), changed, "no other byte has changed");

    // Another editor changes the end of the motion at the same time.
    let outside = changed.replacen("new(0.35, [0.012, -0.042", "new(0.40, [0.012, -0.042", 1);
    sources.0.write("nao/kick_dynamic.rs", &outside);
    page.reads("was edited outside").await;
    page.fill("Scale of all durations in %", "200").await;
    sources.has(&page, "nao/kick_dynamic.rs", "new(0.80, [0.012, -0.042").await;

    page.click("button", "Delete", "").await;
    sources.has(&page, "nao/kick_dynamic.rs", "FRONT: [KickFrame; 6]").await;
    page.click("button", "Undo", "").await;
    page.click("button", "Undo", "").await;
    sources.has(&page, "nao/kick_dynamic.rs", "new(0.40, [0.012, -0.042").await;
    assert_eq!(sources.read("nao/kick_dynamic.rs"), outside);
    page.close().await;
}
