//! A recording that is played to monitors, as if its robot ran.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use bica::runner::Request;
use bica::{ComponentId, Format};
use bica_link::{Address, LinkServer, LinkShow, ServerOptions};
use bica_wire::Recordable;
use bica_wire::message::LogSource;
use bica_wire::model::{Description, Invalid};

use crate::cameras::Cameras;
use crate::error::Error;
use crate::header::Header;
use crate::recording::{RecordedCycle, Recording};
use crate::replay::check_tree;
use crate::request::RequestRecord;

/// Maximum time between two checks for messages of monitors.
const LISTEN_EVERY: Duration = Duration::from_millis(20);

/// Options for playing a recording.
#[derive(Clone, Copy, Debug)]
pub struct PlayOptions<'a> {
    /// The recording.
    pub path: &'a Path,
    /// Address at which monitors attach.
    pub address: &'a Address,
    /// Whether it may be an address that other computers reach.
    pub anywhere: bool,
    /// Recorded time for each unit of the clock's time, above 0.
    pub speed: f64,
    /// Time since the first cycle at which it begins, s.
    pub from: f64,
    /// Time since the first cycle at which it ends, s.
    pub until: f64,
    /// Whether it begins again after its end.
    pub repeats: bool,
}

/// Result of playing a recording.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Played {
    /// Number of cycles.
    pub cycles: u64,
    /// Number of passes that were begun.
    pub passes: u64,
    /// Damage at which it ends before the end of the recording; none if the file is intact.
    pub damage: Option<String>,
}

/// Plays a recording to monitors until its end, or until `goes_on`, which is called at least every 20 ms, returns false. Numbers
/// and times of cycles are the recorded ones; later passes continue them. `robot` makes the robot with the parameters of a
/// header. `started` is called with the address of the server.
///
/// # Errors
/// If the file cannot be read, is of another tree, or has no cycle in the span, or the server cannot start.
pub fn play<R: Recordable>(
    options: &PlayOptions<'_>,
    robot: impl Fn(&Header) -> Result<Box<R>, Invalid>,
    started: impl FnOnce(&str) -> Result<(), Invalid>,
    goes_on: impl Fn() -> bool,
) -> Result<Played, Invalid> {
    let mut recording = open(options.path)?;
    let first = robot(recording.header())?;
    check(recording.header(), &*first)?;
    let link = ServerOptions { anywhere: options.anywhere, ..ServerOptions::default() };
    let (server, show) = LinkServer::start_show(options.address, link, first)?;
    started(server.address())?;
    let mut playing = Playing { options, show, goes_on, next: (0, 0), played: Played::default() };
    loop {
        playing.pass(&mut recording)?;
        if playing.played.cycles == 0 && (playing.goes_on)() {
            let what = format!("`{}` has no cycle in the span", options.path.display());
            return Err(Invalid::new(what, "the command `record info FILE` shows its length"));
        }
        if !(options.repeats && (playing.goes_on)()) {
            break;
        }
        recording = open(options.path)?;
        playing.show.restart(robot(recording.header())?);
    }
    server.set_result(&recording.ending().map(crate::Ending::text).unwrap_or_default());
    Ok(playing.played)
}

fn open(path: &Path) -> Result<Recording<BufReader<File>>, Invalid> {
    Recording::open(path).map_err(|error| error.of(path))
}

/// Refuses a recording of another tree, or one whose outputs have another form: monitors get the description of this program.
fn check<R: Recordable>(header: &Header, robot: &R) -> Result<(), Invalid> {
    check_tree::<R>(header, "it is not played")?;
    let own = Description::of(&R::GRAPH).of_robot(robot);
    for (recorded, own) in header.tree.components.iter().zip(&own.components) {
        for (output, own_output) in recorded.outputs.iter().zip(&own.outputs) {
            if output.schema.is_some() && output.schema != own_output.schema {
                let what = format!("the output `{}.{}` of the recording has another form", recorded.name, output.name);
                return Err(Invalid::new(what, "play it with the program that recorded it"));
            }
        }
    }
    Ok(())
}

struct Playing<'a, R: Recordable, G> {
    options: &'a PlayOptions<'a>,
    show: LinkShow<R>,
    goes_on: G,
    /// Minimum number and minimum time, µs, of the next cycle.
    next: (u64, u64),
    played: Played,
}

