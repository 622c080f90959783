//! The players of a match in one view, live and recorded.

use std::net::TcpListener;

use jmanager_browser::{Folder, Page, Referee, Robot, Server, player};
use serde_json::json;

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
}

impl Match {
    /// Starts a match, each player at the next port.
    pub(crate) fn start(name: &str) -> Self {
        let is_free = |port: &u16| (0..4).all(|robot| TcpListener::bind(("127.0.0.1", port + robot)).is_ok());
        let port = (27_400..29_000).step_by(8).find(is_free).expect("four free ports");
        let play = ["--world", "team", "--size", "160x120", "--return-port", "48392", "--broadcast", "127.255.255.255"];
        let robots = Robot::start_at(&format!("127.0.0.1:{port}"), &[&play[..], &TEAMS].concat());
        let script = Folder::new(&format!("{name}-script"));
        script.write("match.txt", MATCH);
        let network = ["--to", "127.255.255.255", "--return-port", "48392", "--script", &script.argument("match.txt")];
        Self { _referee: Referee::start(&[&TEAMS[..], &network].concat()), robots, _script: script }
    }

    /// The addresses of all players, as an argument of the server.
    pub(crate) fn addresses(&self) -> String {
        let port: u16 = self.robots.address.rsplit_once(':').and_then(|(_, port)| port.parse().ok()).expect("a port");
        format!("tcp://{}..{}", self.robots.address, port + 3)
    }
}

/// Waits until the rows of the players have these names, and `rows`, the texts of their cells, fulfil a condition.
pub(crate) async fn players(page: &Page, condition: &str) {
    let script = format!(
        "const rows = [...document.querySelectorAll('.group tbody tr')]\
            .map((row) => [...row.cells].map((cell) => cell.textContent)); \
        return rows.map(([name]) => name).join() === '5-1,5-2,23-1,23-2' && rows.every((row) => row.length === 11) && {condition}"
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
    for size in [WIDE, SMALL, (1024, 768)] {
        show_in(&page, size).await;
        for theme in ["dark", "light"] {
            set_theme(&page, theme).await;
            page.run("return import('/lib/dock.js').then(({ preset }) => { preset('team'); })").await;
            tokio::time::sleep(std::time::Duration::from_secs(1)).await;
            page.screenshot(&format!("{theme}-{}-team", size.0)).await;
            assert_eq!(page.run(FAULTS).await, json!([]), "{theme} {size:?}");
        }
    }
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
    players(&page, "rows.every(([, , order]) => order === 'Initial')").await;
    page.close().await;
}
