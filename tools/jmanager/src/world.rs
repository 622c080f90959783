//! The worlds in which the forward plays.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use bica_app::Failure;
use bica_player_program::game::{
    FirmwareImage, GRAPH, GameControl, NextStep, RecordOptions, Rules, ServeOptions, WorldKind, play_controlled,
    settings,
};
use bica_recording::{ImagePolicy, Topics};
use bica_sim::setup::{Frame, MAX_ROBOTS};
use bica_tuning::Layers;

use super::SoccerOptions;
use bica_monitor::program::{Game, LocalWorld, WorldOption, WorldRun, WorldSetup};
use bica_wire::model::Invalid;

/// Option of the worlds: the number of other robots.
pub const ROBOTS: &str = "robots";

/// A world in which the forward plays.
pub(super) struct SoccerWorld {
    name: &'static str,
    kind: WorldKind,
    options: Arc<SoccerOptions>,
}

/// Returns all worlds that this program contains.
pub(super) fn all(options: &Arc<SoccerOptions>) -> Vec<SoccerWorld> {
    let worlds = [
        ("built-in", WorldKind::BuiltIn),
        #[cfg(feature = "mujoco")]
        ("mujoco", WorldKind::Mujoco),
        ("firmware", WorldKind::BuiltIn),
    ];
    worlds.into_iter().map(|(name, kind)| SoccerWorld { name, kind, options: Arc::clone(options) }).collect()
}

impl LocalWorld for SoccerWorld {
    fn name(&self) -> &str {
        self.name
    }

    fn options(&self) -> Vec<WorldOption> {
        let (name, doc) = (ROBOTS.to_owned(), "Number of other robots".to_owned());
        vec![WorldOption { name, doc, max: MAX_ROBOTS as u64 }]
    }

    fn prepare(&self, setup: &WorldSetup) -> Result<Game, Invalid> {
        let is_firmware = self.name == "firmware";
        let size = if is_firmware { Frame::Small } else { self.options.size };
        let firmware = is_firmware.then(|| FirmwareImage::new(self.options.firmware.clone(), size));
        let mut layers = Layers::new(&GRAPH);
        if let Some(tune) = &setup.tune {
            layers.read(tune)?;
        }
        setup.set.iter().try_for_each(|assignment| layers.assign(assignment, "the page"))?;
        // Without time limit, in real time.
        let rules = Rules {
            world: self.kind,
            seed: setup.seed,
            size,
            robots: robots(&setup.options)?,
            limit: Duration::MAX,
            realtime: true,
            firmware: firmware.transpose()?,
            settings: settings(&layers)?,
            options: &[],
        };
        Ok(Box::new(move |run| Ok(play(&rules, run)?)))
    }
}

/// Reads the only option.
fn robots(options: &BTreeMap<String, String>) -> Result<usize, Failure> {
    if let Some(name) = options.keys().find(|name| *name != ROBOTS) {
        return Err(Failure::new(
            format!("no world has an option `{name}`"),
            format!("leave it out; known is `{ROBOTS}`"),
        ));
    }
    let number = options.get(ROBOTS).map_or(Some(0), |text| text.parse().ok().filter(|robots| *robots <= MAX_ROBOTS));
    let help = format!("choose 0 to {MAX_ROBOTS}");
    number.ok_or_else(|| Failure::new(format!("`{}` is no number of robots", options[ROBOTS]), help))
}

/// Plays a game until its run ends.
fn play(rules: &Rules, run: &WorldRun) -> Result<(), Failure> {
    let has_begun = Cell::new(false);
    let started = |_: &str| {
        has_begun.set(true);
        Ok(())
    };
    let address = run.address();
    let serve = ServeOptions { address: &address, anywhere: false, started: &started, pause: &|_, _| Ok(()) };
    // Images are not stored: a replay generates the same world from its rules.
    let record = RecordOptions {
        path: run.recording(),
        images: ImagePolicy::None,
        topics: Topics::None,
        split: None,
        force: true,
    };
    let result = play_controlled(rules, &mut (), &mut Control(run), Some(record), Some(serve));
    result.map(drop).or_else(|failure| {
        if has_begun.get() {
            return Err(failure);
        }
        // The world or the file cannot be created. A second attempt without a file fails only because of the world.
        let Invalid { what, help, .. } = failure.into();
        run.not_recorded(&format!("{what}: {help}"));
        play_controlled(rules, &mut (), &mut Control(run), None, Some(serve)).map(drop)
    })
}

struct Control<'a>(&'a WorldRun);

impl GameControl for Control<'_> {
    fn next(&mut self, is_over: bool) -> NextStep {
        match self.0 {
            run if run.is_ended() => NextStep::End,
            run if is_over && run.over() => NextStep::Pause,
            _ => NextStep::Cycle,
        }
    }

    fn note(&mut self) -> Option<String> {
        self.0.note()
    }

    fn recording_ended(&mut self, reason: &str) {
        self.0.not_recorded(reason);
    }
}
