//! The players of a match in one view, live and recorded, and its referee's page.

use std::net::TcpListener;

use jmanager_browser::{Folder, Page, Referee, Robot, Server, player};

use crate::access::set_theme;
use crate::glance::{SMALL, show_in};
use crate::looks::FAULTS;
use crate::{WIDE, map_has};

/// A match of two teams, two players each, as commands of the referee.
const MATCH: &str = "ready 5\nwait 8\nset\nwait 1\nplaying\nwait 4\npenalty 23 2 pushing\nwait 600\n";
const TEAMS: [&str; 6] = ["--teams", "5,23", "--players", "2", "--control-port", "48391"];

/// A running match with its referee.
pub(crate) struct Match {
    _referee: Referee,
    robots: Robot,
    _script: Folder,
    /// Port of the first player.
    port: u16,
}

impl Match {
    /// Starts a match, each player at the next port.
    pub(crate) fn start(name: &str) -> Self {
        let is_free = |port: &u16| (0..5).all(|robot| TcpListener::bind(("127.0.0.1", port + robot)).is_ok());
        let port = (27_400..29_000).step_by(8).find(is_free).expect("five free ports");
        let play = ["--world", "team", "--size", "160x120", "--return-port", "48392", "--broadcast", "127.255.255.255"];
        let robots = Robot::start_at(&format!("127.0.0.1:{port}"), &[&play[..], &TEAMS].concat());
        let script = Folder::new(&format!("{name}-script"));
        script.write("match.txt", MATCH);
        let network = ["--to", "127.255.255.255", "--return-port", "48392", "--script", &script.argument("match.txt")];
        let serve = ["--serve", &format!("127.0.0.1:{}", port + 4)];
        Self { _referee: Referee::start(&[&TEAMS[..], &network, &serve].concat()), robots, _script: script, port }
    }

    /// The addresses of all players, as an argument of the server.
    pub(crate) fn addresses(&self) -> String {
        format!("tcp://{}..{}", self.robots.address, self.port + 3)
    }

    /// The address of the referee.
    fn referee(&self) -> String {
        format!("tcp://127.0.0.1:{}", self.port + 4)
    }
}

/// Waits until the rows of the players have these names, and `rows`, the texts of their cells, fulfil a condition.
pub(crate) async fn players(page: &Page, condition: &str) {
    rows(page, "5-1,5-2,23-1,23-2", condition).await;
}

/// Looks at a layout in all sizes and both themes.
async fn looks(page: &Page, layout: &str, panel: &str) {
    for size in [WIDE, SMALL, (1024, 768), (800, 600), (390, 844)] {
        show_in(page, size).await;
        for theme in ["dark", "light"] {
            set_theme(page, theme).await;
            let preset = format!("return import('/lib/dock.js').then(({{ preset }}) => {{ preset('{layout}'); }})");
            page.run(&preset).await;
            page.find("tab", panel, "").await;
            page.rests().await;
            page.screenshot(&format!("{theme}-{}-{layout}", size.0)).await;
            page.finds_none(FAULTS, &format!("{theme} {size:?}")).await;
        }
    }
}

async fn rows(page: &Page, names: &str, condition: &str) {
    let script = format!(
        "const rows = [...document.querySelectorAll('.group tbody tr')]\
            .map((row) => [...row.cells].map((cell) => cell.textContent)); \
        return rows.map(([name]) => name).join() === '{names}' && rows.every((row) => row.length === 11) && {condition}"
    );
    page.until(condition, &script).await;
}

#[tokio::test]
async fn players_of_a_match_are_in_one_view() {
    let game = Match::start("team");
    let server = Server::start("team", &[&game.addresses()]);
    let page = Page::open(&server, WIDE).await;
    players(&page, "rows.every(([, state]) => state !== '–')").await;
    for colour in ["--curve0", "--curve6"] {
        map_has(&page, colour, 15, 60).await;
    }
    players(&page, "rows[3][3] === 'Pushing' && rows[3][5] === 'Absent' && rows[0][3] === 'None'").await;
    players(&page, "rows.some((row) => row[5] === 'Striker') && rows[0][4] > 0").await;
    // Both teams are in one frame: the second one attacks the other goal.
    for (player, side) in [("5-2", -1), ("23-2", 1)] {
        page.click("button", player, "Players").await;
        page.is(
            ".place",
            &format!("Math.sign(one.textContent.match(/robot in pitch · (-?[\\d.]+),/)?.[1]) === {}", side),
        )
        .await;
    }
    players(&page, "document.querySelector('.group .chosen').textContent.startsWith('23-2')").await;
    // Each player has the same name wherever a session is named; the address is in the tooltip only.
    page.reads("stops 23-2").await;
    page.click("button", "Sessions", "").await;
    let named = "return [...document.querySelectorAll('.session .one')].map((one) => one.textContent).join()";
    assert_eq!(page.run(named).await, "5-1,5-2,23-1,23-2");
    assert_eq!(page.run("return document.title").await, "23-2 · JManager");
    page.press("\u{e00c}").await;
    looks(&page, "team", "Players").await;
    page.close().await;
}

#[tokio::test]
async fn recordings_of_a_match_are_in_one_view() {
    let folder = Folder::new("team-recordings");
    let play = ["play", "--world", "team", "--size", "160x120", "--return-port", "48394", "--seconds", "4", "--record"];
    player(&[&play[..], &[&folder.argument("")], &TEAMS[..4], &["--control-port", "48393"]].concat());
    let files = ["5-1", "5-2", "23-1", "23-2"].map(|name| folder.argument(&format!("{name}.mcap")));
    let server = Server::start("team-recorded", &files.each_ref().map(|file| file.as_str()));
    let page = Page::open(&server, WIDE).await;
    page.counts(".group tbody tr", "=== 4").await;
    page.press("\u{e010}").await;
    rows(&page, "5-1.mcap,5-2.mcap,23-1.mcap,23-2.mcap", "rows.every(([, , order]) => order === 'Initial')").await;
    page.close().await;
}

#[tokio::test]
async fn referees_page_shows_and_commands_the_match() {
    let game = Match::start("referee");
    let server = Server::start("referee", &[&game.referee()]);
    let page = Page::open(&server, SMALL).await;
    page.is(".referee h2", "one.textContent.endsWith('team 5 0 : 0 team 23')").await;
    page.is(".referee h2", "/^Playing 9:\\d\\d /.test(one.textContent)").await;
    let penalties = ".referee [aria-label=Penalties]";
    page.is(penalties, "one.textContent.startsWith('23-2 pushing, ')").await;
    page.find("textbox", "player", "Referee").await.set("2").await;
    page.find("combobox", "penalty", "Referee").await.set("BallHolding").await;
    page.click("button", "penalty", "Referee").await;
    page.is(penalties, "one.firstChild.textContent.startsWith('5-2 ball-holding, ')").await;
    page.click("button", "STOP", "").await;
    page.is(".referee h2", "one.textContent.startsWith('Playing, stopped')").await;
    page.reads("referee 5:23").await;
    looks(&page, "referee", "Referee").await;
    // A layout of another tree, which the last visit left, does not hide the match.
    page.run(
        "const key = 'jmanager-layout'; const last = JSON.parse(localStorage[key]); location.hash = ''; \
        addEventListener('pagehide', () => { localStorage[key] = JSON.stringify({ ...last, tree: 'Forward' }); }); \
        import('/lib/dock.js').then(({ preset }) => { preset('overview'); location.reload(); })",
    )
    .await;
    page.shows(".referee h2").await;
    page.close().await;
}
