//! A component that exceeds its budget while the images of a game arrive.

use std::error::Error;
use std::path::Path;
use std::thread;

use bica::{ComponentId, Tree};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{CameraId, Command, Lights};
use bica_motion::stiffness::Stiffness;
use bica_player::Forward;
use bica_player::perception::BallDetector;
use bica_player_program::emulator::{SensorsMessage, Transport, Tx};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::ToRobot;
use bica_wire::message::{ClockMode, FaultInjection, Telemetry};

use crate::session::{expect_eq, log_path, start_with_log, telemetry};

/// Number of images sent, at 30 Hz.
const IMAGES: u32 = 150;
/// Number of the image before which the delay starts.
const DELAY_START: u32 = 15;
/// Number of the image before which the delay ends.
const DELAY_END: u32 = 60;
/// Number of cycles observed. The images last longer than these cycles and the skipped ones, because the
/// microcontroller's time stands still without input.
const CYCLES: usize = 300;
/// Delay of each run, ticks of 40 ns: 25 ms, which is two and a half cycles.
const DELAY_TICKS: u32 = 625_000;
/// Time stamp of all sensor values sent. Telemetry with another time stamp has the microcontroller's time.
const NO_TIME: u64 = 0;
/// Minimum number of cycles without delay at the end.
const RECOVERED_CYCLES: usize = 50;

/// Fields of a cycle's report that are checked.
struct Cycle {
    time_us: u64,
    late_cycles: u32,
    incomplete_images: u32,
    safe_stop: bool,
    /// Whether the delayed component ran.
    delayed: bool,
}

/// Delays every run of the ball detector by 25 ms for one and a half seconds.
///
/// # Errors
/// If the skipped cycles are not counted or not logged, or if another cycle or a run is dropped.
pub(crate) fn overload(image: &Path, transport: Transport) -> Result<(), Box<dyn Error>> {
    let log = log_path(image, "overload", transport);
    let mut robot = start_with_log(image, transport, ClockMode::FreeRunning, Some(&log))?;
    let samples = samples()?;
    let (rx, tx) = robot.link().halves();
    let mut cycles = Vec::new();
    thread::scope(|scope| {
        let writer = scope.spawn(|| stream(tx, &samples).map_err(|error| error.to_string()));
        while cycles.len() < CYCLES {
            cycles.push(rx.receive(telemetry(|telemetry| Cycle::new(&telemetry)))?);
        }
        writer.join().map_err(|_| "the writer panicked")??;
        Ok::<_, Box<dyn Error>>(())
    })?;
    drop(robot);
    let late = judge(&cycles)?;
    let lines = crate::log::decode(image, &log)?;
    let count = |line: &String| line.split_once("late by ")?.1.split(' ').next()?.parse::<u32>().ok();
    let logged: u32 = lines.iter().filter(|line| line.contains("WARN")).filter_map(count).sum();
    expect_eq(&logged, &late)?;
    println!("overload: {} cycles, {late} others left out and logged", cycles.len());
    Ok(())
}

/// Returns the number of skipped cycles.
fn judge(cycles: &[Cycle]) -> Result<u32, Box<dyn Error>> {
    let delayed: Vec<usize> = (0..cycles.len()).filter(|&index| cycles[index].delayed).collect();
    let (Some(&first), Some(&last), Some(end)) = (delayed.first(), delayed.last(), cycles.last()) else {
        return Err("no run was delayed".into());
    };
    let runs = delayed.len() as u32;
    let before = first.checked_sub(1).map(|index| cycles[index].late_cycles);
    expect_eq(&before, &Some(0))?;
    if end.late_cycles < runs {
        return Err(format!("{runs} delayed runs, but only {} cycles left out", end.late_cycles).into());
    }
    let recovered = cycles.iter().rev().take_while(|cycle| cycle.late_cycles == end.late_cycles).count();
    if recovered < RECOVERED_CYCLES {
        return Err(format!("only {recovered} cycles without delay at the end").into());
    }
    // The declared rate is 30 runs in 100 periods; the delays must not change it.
    let (tenfold_runs, periods) = (10 * (runs - 1), cycles[last].period(last) - cycles[first].period(first));
    if tenfold_runs.abs_diff(3 * periods as u32) > 20 {
        return Err(format!("{runs} runs in {periods} periods: runs were dropped").into());
    }
    expect_every_cycle(cycles)?;
    expect_eq(&(cycles.iter().any(|cycle| cycle.safe_stop), cycles[first].incomplete_images), &(false, 0))?;
    if end.incomplete_images > runs {
        return Err(format!("{} incomplete images with {runs} delayed runs", end.incomplete_images).into());
    }
    Ok(end.late_cycles)
}

/// Requires one cycle per 10 ms on average; skipped cycles count.
fn expect_every_cycle(cycles: &[Cycle]) -> Result<(), Box<dyn Error>> {
    let own =
        |(index, cycle): (usize, &Cycle)| (cycle.time_us != NO_TIME).then_some((cycle.period(index), cycle.time_us));
    let own: Vec<(u64, u64)> = cycles.iter().enumerate().filter_map(own).collect();
    let (Some(first), Some(last)) = (own.first(), own.last()) else { return Err("no cycle has a time".into()) };
    expect_eq(&((last.1 - first.1 + 5_000) / 10_000), &(last.0 - first.0))
}

impl Cycle {
    fn new(telemetry: &Telemetry<'_>) -> Self {
        let ticks = telemetry.component_ticks().nth(ball_detector().index()).unwrap_or(0);
        Self {
            time_us: telemetry.time_us,
            late_cycles: telemetry.late_cycles,
            incomplete_images: telemetry.incomplete_images,
            safe_stop: telemetry.safe_stop,
            delayed: ticks >= DELAY_TICKS,
        }
    }

    /// Number of the period of the cycle at an index.
    fn period(&self, index: usize) -> u64 {
        index as u64 + u64::from(self.late_cycles)
    }
}

fn ball_detector() -> ComponentId {
    Forward::id::<BallDetector>()
}

/// Returns the sensor values of a standing robot in the first second of a game.
fn samples() -> Result<Vec<SensorsMessage>, Box<dyn Error>> {
    let mut world = KinematicWorld::new(NAO, &Setup { frame: Frame::Small, ..Setup::default() })?;
    let (targets, stiffness) = (NAO.stand, Stiffness::Stand.joints(NAO));
    let stand = Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Top };
    let mut samples = Vec::new();
    while samples.len() < 30 {
        let sensors = world.sensors();
        if sensors.image.is_some() {
            samples.push(SensorsMessage::new(NO_TIME, &sensors, 0));
        }
        world.act(&stand);
    }
    Ok(samples)
}

fn stream(tx: &mut Tx<impl std::io::Write>, samples: &[SensorsMessage]) -> Result<(), bica_wire::model::Invalid> {
    for (number, sample) in (0..IMAGES).zip(samples.iter().cycle()) {
        if number == DELAY_START || number == DELAY_END {
            let ticks = if number == DELAY_START { DELAY_TICKS } else { 0 };
            let component = ball_detector().index() as u8;
            tx.send(&ToRobot::FaultInjection(FaultInjection::Delay { component, ticks }))?;
        }
        let sensors = sample.clone().numbered(number);
        sensors.chunks().chain([sensors.message()]).try_for_each(|part| tx.send(&part))?;
    }
    Ok(())
}