impl<R: Recordable, G: Fn() -> bool> Playing<'_, R, G> {
    /// Plays the recording once.
    fn pass(&mut self, recording: &mut Recording<BufReader<File>>) -> Result<(), Invalid> {
        let (header, mut first, mut clock) = (recording.header().clone(), None, None);
        self.played.passes += 1;
        while (self.goes_on)() {
            let recorded = match recording.next_cycle() {
                Ok(Some(recorded)) => recorded,
                Ok(None) => {
                    self.texts(recording.rest());
                    break;
                }
                Err(error @ (Error::CutOff { .. } | Error::Damaged { .. })) => {
                    self.played.damage = Some(error.to_string());
                    break;
                }
                Err(error) => return Err(error.of(self.options.path)),
            };
            let instant = recorded.tick.instant;
            let t = header.seconds_since(*first.get_or_insert(instant), instant);
            if t > self.options.until {
                break;
            }
            if t < self.options.from {
                self.skip(&recorded);
                continue;
            }
            let (cycle, time_us) = (recorded.tick.cycle, header.nanoseconds(instant) / 1000);
            let (began, begin, [cycles, us]) = *clock.get_or_insert_with(|| {
                let (next_cycle, next_us) = self.next;
                (Instant::now(), t, [next_cycle.saturating_sub(cycle), next_us.saturating_sub(time_us)])
            });
            if !self.wait(began + Duration::from_secs_f64((t - begin).max(0.0) / self.options.speed)) {
                break;
            }
            self.cycle(&header, &recorded, (cycle + cycles, time_us + us));
        }
        Ok(())
    }

    /// Waits until a time; returns whether to go on.
    fn wait(&mut self, until: Instant) -> bool {
        loop {
            self.show.listen();
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return true;
            }
            thread::sleep(left.min(LISTEN_EVERY));
            if !(self.goes_on)() {
                return false;
            }
        }
    }

    /// Applies a cycle that is not shown, because the next ones need its values.
    fn skip(&mut self, recorded: &RecordedCycle) {
        for request in &recorded.requests {
            if let RequestRecord::Tree(request) = request {
                self.show.apply(request.borrow());
            }
        }
        self.values(recorded);
    }

    /// Shows a cycle with a number and a time, µs.
    fn cycle(&mut self, header: &Header, recorded: &RecordedCycle, (cycle, time_us): (u64, u64)) {
        self.show.begin(cycle, time_us);
        for request in &recorded.requests {
            match request {
                RequestRecord::Tree(request) => self.show.change(request.borrow()),
                // There is no world whose action it could be.
                RequestRecord::World { .. } | RequestRecord::Ended { .. } => {
                    self.show.log(2, LogSource::Operator, &request.describe(&header.tree));
                }
            }
        }
        self.texts(recorded);
        self.values(recorded);
        self.image(recorded);
        let tree = &recorded.tree;
        self.show.end(|component| (tree.is_active(component), tree.state(component)));
        self.next = (cycle + 1, time_us + header.period() / 1000);
        self.played.cycles += 1;
    }

    fn texts(&mut self, recorded: &RecordedCycle) {
        recorded.log.iter().for_each(|line| self.show.log(line.level, line.source, &line.text));
        recorded.events.iter().for_each(|event| self.show.event(&event.kind, &event.detail));
    }

    /// Applies outputs and, in a recording of a monitor, holds and rates.
    fn values(&mut self, recorded: &RecordedCycle) {
        for value in recorded.outputs.iter().flat_map(|record| &record.values) {
            self.show.output(value.component, value.index, &value.value);
        }
        let Some(record) = &recorded.holds else { return };
        for (index, (&hold, &hz)) in record.holds.iter().zip(&record.rates).enumerate() {
            let component = ComponentId::new(index);
            self.show.apply(Request::Hold { component, hold });
            self.show.apply(Request::Rate { component, hz });
        }
    }

    /// Shows an image of the cycle; with several cameras one camera after the other, as a running robot does.
    fn image(&mut self, recorded: &RecordedCycle) {
        let is_image = |format| matches!(format, Format::Yuyv { .. } | Format::Gray8 { .. } | Format::Rgb8 { .. });
        let (cameras, mut before) = (Cameras::default(), Vec::new());
        let images: Vec<_> = (recorded.blobs.iter().map(|stored| stored.blob()))
            .filter(|blob| is_image(blob.format))
            .map(|blob| (cameras.next_frame(blob.frame, &mut before), blob))
            .collect();
        let Some(index) = (self.show.images() as usize).checked_rem(images.len()) else { return };
        let (camera, blob) = &images[index];
        self.show.image(camera, blob);
    }
}
